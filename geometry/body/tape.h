// Lines along which a tape measure lies on a body.
#pragma once

#include <vector>

#include "geometry/slice.h"
#include "geometry/types.h"

namespace toile {

/// Metres along a polyline.
double length_of(const std::vector<Vec3>& line);

/// The part of a section between the points of it that are nearest to `a` and `b`, from `a` on. Of
/// a closed section's two parts it is the one that lies farther in the direction `toward`.
std::vector<Vec3> part_between(const Section& section, const Vec3& a, const Vec3& b,
                               const Vec3& toward);

/// The line of a tape that is pulled taut over `part` from its first point to its last. It bridges
/// what is hollow as seen from `toward`. `part` lies in a plane. O(n log n).
std::vector<Vec3> taut(const std::vector<Vec3>& part, const Vec3& toward);

/// The line of a taut tape from `a` to `b` on the skin, on the side `toward`. It lies in the plane
/// through both that holds the direction `across`. Empty where the plane does not join them. Costs
/// a slice().
std::vector<Vec3> tape_between(const TriangleMesh& mesh, const Vec3& a, const Vec3& b,
                               const Vec3& across, const Vec3& toward);

/// The closed line of a tape around a section: its convex hull, each point once.
std::vector<Vec3> tape_around(const Section& section, const Vec3& normal);

/// What of the closed line lies on the inner side of both planes, in order: `inside` points in.
struct HalfSpace {
  Vec3 origin;
  Vec3 inside;
};
std::vector<Vec3> clipped(const std::vector<Vec3>& closed_line,
                          const std::vector<HalfSpace>& spaces);

}  // namespace toile
