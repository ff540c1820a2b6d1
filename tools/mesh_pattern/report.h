// The report of mesh-pattern, as JSON, and what is measured for it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "pattern/panel_mesh.h"
#include "pattern/pattern.h"

namespace toile {

/// What is measured on a meshed panel.
struct PanelMeasurements {
  double area = 0;            ///< square metres
  double smallest_angle = 0;  ///< radians
  double shortest_edge = 0;   ///< metres
  double longest_edge = 0;
};

PanelMeasurements measure_panel(const PanelMesh& garment, const MeshedPanel& panel);

/// `measured`: one for each panel.
nlohmann::ordered_json mesh_pattern_json(const std::string& pattern, const PanelMesh& garment,
                                         const std::vector<PanelMeasurements>& measured,
                                         const std::vector<Remark>& remarks);

}  // namespace toile
