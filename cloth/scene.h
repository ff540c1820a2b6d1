// What is to be simulated, apart from the garment: the body, the fabric, the forces.
#pragma once

#include <optional>

#include "cloth/fabric.h"
#include "geometry/types.h"

namespace toile {

class DistanceGrid;
struct Skeleton;

struct Scene {
  Fabric fabric;
  Vec3 gravity{0, -9.81, 0};  ///< m/s²
  /// Distance to the subject: the body and the layers that it wears. None: nothing to touch.
  const DistanceGrid* body = nullptr;
  const TriangleMesh* subject = nullptr;  ///< the same surface as triangles, facets outward
  const TriangleMesh* layers = nullptr;   ///< the layers of it alone; none: the body is bare
  const Skeleton* skeleton = nullptr;     ///< of the body; none: panels start as the pattern says
  double body_offset = 0.002;             ///< metres kept between skin and cloth
  bool self_contact = true;
  double self_gap = 0.002;  ///< metres kept between cloth and cloth
  /// Metres at least kept between this garment and the layers below. The distance grid, which is
  /// smooth, keeps `body_offset`; this is exact, and holds where their folds are sharp.
  double layer_gap = 0.001;
  /// Warp and weft strain above this meets `strain_limit_stiffening` times the fabric's stiffness.
  std::optional<double> strain_limit;
};

/// How much stiffer the cloth is beyond its strain limit. Higher holds the limit better and
/// converges slower, with its square root.
inline constexpr double strain_limit_stiffening = 20;

}  // namespace toile
