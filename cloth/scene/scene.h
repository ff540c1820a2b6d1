// What is to be simulated, apart from the garment: the body, the fabric, the forces.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "cloth/scene/constants.h"
#include "cloth/scene/fabric.h"
#include "geometry/types.h"

namespace toile {

class Collider;
struct MeshedPanel;
struct PanelMesh;
struct Skeleton;

/// What of the cloth the body keeps off.
enum class BodyContactTerm {
  none,   ///< nothing: the body is there for landmarks and attachments only
  nodes,  ///< nodes, by the smooth distance to body and layers
  faces,  ///< nodes likewise; edges and faces exactly, by the body's facets
};

struct Scene {
  Fabric fabric;                          ///< of the panels that name none
  std::map<std::string, Fabric> fabrics;  ///< of the others, by the names that they give
  Vec3 gravity{0, -9.81, 0};              ///< m/s²
  const Collider* collider = nullptr;     ///< the body and the layers that it wears; none: no body
  const Skeleton* skeleton = nullptr;     ///< of the body; none: panels start as the pattern says
  BodyContactTerm body_contact = BodyContactTerm::faces;
  double body_offset = 0.002;  ///< metres at least kept between skin and cloth's middle
  bool self_contact = true;
  double self_gap = 0.002;  ///< metres at least kept between the middles of cloth and cloth
  /// Metres at least kept between this garment and the layers below. The distance grid, which is
  /// smooth, keeps `body_offset`; this is exact, and holds where their folds are sharp.
  double layer_gap = 0.001;
  /// Most that warp and weft lengthen, a fraction, where anything gives way for that: they are held
  /// by up to `max_limit_multiplier`. Compression has no limit: cloth buckles.
  std::optional<double> strain_limit;
  std::optional<double> shear_limit;  ///< likewise, sine of the angle that the yarns turn by
};

/// Whether the scene has a body that pushes at the cloth.
bool touches_body(const Scene& scene);
/// Whether the body keeps off the cloth's edges and faces too.
bool touches_body_exactly(const Scene& scene);
/// Whether the body wears layers that the garment is dressed over.
bool has_layers(const Scene& scene);

/// Throws Error, naming `place`, for a gravity that is no number, or too weak or strong to be
/// meant.
void check_gravity(const Vec3& gravity, const std::string& place);

/// How much stiffer the cloth is beyond its limits, besides what holds it there. Higher finds that
/// sooner, and converges slower.
inline constexpr double strain_limit_stiffening = 1;
/// N/m that holds a yarn to its limit at most.
inline constexpr double max_limit_multiplier = hand_pull;

/// The fabric of a panel. Throws Error when the scene has none of that name.
const Fabric& fabric_of(const Scene& scene, const MeshedPanel& panel);

/// Metres from the skin to the middle of the cloth: half the thickest fabric of the garment and
/// 1 mm of air, but no less than the scene's.
double body_offset_of(const Scene& scene, const PanelMesh& garment);

/// Metres between the middles of two layers of cloth: the thickest fabric's thickness, but no less
/// than the scene's.
double self_gap_of(const Scene& scene, const PanelMesh& garment);

}  // namespace toile
