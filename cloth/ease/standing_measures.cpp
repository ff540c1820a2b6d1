#include "cloth/ease/standing_measures.h"

#include <algorithm>
#include <cmath>

#include "geometry/body/measures.h"
#include "geometry/slice.h"

namespace toile {

namespace {

/// Metres: joints that are found farther from the given ones say that the body is in a pose. On
/// nine standing bodies they are 3.2 cm apart at most, on two walking ones 3.8. Of sitting and
/// reaching bodies none are found. Half refuses one standing body; double tells the same of all 15.
constexpr double moved_joint = 0.06;

/// Whether the body stands as measure_body() needs it to.
bool is_standing(const BodyShape& shape, const Skeleton& skeleton) {
  if (!shape.frame.skeleton) return false;
  return std::ranges::all_of(skeleton.joints, [&](const auto& joint) {
    const auto found = shape.frame.skeleton->joints.find(joint.first);
    return found != shape.frame.skeleton->joints.end() &&
           (shape.frame.given(found->second) - joint.second).norm() < moved_joint;
  });
}

/// Metres: a girth that differs by more is another body's. Text files round a point to 1e-7 of it,
/// so half and double take the same; a hundredth refuses bodies written as STL.
constexpr double same_girth = 1e-4;

/// Whether the body has these girths in their planes.
bool are_of(const TriangleMesh& body, const BodyMeasures& measures) {
  return std::ranges::all_of(measures.girths, [&](const BodyGirth& wanted) {
    return std::ranges::any_of(slice(body, wanted.origin, wanted.normal),
                               [&](const Section& section) {
                                 return std::abs(section.girth - wanted.girth) < same_girth;
                               });
  });
}

}  // namespace

BodyMeasures standing_measures(const TriangleMesh& body, const Skeleton& skeleton) {
  if (skeleton.measures && are_of(body, *skeleton.measures)) return *skeleton.measures;
  const BodyShape shape = find_landmarks(body, "the body");
  return is_standing(shape, skeleton) ? body_measures(measure_body(shape)) : BodyMeasures();
}

}  // namespace toile
