// Strain, tension and pressure in the files of ease-map.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "io/view/viewer_page.h"
#include "tools/ease_map/report.h"

namespace toile {

/// Of panels and levels, with the sum of what the skin does to the cloth. The report has loads.
nlohmann::ordered_json loads_json(const EaseReport& report);

/// The same as a table of the page.
PageTable load_table(const EaseReport& report);

/// Adds pressure and friction of the points, and strain, tension and grain of the triangles.
void add_loads(const Loads& loads, MeshProperties& properties);

}  // namespace toile
