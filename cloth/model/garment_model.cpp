#include "cloth/model/garment_model.h"

#include <algorithm>

namespace toile {

std::vector<Vec3> point_positions(const Program& program, const std::vector<Vec3>& nodes,
                                  double open) {
  std::vector<Vec3> points(program.node_of_point.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    points[p] = nodes[program.node_of_point[p]];
    if (!program.offsets.empty()) points[p] += open * program.offsets[p];
  }
  return points;
}

std::vector<std::pair<std::string, int>> term_counts(const Program& program) {
  const auto count = [](auto n) { return static_cast<int>(n); };
  const Scene& scene = program.scene;
  const int triangles = count(program.triangles.size());
  int sewn = 0;
  std::vector<char> seen(program.nodes, 0);
  for (const int node : program.node_of_point) sewn += seen[node]++ == 1;
  const auto rough = [&](const std::vector<double>& frictions) {
    return count(std::count_if(frictions.begin(), frictions.end(),
                               [](double friction) { return friction > 0; }));
  };
  const int held = count(std::count_if(program.stretch.begin(), program.stretch.end(),
                                       [](const StretchTriangle& s) { return s.held; }));
  return {{"stretch", triangles},
          {"bend", count(program.bend.size())},
          {"elastic", count(program.elastics.size())},
          {"attachment", count(program.attachments.size())},
          {"seam", program.offsets.empty() ? 0 : sewn},
          {"body_contact", scene.body != nullptr ? program.nodes : 0},
          {"friction", scene.body != nullptr ? rough(program.friction_skin) : 0},
          {"self_contact", scene.self_contact ? triangles : 0},
          {"cloth_friction", scene.self_contact ? rough(program.friction_cloth) : 0},
          {"layer_contact", scene.layers != nullptr ? count(scene.layers->triangles.size()) : 0},
          {"strain_limit", scene.strain_limit ? held : 0},
          {"shear_limit", scene.shear_limit ? held : 0}};
}

}  // namespace toile
