#include "tools/ease_map/worn_loads.h"

#include <algorithm>

#include "cloth/loads/inner_face.h"
#include "cloth/model/compile.h"
#include "geometry/error.h"
#include "io/text.h"
#include "pattern/file/garment_file.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

/// A scene with the fabrics and the gravity of the drape. They go by their numbers.
Scene scene_of(const DressReport& report, PanelMesh& garment) {
  Scene scene;
  scene.gravity = report.gravity;
  for (std::size_t i = 0; i < report.fabrics.size(); ++i) {
    scene.fabrics[std::to_string(i)] = report.fabrics[i].fabric;
  }
  for (MeshedPanel& panel : garment.panels) {
    const std::string name = valid_utf8(panel.name);
    const auto used = std::ranges::find_if(report.fabrics, [&](const UsedFabric& fabric) {
      return std::ranges::find(fabric.panels, name) != fabric.panels.end();
    });
    if (used == report.fabrics.end()) {
      throw Error("the report of dress", "has no fabric of panel '" + name + "'",
                  "dress the garment anew");
    }
    panel.fabric = std::to_string(used - report.fabrics.begin());
  }
  return scene;
}

/// Per node of the model, the dressed garment's. Throws Error where seams differ.
std::vector<int> dressed_nodes(const DressedGarment& dressed, const GarmentModel& model,
                               const fs::path& meshed) {
  std::vector<int> of_model(model.nodes, -1);
  std::vector<int> of_dressed(dressed.points.size(), -1);
  bool is_same = of_model.size() == of_dressed.size();
  for (std::size_t t = 0; is_same && t < model.node_triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const int here = model.node_triangles[t][i];
      const int there = dressed.triangles[t][i];
      if (of_model[here] < 0) of_model[here] = there;
      if (of_dressed[there] < 0) of_dressed[there] = here;
      is_same = is_same && of_model[here] == there && of_dressed[there] == here;
    }
  }
  if (!is_same || std::ranges::find(of_model, -1) != of_model.end()) {
    throw Error(meshed.string(), "has other seams than the dressed garment",
                "give the one that was dressed");
  }
  return of_model;
}

/// Leaves the seams open that stand open in the dressed garment.
void leave_open_as_dressed(PanelMesh& garment, const DressedGarment& dressed) {
  std::vector<int> node_of_point(garment.flat.size(), -1);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) node_of_point[garment.triangles[t][i]] = dressed.triangles[t][i];
  }
  garment.unsewn.assign(garment.flat.size(), 0);
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      if (node_of_point[seam.a[i]] == node_of_point[seam.b[i]]) continue;
      garment.unsewn[seam.a[i]] = garment.unsewn[seam.b[i]] = 1;
    }
  }
}

}  // namespace

std::vector<fs::path> meshed_garments_of(const fs::path& dressed, const DressReport& report) {
  return {report.garment, dressed.parent_path() / report.garment.filename()};
}

Loads worn_loads(const DressedGarment& dressed, const fs::path& meshed, const DressReport& report,
                 const SurfaceDistance& skin) {
  PanelMesh garment = read_garment(meshed);
  if (garment.triangles != dressed.flat_triangles || garment.flat != dressed.flat) {
    throw Error(meshed.string(), "is another garment than the dressed one",
                "give the one that was dressed");
  }
  garment.attachments.clear();
  leave_open_as_dressed(garment, dressed);
  const Scene scene = scene_of(report, garment);
  const GarmentModel model = compile(garment, scene, garment.placed);
  const std::vector<int> of_model = dressed_nodes(dressed, model, meshed);
  std::vector<Vec3> nodes;
  nodes.reserve(of_model.size());
  for (const int node : of_model) nodes.push_back(dressed.points[node]);
  Loads loads = measure_loads(model, nodes, skin, report.body_offset + contact_margin);
  std::vector<NodeLoad> in_order(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) in_order[of_model[n]] = loads.nodes[n];
  loads.nodes = std::move(in_order);
  return loads;
}

}  // namespace toile
