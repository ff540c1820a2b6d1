// Bodies that lack limbs: dress forms, people without an arm or a head.
#pragma once

#include <optional>
#include <string>

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

/// How a body that lacks limbs faces, and the joints that it shows.
struct IncompleteBody {
  Skeleton skeleton;    ///< in the given body's frame; segments between joints that are there
  double degrees = 0;   ///< of the turn about y, from +z to +x, that makes it face +z
  std::string problem;  ///< what it lacks, and why
};

/// The joints of a body that stands along y, of which find_skeleton() finds none: those of
/// shown_joints(), or of a form those of torso_joints(). Nothing where there is no trunk either.
/// `body` is closed and outward-oriented, in any unit. Costs body_frame() and trunk_levels().
std::optional<IncompleteBody> incomplete_body(const TriangleMesh& body, const std::string& name);

}  // namespace toile
