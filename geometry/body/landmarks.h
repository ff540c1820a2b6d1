// Levels and sections of a body that have names in tailoring.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "geometry/slice.h"
#include "geometry/types.h"

namespace toile {

/// The section of the torso at a height in metres, between crotch and armpits. It is the largest of
/// the body's sections there. Nothing if that is not closed. O(n).
std::optional<Section> torso_section(const TriangleMesh& body, double height);

/// A level of the torso that its shape defines: "bust", "waist" or "hip".
struct TorsoLevel {
  std::string name;
  double height = 0;  ///< metres above the floor
};

/// Bust, waist and hip as ISO 8559-1 defines them, in this order. At the bust the front stands out
/// the most from the straight line between waist and armpits. So a belly does not pass for a bust.
/// The foremost level within 3 cm of there counts. A chest that is nowhere rounded is measured
/// directly under the armpits. The hip is the rearmost level between crotch and waist. The waist
/// has the least girth between bust and hip, and may be missing. measure_body() finds these levels
/// in another way (trunk_levels.h). On a mannequin of 94 cm its bust is 5 mm larger [measured].
/// Empty if bust or hip can't be found. It costs about 100 slices.
std::vector<TorsoLevel> torso_levels(const TriangleMesh& body, const Skeleton& skeleton);

}  // namespace toile
