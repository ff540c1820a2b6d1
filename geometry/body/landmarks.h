// Levels and sections of a body that tailoring names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "geometry/slice.h"
#include "geometry/types.h"

namespace toile {

/// The section of the torso at a height, metres: the largest of the body's sections there, between
/// crotch and armpits. Nothing where that is not closed.
std::optional<Section> torso_section(const TriangleMesh& body, double height);

/// A level of the torso that its shape tells: "bust", "waist" or "hip".
struct TorsoLevel {
  std::string name;
  double height = 0;  ///< above the floor, metres
};

/// Bust, waist and hip of ISO 8559-1, as far as they can be told: see measure_girth_ease().
/// Cost: about 100 slices of the body.
std::vector<TorsoLevel> torso_levels(const TriangleMesh& body, const Skeleton& skeleton);

}  // namespace toile
