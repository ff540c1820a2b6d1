// Exact signed distances from points to a surface: the body or a sheet of cloth.
#pragma once

#include <memory>
#include <span>

#include "geometry/types.h"

namespace toile {

class TriangleTree;

/// The point of a surface closest to a query point.
struct SurfacePoint {
  double distance = 0;  ///< metres; negative inside a body or behind a sheet
  Vec3 point;           ///< on the surface
  Vec3 normal;          ///< of the closest face, edge or vertex; outward, unit length
  int triangle = 0;     ///< index into the mesh's triangles
};

/// Exact distances to a surface, through a tree of boxes. The sign comes from the angle-weighted
/// normal of the closest feature [Baerentzen & Aanaes 2005]. So the surface has to be
/// outward-oriented. Queries are const and may run in several threads at once. Building is
/// O(n log n) in the triangles, a query about O(log n). Copies share the tree.
///
/// A closed surface is a body: its distances are negative inside. An open surface is a sheet, such
/// as a dressed garment. Distances are positive before its right side and negative behind its wrong
/// side. Beyond the border, where the closest point lies on the border, they are positive.
///
/// Let r be the distance to the border. The value rises from -r behind the border through zero
/// toward r beyond it, so that the sign does not jump. It is zero `border_bevel` beyond the border,
/// or at 45 degrees where that is nearer. Its size is at most r. Where the closest point itself
/// jumps, as between two sleeves, the sign can still jump.
class SurfaceDistance {
 public:
  static constexpr double border_bevel = 0.005;  ///< metres

  /// Keeps a copy of the surface. Throws Error when it has no triangles.
  explicit SurfaceDistance(const TriangleMesh& mesh);

  SurfacePoint closest_point(const Vec3& query) const;
  /// The same distance, found faster. `hint` is the result for a point close to `query`.
  SurfacePoint closest_point(const Vec3& query, const SurfacePoint& hint) const;

  /// The same for some points that are near each other, TriangleTree::most_points at most, found
  /// faster. `found` has room for one a point.
  void closest_points(std::span<const Vec3> queries, const SurfacePoint& hint,
                      SurfacePoint* found) const;

  /// Appends the triangles that meet the box from `low` to `high` to `found`. Their order depends
  /// only on the mesh and the box.
  void triangles_in_box(const Vec3& low, const Vec3& high, std::vector<int>& found) const;

  const TriangleMesh& mesh() const;
  const TriangleTree& tree() const;  ///< of the mesh's triangles

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace toile
