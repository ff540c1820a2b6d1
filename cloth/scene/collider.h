// What a garment is dressed onto: the body, and the garments that it already wears.
#pragma once

#include <deque>

#include "geometry/distance_grid.h"
#include "geometry/surface_distance.h"
#include "geometry/types.h"

namespace toile {

/// The motionless collider surface [Zhong & Xu 2009, "Collision Detection and Response"]: the body
/// is the first layer, each garment that was dressed is a further one for the next. What is between
/// a layer and the skin, and what a freely hanging layer encloses, counts as inside.
class Collider {
 public:
  /// The body alone: closed, outward-oriented, metres. Throws Error when it has no triangles.
  /// `known`, of an earlier one of the same body, spares computing it again.
  explicit Collider(const TriangleMesh& body, const DistanceCache& known = {},
                    const DistanceGridOptions& options = {});

  /// A dressed garment becomes part of the surface; its triangles face away from the body. The
  /// references that the others return stay valid, and speak of the new surface.
  void add_layer(const TriangleMesh& garment);

  const TriangleMesh& body() const { return skin().mesh(); }
  const SurfaceDistance& skin() const { return surfaces_.front(); }
  /// Body and layers as one mesh, facets outward: the body's first, then layer by layer.
  const TriangleMesh& surface() const { return surface_; }
  /// The layers alone, as one mesh; without triangles when there are none.
  const TriangleMesh& cloth() const { return cloth_; }
  /// Signed distance to the whole surface, smoothed, at a cell's cost [see DistanceGrid].
  const DistanceGrid& grid() const { return grid_; }
  /// The same exactly, about O(log n): the least of the distances to body and layers.
  double distance(const Vec3& point) const;

 private:
  std::deque<SurfaceDistance> surfaces_;  // which stay where they are
  TriangleMesh surface_;
  TriangleMesh cloth_;
  DistanceGrid grid_;
};

}  // namespace toile
