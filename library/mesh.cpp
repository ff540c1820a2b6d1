#include "toile/mesh.h"

#include <nlohmann/json.hpp>

#include "library/rooms.h"
#include "pattern/constants.h"
#include "tools/mesh_pattern/report.h"
#include "tools/mesh_pattern/run.h"
#include "tools/report.h"

namespace toile {
inline namespace library {

Garment mesh(const SewingPattern& pattern, const MeshChoices& choices) {
  return guarded([&] {
    if (!(choices.edge_length > 0)) {
      throw Error("edge_length", "is not positive", "0.01 is 10 mm");
    }
    if (choices.subdivisions < -1 || choices.subdivisions > max_subdivisions) {
      throw Error("subdivisions", "is out of range",
                  "use 0 to " + std::to_string(max_subdivisions) + ", or -1");
    }
    MeshPatternSettings settings;
    settings.mesh.edge_length = choices.edge_length;
    settings.mesh.subdivisions = choices.subdivisions;
    const CommonSettings common = settings_of("mesh-pattern");
    const MeshedPattern meshed = mesh_pattern(pattern.json, pattern.name, settings);
    Garment garment = garment_out(meshed.garment);
    garment.report = report_text(
        common, mesh_pattern_json(pattern.name, meshed.garment, meshed.measured, meshed.remarks));
    return garment;
  });
}

}  // namespace library
}  // namespace toile
