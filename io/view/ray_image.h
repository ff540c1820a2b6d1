// Meshes seen by ray casting: no display, no graphics card.
#pragma once

#include <memory>
#include <vector>

#include "geometry/types.h"
#include "io/view/colour.h"
#include "io/view/sample_grid.h"

namespace toile {

/// A mesh as a picture shows it. Colours come from `values` through `ramp` if there are values,
/// else from `triangle_colours` if there are any, else from `colour`.
struct PictureMesh {
  TriangleMesh mesh;  ///< metres, y up
  Colour colour{0.75, 0.75, 0.75};
  std::vector<Colour> triangle_colours;  ///< one a triangle, or empty
  std::vector<double> values;            ///< one a point, or empty
  ColourRamp ramp;                       ///< used with `values`
  std::vector<int> regions;  ///< one a triangle, or empty; a fine line parts different regions
  /// What has values below the ramp also shows through other meshes that cover it by less than
  /// this, metres: cloth that has sunk into a body is the thing to see.
  double shows_through = 0;
  bool framed = true;        ///< the camera takes in the framed meshes; others may be cut off
  bool inside_shown = true;  ///< back faces are tinted, to tell inside from outside
};

/// A camera by its axes: it looks along `forward`, with `up` up. Both of unit length, orthogonal.
struct Camera {
  Vec3 forward = -Vec3::UnitZ();
  Vec3 up = Vec3::UnitY();
  Vec3 centre = Vec3::Zero();   ///< the point in the middle of the image
  double metres_per_pixel = 0;  ///< at `centre`
  double field_of_view = 0;     ///< across the image's height, radians; 0: parallel projection
};

/// Meshes made ready to be looked at from any side. Light comes from the camera's upper left, and
/// what other surfaces shut in is darker (ambient occlusion, per point and side of the surface).
/// Normals are smoothed, except across sharp edges. Building is O(n log n) in the triangles; an
/// image of w x h pixels casts 4 w h rays.
class RayScene {
 public:
  /// Throws Error when no mesh has a triangle.
  explicit RayScene(std::vector<PictureMesh> meshes);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  Image render(const Camera& camera, int width, int height) const;
  const std::vector<PictureMesh>& meshes() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace toile
