// How far a point is from the body, and on which side.
#pragma once

#include <memory>

#include "geometry/types.h"

namespace toile {

/// The nearest point of the body to a query point.
struct BodyPoint {
  double distance = 0;  ///< metres; negative inside the body
  Vec3 point;           ///< on the body's surface
  Vec3 normal;          ///< outward, of unit length; of the nearest face, edge or vertex
  int triangle = 0;     ///< index into the body's triangles
};

/// Exact distances to a body surface, through an AABB tree. The sign comes from the
/// angle-weighted normal of the nearest feature [Baerentzen & Aanaes 2005], so the body has to be
/// closed and outward-oriented; the distance itself is that of any surface. Queries are const and
/// may run in several threads at once. Building is O(n log n) in the triangles, a query about O(log
/// n).
class BodyDistance {
 public:
  /// Keeps a copy of the body. Throws Error when it has no triangles.
  explicit BodyDistance(const TriangleMesh& body);
  ~BodyDistance();
  BodyDistance(BodyDistance&&) noexcept;
  BodyDistance& operator=(BodyDistance&&) noexcept;

  BodyPoint nearest(const Vec3& query) const;
  /// As nearest(), starting from an answer known to be near: faster, the same distance.
  BodyPoint nearest(const Vec3& query, const BodyPoint& hint) const;

  /// Appends the triangles that meet the box from `low` to `high`, in an order that depends only
  /// on the body and the box.
  void triangles_in_box(const Vec3& low, const Vec3& high, std::vector<int>& found) const;

  const TriangleMesh& body() const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace toile
