// How far cloth may move without meeting the body: no triangle through a facet, ever.
#pragma once

#include <array>
#include <atomic>
#include <vector>

#include "cloth/scene/collider.h"
#include "geometry/adjacency.h"
#include "geometry/types.h"
#include "geometry/vec4.h"

namespace toile {

/// For each triangle of the cloth a region that its corners must not leave: about where they were
/// when it was last looked after, and, near the body, on the outer side of a plane that has all
/// facets around behind it; where no such plane leaves it room, closer than the nearest facet. A
/// triangle with its corners in its region meets no facet, so a cloth that keeps to its bounds
/// never comes to intersect the body. The region is convex: it holds a straight way if it holds its
/// ends.
///
/// What meets the body already, or is inside, is not bound, for it has to come out; from when it is
/// clear, it is.
class BodyBounds {
 public:
  /// Vertices are numbered from 0 to `vertices`-1. The collider has to outlive the bounds; its skin
  /// bounds, its grid tells the way out.
  BodyBounds(const Collider& collider, const std::vector<Triangle>& triangles,
             std::size_t vertices);

  /// Looks after the triangles that are due, at first all, and each only now and then; `x` per
  /// vertex. Side by side; what it finds depends on the places only. Returns the vertices of those
  /// triangles, sorted.
  const std::vector<int>& update(const Vec4s& x);

  /// Metres that a vertex at `p`, in its region, may move in any direction and stay in it; without
  /// end where all its triangles meet the body.
  double free_radius(int vertex, const Vec3& p) const;

  /// The share in [0, 1] of the way from `p`, in the region, to `wanted` that stays in it. What
  /// stops the vertex is due to be looked after.
  double allowed_share(int vertex, const Vec3& p, const Vec3& wanted);

  bool is_due() const { return any_due_; }
  /// What meets the body may have come out: it is due as well.
  void recheck_intersecting();

  /// Metres that a vertex has to keep from the body beyond the offset of all, because a triangle of
  /// its own spans something sharp there, as far as is known; it only grows.
  double extra_offset(int vertex) const { return extra_offset_[vertex]; }

 private:
  struct Region {
    Vec3 normal = Vec3::Zero();  // of the plane; zero: none
    double level = 0;            // along the normal, at least
    double slack = 0;            // metres above that level when looked after, of the lowest corner
    double reach = 0;            // metres from where the corner was
    std::array<Vec3, 3> at;      // the corners
    double extra_offset = 0;     // metres that the corners should come out
    int facet = 0;               // nearest to the middle
    bool intersects = false;     // the body: no bounds
  };

  Region region_of(const Triangle& corners, const Vec4s& x, int near_facet,
                   std::vector<int>& near) const;
  void make_due(int triangle);

  const Collider& collider_;
  const std::vector<Triangle>& triangles_;
  Adjacency<TriangleCorner> corners_;  // per vertex
  std::vector<Region> regions_;
  std::vector<char> due_;         // per triangle
  std::vector<int> next_update_;  // per triangle, the first that may be again
  int updates_ = 0;
  std::atomic<bool> any_due_ = true;
  std::vector<double> extra_offset_;
  std::vector<int> updated_;  // vertices of the last look
};

}  // namespace toile
