// Bounds on the motion of cloth that keep its triangles from meeting the body's facets.
#pragma once

#include <array>
#include <atomic>
#include <vector>

#include "cloth/scene/collider.h"
#include "geometry/adjacency.h"
#include "geometry/types.h"
#include "geometry/vec4.h"

namespace toile {

/// Bounds that keep cloth from meeting the body. Each triangle of the cloth has a region that its
/// corners must not leave.
///
/// The region is a ball around where each corner stood at the last update of the triangle. Near the
/// body it is cut by a plane that has all facets of the surroundings behind it. Where no such plane
/// leaves the triangle room, the ball is smaller than the distance to the nearest facet.
///
/// A triangle with its corners in its region meets no facet. So a cloth within its bounds never
/// comes to intersect the body. A region is convex: it contains a straight path if it contains both
/// ends.
///
/// A triangle that intersects the body, or is inside, is free, for it has to come out. It is bound
/// as soon as it is clear.
class BodyBounds {
 public:
  /// Vertices have indices in [0, `vertices`). The regions heed the facets of the collider's skin;
  /// the gradient of its grid points to the outside. The collider and `triangles` must outlive the
  /// bounds.
  BodyBounds(const Collider& collider, const std::vector<Triangle>& triangles,
             std::size_t vertices);

  /// Updates the regions that are due; at first, all are. A region is updated only every few calls.
  /// `x`: metres, one a vertex. Returns the vertices of the updated triangles, sorted. Runs in
  /// parallel; the result depends on the positions only. Linear in the regions that are due.
  const std::vector<int>& update(const Vec4s& x);

  /// Metres that a vertex at `p`, which is in its region, may move in any direction and stay there.
  /// It is the largest double where all its triangles intersect the body.
  double free_radius(int vertex, const Vec3& p) const;

  /// The share in [0, 1] of the path from `p`, which is in the region, to `wanted` that stays in
  /// the region. A region that stops the vertex, or nearly does, becomes due. `stopped_by` receives
  /// the normal of the plane that stops it; zero: none does.
  double allowed_share(int vertex, const Vec3& p, const Vec3& wanted, Vec3* stopped_by = nullptr);

  /// Metres: where the vertex comes on its way from `p`, which is in the region, to `wanted`. It
  /// slides along planes that stop it. Else cloth that is pressed to the body could not move along
  /// it. A tight cuff would stay strained on one side of the arm.
  Vec3 reached(int vertex, const Vec3& p, const Vec3& wanted);

  /// Whether the region of any triangle is due.
  bool is_due() const { return any_due_; }
  /// Makes triangles that intersect the body due, for they may have come out.
  void recheck_intersecting();

  /// Metres that a vertex has to keep from the body beyond the common offset. It is more than 0
  /// where one of its triangles spans something sharp of the body. It never shrinks.
  double extra_offset(int vertex) const { return extra_offset_[vertex]; }

 private:
  struct Region {
    Vec3 normal = Vec3::Zero();  // of the plane; zero: no plane
    double level = 0;            // metres: the least coordinate of a corner along the normal
    double slack = 0;            // metres of the lowest corner above the level, at the update
    double reach = 0;            // metres: radius of the balls around the corners
    std::array<Vec3, 3> at;      // metres: the corners at the update
    double extra_offset = 0;     // metres by which the corners should be lifted
    int facet = 0;               // index of the body's facet nearest to the triangle's middle
    bool intersects = false;     // intersects the body or is inside: no bounds
  };

  /// What a vertex has to heed of the region of one of its triangles, in a line of the cache.
  struct alignas(64) CornerBound {
    Vec4 ball;   // metres: where the corner was at the update, and the reach
    Vec4 plane;  // normal, and the level (metres); -infinity: no plane
  };

  CornerBound corner_bound(const Region& region, int corner) const;
  Region region_of(const Triangle& corners, const Vec4s& x, int near_facet,
                   std::vector<int>& near) const;
  void make_due(int triangle);

  const Collider& collider_;
  const std::vector<Triangle>& triangles_;
  Adjacency<TriangleCorner> corners_;  // per vertex
  std::vector<Region> regions_;
  std::vector<CornerBound> bounds_;            // of the corners, in the order of corners_
  std::vector<std::array<int, 3>> bounds_of_;  // per triangle, the indices of its corners there
  std::vector<char> due_;                      // per triangle
  std::vector<int> next_update_;               // per triangle, the first update it may have
  int updates_ = 0;
  std::atomic<bool> any_due_ = true;
  std::vector<double> extra_offset_;
  std::vector<int> updated_;  // vertices of the triangles of the last update
};

}  // namespace toile
