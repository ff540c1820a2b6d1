#include "toile/dress.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cloth/dressing/quality.h"
#include "io/json_value.h"
#include "io/json_words.h"
#include "library/rooms.h"
#include "tools/dress/report.h"
#include "tools/dress/run.h"
#include "tools/report.h"

namespace toile {
inline namespace library {

namespace {

DressSettings dress_settings(const DressChoices& choices) {
  const auto* quality = std::ranges::find_if(
      qualities, [&](const Quality& known) { return choices.quality == known.name; });
  if (quality == qualities.end()) {
    throw Error("quality",
                in_quotes(choices.quality) + " is none of figures, draft, standard, fine", "");
  }
  DressSettings settings;
  settings.body = "body";
  settings.skeleton = "joints";
  settings.has_floor = choices.has_floor;
  settings.method = relaxation_of(*quality);
  for (const auto& [name, fabric] : choices.fabrics) {
    settings.fabrics.of_panels.emplace(name, find_fabric(fabric));
  }
  LayerFiles layer;
  layer.garment = "garment";
  layer.fabric = find_fabric(choices.fabric);
  settings.layers = {layer};
  return settings;
}

/// What the report of a drape says of its end, beyond what the drape shows.
void read_end(const std::string& report, DressResult& result) {
  result.converged = true;
  if (report.empty()) return;
  const JsonDocument document(report, "report");
  if (const auto converged = document.root().find("converged")) {
    result.converged = converged->flag();
  }
  const auto tight = document.root().find("tight_seams");
  for (std::size_t i = 0; tight && i < tight->size(); ++i) {
    const JsonValue seam = tight->item(i);
    result.tight_seams.push_back({seam.get("name").text(), seam.get("tension_N_per_m").number(),
                                  seam.get("missing_cm").number() / 100});
  }
}

}  // namespace

Drape dress(const Garment& garment, const Body& body, const DressChoices& choices) {
  return guarded([&] {
    const DressSettings settings = dress_settings(choices);
    DressValues values{mesh_in(body.points, body.triangles, "body"), skeleton_in(body),
                       garment_in(garment)};
    if (choices.earlier) values.earlier = drape_in(*choices.earlier);
    const CommonSettings common = settings_of("dress");
    const DressedValues dressed = dress_values(std::move(values), settings, common);
    return Drape{points_out(dressed.drape.points), dressed.drape.triangles, garment,
                 points_out(dressed.started), report_text(common, dressed.report)};
  });
}

std::string judge(const Drape& drape, const Body& body) {
  return guarded([&] {
    WornLayer worn;
    Garment garment = drape.garment;
    if (!drape.started.empty()) garment.placed = drape.started;
    worn.garment = garment_in(garment);
    read_end(drape.report, worn.result);
    const std::optional<Skeleton> skeleton = skeleton_in(body);
    worn.judgement =
        toile::judge(worn.garment, drape_in(drape), skin_in(body), skeleton ? &*skeleton : nullptr,
                     {worn.result.converged, {}, worn.result.tight_seams}, nullptr);
    return json_text(judged_json(worn));
  });
}

}  // namespace library
}  // namespace toile
