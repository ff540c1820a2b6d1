#include "cloth/model/garment_model.h"

#include <algorithm>

#include "cloth/scene/collider.h"

namespace toile {

std::vector<Vec3> point_positions(const GarmentModel& model, const std::vector<Vec3>& nodes,
                                  const std::vector<double>& open) {
  std::vector<Vec3> points(model.node_of_point.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    points[p] = nodes[model.node_of_point[p]];
    if (!open.empty()) points[p] += open[model.node_of_point[p]] * model.offsets[p];
  }
  return points;
}

std::vector<std::pair<std::string, int>> term_counts(const GarmentModel& model) {
  const auto count = [](auto n) { return static_cast<int>(n); };
  const Scene& scene = model.scene;
  const int triangles = count(model.triangles.size());
  int sewn = 0;
  std::vector<char> seen(model.nodes, 0);
  for (const int node : model.node_of_point) sewn += seen[node]++ == 1;
  const auto rough = [&](const std::vector<double>& frictions) {
    return count(std::count_if(frictions.begin(), frictions.end(),
                               [](double friction) { return friction > 0; }));
  };
  const int limited = count(std::count_if(model.stretch.begin(), model.stretch.end(),
                                          [](const StretchTriangle& s) { return s.limited; }));
  return {
      {"stretch", triangles},
      {"bend", count(model.bend.size())},
      {"elastic", count(model.elastics.size())},
      {"attachment", count(model.attachments.size())},
      {"seam", model.offsets.empty() ? 0 : sewn},
      {"body_contact", touches_body(scene) ? model.nodes : 0},
      {"friction", touches_body(scene) ? rough(model.friction_skin) : 0},
      {"self_contact", scene.self_contact ? triangles : 0},
      {"cloth_friction", scene.self_contact ? rough(model.friction_cloth) : 0},
      {"layer_contact", has_layers(scene) ? count(scene.collider->cloth().triangles.size()) : 0},
      {"strain_limit", scene.strain_limit ? limited : 0},
      {"shear_limit", scene.shear_limit ? limited : 0}};
}

}  // namespace toile
