// How far a point is from a surface, the body or a sheet of cloth, and on which side.
#pragma once

#include <memory>

#include "geometry/types.h"

namespace toile {

class TriangleTree;

/// The nearest point of the surface to a query point.
struct SurfacePoint {
  double distance = 0;  ///< metres; negative inside the body, or behind a sheet
  Vec3 point;           ///< on the surface
  Vec3 normal;          ///< outward, of unit length; of the nearest face, edge or vertex
  int triangle = 0;     ///< index into the body's triangles
};

/// Exact distances to a body surface, through a tree of boxes. The sign comes from the
/// angle-weighted normal of the nearest feature [Baerentzen & Aanaes 2005], so the surface has to
/// be outward-oriented. Queries are const and may run in several threads at once.
/// Building is O(n log n) in the triangles, a query about O(log n). Copies share what was built.
///
/// A closed surface is a body: negative inside. An open one is a sheet, such as a dressed garment:
/// positive before its right side, negative behind its wrong side, and beyond its border, where the
/// nearest point lies on it, something to keep away from: positive. So that the sign does not jump
/// there, the value rises from -r behind the border through zero at `border_bevel` (or at 45
/// degrees, where that is nearer) beyond it toward r, with r the distance; its size is at most r.
/// Where the nearest point itself jumps, as between two sleeves, the sign can still jump.
class SurfaceDistance {
 public:
  static constexpr double border_bevel = 0.005;  ///< metres

  /// Keeps a copy of the surface. Throws Error when it has no triangles.
  explicit SurfaceDistance(const TriangleMesh& mesh);

  SurfacePoint closest_point(const Vec3& query) const;
  /// As closest_point(), starting from an answer known to be near: faster, the same distance.
  SurfacePoint closest_point(const Vec3& query, const SurfacePoint& hint) const;

  /// Appends the triangles that meet the box from `low` to `high`, in an order that depends only
  /// on the body and the box.
  void triangles_in_box(const Vec3& low, const Vec3& high, std::vector<int>& found) const;

  const TriangleMesh& mesh() const;
  const TriangleTree& tree() const;  ///< of its triangles

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace toile
