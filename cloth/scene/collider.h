// The surface that a garment is dressed onto: the body, and the garments that it already wears.
#pragma once

#include <deque>

#include "geometry/distance_grid.h"
#include "geometry/surface_distance.h"
#include "geometry/types.h"

namespace toile {

/// The motionless collider surface [Zhong & Xu 2009, "Collision Detection and Response"]. The body
/// is the first layer, and each garment that was dressed is a further one for the next. Space
/// between a layer and the skin counts as inside. So does space that a freely hanging layer
/// encloses.
class Collider {
 public:
  /// The body alone: closed, outward-oriented, metres. `known` are grid distances computed for an
  /// earlier collider of the same body and options, which are then not computed again. Throws Error
  /// when the body has no triangles.
  explicit Collider(const TriangleMesh& body, DistanceCache known = {},
                    const DistanceGridOptions& options = {});

  /// Adds a dressed garment to the surface. Its triangles face away from the body. References
  /// returned by other members stay valid and refer to the new surface.
  void add_layer(const TriangleMesh& garment);

  const TriangleMesh& body() const { return skin().mesh(); }
  const SurfaceDistance& skin() const { return surfaces_.front(); }
  /// Body and layers as one mesh, facets outward: the body's facets first, then layer by layer.
  const TriangleMesh& surface() const { return surface_; }
  /// The layers alone as one mesh. It has no triangles when there are no layers.
  const TriangleMesh& cloth() const { return cloth_; }
  /// The smoothed signed distance to the whole surface. A query costs one grid cell [see
  /// DistanceGrid].
  const DistanceGrid& grid() const { return grid_; }
  /// Metres: the exact signed distance, the smallest of the distances to body and layers. About
  /// O(log n).
  double distance(const Vec3& point) const;

 private:
  std::deque<SurfaceDistance> surfaces_;  // the body, then layers; a deque keeps addresses
  TriangleMesh surface_;
  TriangleMesh cloth_;
  DistanceGrid grid_;
};

/// The distances to the body with its arms raised, around which garments are sewn (sew.h), kept
/// from one run to the next.
class RaisedDistances {
 public:
  virtual ~RaisedDistances() = default;
  /// What is known of that body; empty: nothing.
  virtual DistanceCache known(const TriangleMesh& raised) const = 0;
  /// Keeps what is known once the seams are closed.
  virtual void keep(const Collider& raised) const = 0;
};

}  // namespace toile
