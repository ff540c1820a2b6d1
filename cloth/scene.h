// What is to be simulated, apart from the garment: the body, the fabric, the forces.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "cloth/fabric.h"
#include "geometry/types.h"

namespace toile {

class DistanceGrid;
struct MeshedPanel;
struct PanelMesh;
struct Skeleton;

struct Scene {
  Fabric fabric;                          ///< of the panels that name none
  std::map<std::string, Fabric> fabrics;  ///< of the others, by the names that they give
  Vec3 gravity{0, -9.81, 0};              ///< m/s²
  /// Distance to the subject: the body and the layers that it wears. None: nothing to touch.
  const DistanceGrid* body = nullptr;
  const TriangleMesh* subject = nullptr;  ///< the same surface as triangles, facets outward
  const TriangleMesh* layers = nullptr;   ///< the layers of it alone; none: the body is bare
  const Skeleton* skeleton = nullptr;     ///< of the body; none: panels start as the pattern says
  double body_offset = 0.002;             ///< metres at least kept between skin and cloth's middle
  bool self_contact = true;
  double self_gap = 0.002;  ///< metres at least kept between the middles of cloth and cloth
  /// Metres at least kept between this garment and the layers below. The distance grid, which is
  /// smooth, keeps `body_offset`; this is exact, and holds where their folds are sharp.
  double layer_gap = 0.001;
  /// Warp and weft strain above this meets `strain_limit_stiffening` times the fabric's stiffness.
  std::optional<double> strain_limit;
};

/// Throws Error, naming `place`, for a gravity that is no number, or too weak or strong to be
/// meant.
void check_gravity(const Vec3& gravity, const std::string& place);

/// How much stiffer the cloth is beyond its strain limit. Higher holds the limit better and
/// converges slower, with its square root.
inline constexpr double strain_limit_stiffening = 20;

/// The fabric of a panel. Throws Error when the scene has none of that name.
const Fabric& fabric_of(const Scene& scene, const MeshedPanel& panel);

/// Metres from the skin to the middle of the cloth: half the thickest fabric of the garment and
/// 1 mm of air, but no less than the scene's.
double body_offset_of(const Scene& scene, const PanelMesh& garment);

/// Metres between the middles of two layers of cloth: the thickest fabric's thickness, but no less
/// than the scene's.
double self_gap_of(const Scene& scene, const PanelMesh& garment);

}  // namespace toile
