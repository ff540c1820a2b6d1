#include "pattern/panel_mesh.h"

#include <utility>

namespace toile {

DressedGarment as_dressed(const PanelMesh& garment, std::vector<Vec3> points,
                          std::vector<Triangle> triangles) {
  DressedGarment dressed;
  dressed.points = std::move(points);
  dressed.triangles = std::move(triangles);
  dressed.flat = garment.flat;
  dressed.flat_triangles = garment.triangles;
  dressed.panel_of_triangle = panel_of_triangles(garment);
  for (const MeshedPanel& panel : garment.panels) {
    dressed.panels.push_back(panel.name);
    dressed.fabrics.push_back(panel.fabric);
  }
  return dressed;
}

}  // namespace toile
