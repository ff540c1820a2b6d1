#include "cloth/scene/scene.h"

#include <algorithm>

#include "cloth/scene/collider.h"
#include "geometry/error.h"
#include "pattern/panel_mesh.h"

namespace toile {

namespace {

double thickest(const Scene& scene, const PanelMesh& garment) {
  double thickness = 0;
  for (const MeshedPanel& panel : garment.panels) {
    thickness = std::max(thickness, fabric_of(scene, panel).thickness);
  }
  return thickness;
}

}  // namespace

bool touches_body(const Scene& scene) {
  return scene.collider != nullptr && scene.body_contact != BodyContactTerm::none;
}

bool touches_body_exactly(const Scene& scene) {
  return scene.collider != nullptr && scene.body_contact == BodyContactTerm::faces;
}

bool has_layers(const Scene& scene) {
  return scene.collider != nullptr && !scene.collider->cloth().triangles.empty();
}

const Fabric& fabric_of(const Scene& scene, const MeshedPanel& panel) {
  if (panel.fabric.empty()) return scene.fabric;
  const auto found = scene.fabrics.find(panel.fabric);
  if (found == scene.fabrics.end()) {
    throw Error("panel '" + panel.name + "'",
                "is cut from '" + panel.fabric + "', which is unknown",
                "give the scene that fabric");
  }
  return found->second;
}

double body_offset_of(const Scene& scene, const PanelMesh& garment) {
  return std::max(scene.body_offset, 0.5 * thickest(scene, garment) + skin_air_gap);
}

double self_gap_of(const Scene& scene, const PanelMesh& garment) {
  return std::max(scene.self_gap, thickest(scene, garment));
}

void check_gravity(const Vec3& gravity, const std::string& place) {
  constexpr double min_gravity = 0.1;  // m/s²; residuals are counted in weights
  constexpr double max_gravity = 100;
  const double size = gravity.norm();
  if (!(size >= min_gravity && size <= max_gravity)) {
    throw Error(place, "is not between 0.1 and 100 m/s² strong",
                "the earth's is 0,-9.81,0: y is up, and the body faces +z");
  }
}

}  // namespace toile
