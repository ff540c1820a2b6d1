// What is wrong with a cleaned body's surface, and where.
#pragma once

#include <optional>
#include <string>

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

/// The part whose bones are nearest to `point`; none: the skeleton has no bones.
BodyPart part_near(const Skeleton& skeleton, const Vec3& point);

/// Where a surface crosses itself.
struct Crossings {
  int pairs = 0;          ///< of triangles
  double area_share = 0;  ///< of the surface: the triangles that cross others
  double low = 0;         ///< metres: nine of ten crossing triangles lie between low and high
  double high = 0;
  BodyPart part = BodyPart::none;  ///< the one of most crossings; none: there is no skeleton
};

/// Share of the surface. A body that crosses itself on more has a shape that no person has, and
/// what cloth does there means nothing. Limbs that press into each other cross on less.
inline constexpr double max_crossing_share = 0.02;

/// Whether a drape on a body with such crossings can be relied on. Few are as good as none.
inline bool is_usable(const std::optional<Crossings>& crossings) {
  return !crossings || crossings->area_share <= max_crossing_share;
}

/// Where `mesh`, in metres, crosses itself; nothing if it does not. Costs self_intersections().
std::optional<Crossings> crossings_of(const TriangleMesh& mesh,
                                      const std::optional<Skeleton>& skeleton);

}  // namespace toile
