// Images of meshes by ray casting, without a display or a graphics card.
#pragma once

#include <memory>
#include <vector>

#include "geometry/types.h"
#include "io/view/colour.h"
#include "io/view/sample_grid.h"

namespace toile {

/// A mesh and its appearance in a picture. Colours come from `values` through `ramp` if there are
/// values. Otherwise they come from `triangle_colours` if there are any, and else from `colour`.
struct PictureMesh {
  TriangleMesh mesh;  ///< metres, y up
  Colour colour{0.75, 0.75, 0.75};
  std::vector<Colour> triangle_colours;  ///< one a triangle, or empty
  std::vector<double> values;            ///< one a point, or empty
  ColourRamp ramp;                       ///< used with `values`
  std::vector<int> regions;              ///< one a triangle, or empty; fine lines separate regions
  /// Metres: parts with values below the ramp also show through other meshes that cover them by
  /// less than this. Cloth that has sunk into a body is then visible.
  double shows_through = 0;
  bool framed = true;        ///< whether the view has to hold the mesh; others may be cut off
  bool inside_shown = true;  ///< whether back faces are drawn, tinted to mark the inside
};

/// A camera that looks along `forward`, with `up` up. Both have unit length and are orthogonal.
struct Camera {
  Vec3 forward = -Vec3::UnitZ();
  Vec3 up = Vec3::UnitY();
  Vec3 centre = Vec3::Zero();   ///< metres: the point in the middle of the image
  double metres_per_pixel = 0;  ///< at `centre`
  double field_of_view = 0;     ///< radians across the image's height; 0: parallel projection
};

/// Meshes ready for images from any side. Light comes from the camera's upper left. Places that
/// other surfaces enclose are darker, by ambient occlusion per point and side of the surface.
/// Normals are smooth except across sharp edges. Building is O(n log n) in the triangles. An image
/// of w x h pixels casts 4 w h rays.
class RayScene {
 public:
  /// Throws Error when no mesh has a triangle.
  explicit RayScene(std::vector<PictureMesh> meshes);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// An image of `width` x `height` pixels; empty if either is below 1.
  Image render(const Camera& camera, int width, int height) const;
  const std::vector<PictureMesh>& meshes() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace toile
