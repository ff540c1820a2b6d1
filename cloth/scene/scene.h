// The scene of a garment: the body, the fabrics, the forces.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "cloth/scene/constants.h"
#include "cloth/scene/fabric.h"
#include "geometry/types.h"

namespace toile {

class Collider;
class RaisedDistances;
struct MeshedPanel;
struct PanelMesh;
struct Skeleton;
struct StandingBody;

/// The parts of the cloth that the body pushes at.
enum class BodyContactTerm {
  none,   ///< none: the body only gives landmarks and attachments their places
  nodes,  ///< nodes, by the smooth distance to body and layers
  faces,  ///< nodes by the smooth distance; edges and faces exactly, by the body's facets
};

/// Everything a garment is simulated with.
struct Scene {
  Fabric fabric;                          ///< of the panels that name none
  std::map<std::string, Fabric> fabrics;  ///< of other panels, by the names that these give
  Vec3 gravity{0, -9.81, 0};              ///< m/s²
  const Collider* collider = nullptr;     ///< body and layers; null: no body
  /// Of the body with its arms raised; null: they are not kept.
  const RaisedDistances* raised_distances = nullptr;
  const Skeleton* skeleton = nullptr;  ///< null: panels start as the pattern places them
  /// The body before it came into its pose: the garment is put on there, and follows. Null: it is
  /// put on as the body is. It needs a skeleton.
  const StandingBody* standing = nullptr;
  BodyContactTerm body_contact = BodyContactTerm::faces;
  /// Metres: the height of a floor that bears what is worn; none: there is no floor. It keeps the
  /// cloth's nodes off as the body does, so it needs a body.
  std::optional<double> floor;
  double body_offset = 0.002;  ///< metres: least distance of skin and cloth's middle
  bool self_contact = true;
  double self_gap = 0.002;  ///< metres: least distance of the middles of two layers of cloth
  /// Metres: the least distance of this garment and the layers below. It is exact, and holds where
  /// folds of the layers are sharp. The smooth distance grid keeps `body_offset`.
  double layer_gap = 0.001;
  /// Largest strain of warp and weft, a fraction; none: no limit. Multipliers up to
  /// `max_limit_multiplier` hold the yarns to it. Compression has no limit: cloth buckles.
  std::optional<double> strain_limit;
  /// Largest sine of the angle by which the yarns turn against each other; none: no limit.
  std::optional<double> shear_limit;
};

/// Whether the scene has a body that pushes at the cloth.
bool touches_body(const Scene& scene);
/// Whether the body keeps off the cloth's edges and faces too.
bool touches_body_exactly(const Scene& scene);
/// Whether the body wears layers that the garment is dressed over.
bool has_layers(const Scene& scene);

/// Checks a gravity in m/s². Throws Error, naming `place`, for one that is no number or not between
/// 0.1 and 100 m/s² strong.
void check_gravity(const Vec3& gravity, const std::string& place);

/// The fabric of a panel. Throws Error when the scene has none of that name.
const Fabric& fabric_of(const Scene& scene, const MeshedPanel& panel);

/// Metres from the skin to the middle of the cloth. It is half the thickness of the garment's
/// thickest fabric and `skin_air_gap`, but at least the scene's `body_offset`. Throws Error as
/// fabric_of() does.
double body_offset_of(const Scene& scene, const PanelMesh& garment);

/// Metres between the middles of two layers of cloth. It is the thickness of the garment's thickest
/// fabric, but at least the scene's `self_gap`. Throws Error as fabric_of() does.
double self_gap_of(const Scene& scene, const PanelMesh& garment);

}  // namespace toile
