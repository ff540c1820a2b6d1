#include "cloth/dressing/outfit_warnings.h"

#include <algorithm>
#include <map>

#include "cloth/scene/constants.h"
#include "cloth/start/placement_warnings.h"
#include "geometry/error.h"
#include "io/floor_height.h"
#include "io/text.h"

namespace toile {

namespace {

/// A line for each fabric of the garment that counts as less stiff than it is.
std::vector<Warning> softened_fabric_warnings(const PanelMesh& garment, const Scene& scene) {
  std::map<std::string, double> given;
  for (const MeshedPanel& panel : garment.panels) {
    const Fabric& fabric = fabric_of(scene, panel);
    if (fabric.stiffness_given == 0) continue;
    given[panel.fabric.empty() ? "the garment's" : "'" + panel.fabric + "'"] =
        fabric.stiffness_given;
  }
  std::vector<Warning> lines;
  lines.reserve(given.size());
  for (const auto& [name, stiffness] : given) {
    lines.push_back({"fabric_softened", name,
                     "fabric: " + name + " has a stiffness of " + fixed_number(stiffness, 0) +
                         " N/m and counts as one of " + fixed_number(max_modulus, 0) +
                         " N/m: the real fabric strains less than the report says"});
  }
  return lines;
}

}  // namespace

Warning moved_layout_warning(const LayoutMove& move, const PanelMesh& garment) {
  return {"moved_layout", "",
          "the pattern does not stand where the body does: all panels were " +
              text_of(move, garment) + ", as one piece"};
}

Warning upside_down_drawing_warning() {
  return {"upside_down_drawing", "",
          "the drawing looks upside down, for the neckline is far wider than the hem: turn it by "
          "half a turn if it is"};
}

std::vector<Warning> contradiction_warnings(const PanelMesh& garment) {
  std::vector<Warning> lines;
  lines.reserve(garment.panels.size());
  for (const MeshedPanel& panel : garment.panels) {
    if (panel.is.contradiction.empty()) continue;
    lines.push_back({"contradicting_part", panel.name,
                     "panel '" + panel.name + "': " + panel.is.contradiction +
                         "; it is taken for: " + text_of(panel.is)});
  }
  return lines;
}

std::vector<Warning> start_warnings(const PanelMesh& garment, const Scene& scene) {
  std::vector<Warning> lines;
  for (const PlacementWarning& warning : placement_warnings(garment, scene)) {
    lines.push_back({code_of(warning.kind), warning.panel, text_of(warning)});
  }
  std::ranges::copy(softened_fabric_warnings(garment, scene), std::back_inserter(lines));
  return lines;
}

Warning refused_drape_warning(const std::string& refusal) {
  return {"earlier_drape_refused", "",
          "dressed from flat panels, not from the earlier drape: " + refusal};
}

Warning continued_drape_warning() {
  return {"continued_drape", "",
          "the garment went on from an earlier drape: dressed from flat panels, without "
          "--continue, it may end otherwise"};
}

std::optional<Warning> hardest_pulled_warning(const PanelMesh& garment, const DressResult& result) {
  const int node = result.residual.hardest;
  const auto has_node = [node](const Triangle& t) { return std::ranges::find(t, node) != t.end(); };
  const auto at = std::ranges::find_if(result.triangles, has_node);
  if (node < 0 || at == result.triangles.end()) return {};
  const int panel =
      panel_of_triangles(garment)[static_cast<std::size_t>(at - result.triangles.begin())];
  const double height = result.nodes[static_cast<std::size_t>(node)].y();
  const std::string& name = garment.panels[static_cast<std::size_t>(panel)].name;
  return Warning{"unconverged", name,
                 "the garment did not come to rest: panel '" + name + "' is pulled the hardest, " +
                     floor_height(height, 1) + ", by " + number_text(result.residual.max, 2) +
                     " times the weight of a point"};
}

Warning turned_out_warning(const std::string& layer, Verdict verdict, const std::string& over) {
  return {"turned_out", layer,
          "layer " + layer + " is " + to_string(verdict) + " once its panels lie over " + over +
              ": the seams that join them to the rest have to be clear of it"};
}

Warning last_layer_warning(const std::string& layer, Verdict verdict) {
  return {"layers_not_dressed", layer,
          "layer " + layer + " is " + to_string(verdict) + ": the layers over it are not dressed"};
}

}  // namespace toile
