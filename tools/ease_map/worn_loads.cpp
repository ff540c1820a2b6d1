#include "tools/ease_map/worn_loads.h"

#include "cloth/loads/inner_face.h"
#include "cloth/model/compile.h"
#include "geometry/error.h"
#include "pattern/file/garment_file.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

/// A scene with the fabrics and the gravity of the drape. Its fabrics go by their panels' names.
Scene scene_of(const DressReport& report, PanelMesh& garment) {
  Scene scene;
  scene.gravity = report.gravity;
  for (MeshedPanel& panel : garment.panels) panel.fabric = panel.name;
  for (const UsedFabric& used : report.fabrics) {
    for (const std::string& panel : used.panels) scene.fabrics[panel] = used.fabric;
  }
  return scene;
}

/// The model's nodes where the dressed garment has them; `dressed_node` gets their indices there.
std::vector<Vec3> nodes_of(const DressedGarment& dressed, const GarmentModel& model,
                           std::vector<int>& dressed_node) {
  std::vector<Vec3> nodes(model.nodes, Vec3::Zero());
  dressed_node.assign(model.nodes, 0);
  for (std::size_t t = 0; t < model.node_triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const int node = dressed.triangles[t][i];
      nodes[model.node_triangles[t][i]] = dressed.points[node];
      dressed_node[model.node_triangles[t][i]] = node;
    }
  }
  return nodes;
}

}  // namespace

fs::path meshed_garment_of(const fs::path& dressed, const std::optional<fs::path>& given,
                           const DressReport& report) {
  if (given) return *given;
  std::error_code unreachable;
  if (fs::exists(report.garment, unreachable)) return report.garment;
  return dressed.parent_path() / report.garment.filename();
}

WornLoads worn_loads(const DressedGarment& dressed, const fs::path& meshed,
                     const DressReport& report, const SurfaceDistance& skin) {
  if (!report.is_relaxed) return {{}, "the drape was made by another method than relaxation"};
  if (report.has_limits) return {{}, "limits of strain or shear held the drape, too"};
  PanelMesh garment = read_garment(meshed);
  if (garment.triangles != dressed.flat_triangles || garment.flat != dressed.flat) {
    throw Error(meshed.string(), "is another garment than the dressed one",
                "give the one that was dressed");
  }
  garment.attachments.clear();
  const Scene scene = scene_of(report, garment);
  const GarmentModel model = compile(garment, scene, garment.placed);
  if (model.nodes != static_cast<int>(dressed.points.size())) {
    throw Error(meshed.string(), "has other seams than the dressed garment",
                "give the one that was dressed");
  }
  std::vector<int> dressed_node;
  const std::vector<Vec3> nodes = nodes_of(dressed, model, dressed_node);
  WornLoads worn;
  worn.loads = measure_loads(model, nodes, skin, report.body_offset + contact_margin);
  std::vector<NodeLoad> in_order(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) in_order[dressed_node[n]] = worn.loads->nodes[n];
  worn.loads->nodes = std::move(in_order);
  return worn;
}

}  // namespace toile
