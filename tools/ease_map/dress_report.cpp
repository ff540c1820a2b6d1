#include "tools/ease_map/dress_report.h"

#include <algorithm>
#include <numbers>

#include "cloth/scene/scene.h"
#include "io/checksum.h"
#include "io/json_value.h"
#include "io/output_file.h"
#include "tools/report.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

bool is_of(const JsonValue& entry, const std::string& dressed_sha256) {
  for (const char* key : {"verdict", "dressed_sha256", "scene", "fit", "panels", "warnings"}) {
    if (!entry.find(key)) return false;
  }
  return entry.get("dressed_sha256").text() == dressed_sha256;
}

/// The garment's entry: the report itself, or one of its layers.
std::optional<JsonValue> entry_of(const JsonValue& root, const std::string& dressed_sha256) {
  if (!root.is_object()) return std::nullopt;
  const std::optional<JsonValue> layers = root.find("layers");
  if (!layers) return is_of(root, dressed_sha256) ? std::optional(root) : std::nullopt;
  if (!layers->is_array()) return std::nullopt;
  for (std::size_t i = 0; i < layers->size(); ++i) {
    const JsonValue layer = layers->item(i);
    if (layer.is_object() && is_of(layer, dressed_sha256)) return layer;
  }
  return std::nullopt;
}

/// Metres of a key in centimetres, if it is there.
std::optional<double> metres(const JsonValue& json, const char* key) {
  const auto value = json.find(key);
  return value ? std::optional<double>(value->number() / 100) : std::nullopt;
}

void read_levels(const JsonValue& entry, DressReport& report) {
  const auto levels = entry.find("levels");
  if (!levels) return;
  for (std::size_t i = 0; i < levels->size(); ++i) {
    const JsonValue json = levels->item(i);
    GarmentLevel level;
    level.name = json.get("name").text();
    level.drafted = metres(json, "drafted_height_cm");
    level.drafted_body = metres(json, "drafted_body_cm");
    level.drafted_body_error = metres(json, "plus_minus_drafted_body_cm").value_or(0);
    report.levels.push_back(std::move(level));
  }
}

/// What held the drape besides fabric, weight and skin.
std::string unknown_forces(const JsonValue& entry, bool is_layer) {
  if (entry.get("method").text() != "relaxation") {
    return "the drape was made by another method than relaxation";
  }
  if (is_layer) return "garments of an outfit press on each other";
  const auto converged = entry.find("converged");
  if (converged && !converged->flag()) return "the drape did not come to rest";
  const JsonValue terms = entry.get("scene").get("terms");
  const auto has = [&](const char* term) {
    const auto count = terms.find(term);
    return count && count->number() > 0;
  };
  if (has("strain_limit") || has("shear_limit")) {
    return "limits of strain or shear held the drape, too";
  }
  return has("attachment") ? "attachments hold a part of it" : "";
}

/// What the drape was computed with. Reports of earlier versions have no fabrics.
void read_scene(const JsonValue& entry, bool is_layer, DressReport& report) {
  const JsonValue scene = entry.get("scene");
  report.body_offset = scene.get("body_offset_mm").number() / 1000;
  const auto fabrics = scene.find("fabrics");
  if (!fabrics) return;
  for (std::size_t i = 0; i < fabrics->size(); ++i) {
    const JsonValue json = fabrics->item(i);
    const JsonValue quantities = json.get("quantities");
    UsedFabric used{fabric_from(quantities, quantities.place()), {}};
    const JsonValue panels = json.get("panels");
    for (std::size_t p = 0; p < panels.size(); ++p) used.panels.push_back(panels.item(p).text());
    report.fabrics.push_back(std::move(used));
  }
  report.body = entry.get("inputs").get("body").text();
  report.garment = entry.get("inputs").get("garment").text();
  const JsonValue gravity = scene.get("gravity_m_per_s2");
  gravity.size(3, 3);
  for (int axis = 0; axis < 3; ++axis) report.gravity[axis] = gravity.item(axis).number();
  check_gravity(report.gravity, gravity.place());
  report.unknown_forces = unknown_forces(entry, is_layer);
}

PanelRole role_of(const std::string& name) {
  for (int i = 0; i <= static_cast<int>(PanelRole::pocket); ++i) {
    if (name_of(static_cast<PanelRole>(i)) == name) return static_cast<PanelRole>(i);
  }
  return PanelRole::unknown;
}

/// `panels` are the garment's names.
Fit read_fit(const JsonValue& json, const std::vector<std::string>& panels) {
  Fit fit;
  fit.is_checked = json.get("verdict").text() != to_string(Fit());
  const JsonValue levels = json.get("levels");
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const JsonValue level = levels.item(i);
    FitLevel read{level.get("name").text(), level.get("body_cm").number() / 100,
                  level.get("as_cut_cm").number() / 100,
                  level.get("plus_minus_missing_cm").number() / 100};
    read.drafted = metres(level, "drafted_height_cm");
    read.risen = metres(level, "risen_cm").value_or(0);
    // Reports of earlier versions have none.
    const auto names = level.find("panels");
    for (std::size_t p = 0; names && p < names->size(); ++p) {
      const auto panel = std::ranges::find(panels, names->item(p).text());
      if (panel != panels.end()) read.panels.push_back(static_cast<int>(panel - panels.begin()));
    }
    fit.levels.push_back(std::move(read));
  }
  return fit;
}

}  // namespace

fs::path dress_report_path(const fs::path& garment_file) {
  return fs::path(garment_file).replace_extension("json");
}

std::optional<DressReport> read_dress_report(const fs::path& file, const fs::path& garment_file) {
  const JsonDocument document(read_file(file), file.string());
  const std::optional<JsonValue> entry = entry_of(document.root(), sha256_of_file(garment_file));
  if (!entry) return std::nullopt;
  DressReport report;
  report.verdict = entry->get("verdict").text();
  report.warnings = read_warnings(*entry);
  read_levels(*entry, report);
  read_scene(*entry, document.root().find("layers").has_value(), report);
  const JsonValue panels = entry->get("panels");
  std::vector<std::string> names;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    names.push_back(panels.item(i).get("name").text());
    const double degrees = panels.item(i).get("grain_degrees").number();
    report.grains.push_back(degrees * std::numbers::pi / 180);
    const auto worn_as = panels.item(i).get("class").find("worn_as");
    report.worn_as.push_back(worn_as ? role_of(worn_as->text()) : PanelRole::unknown);
  }
  report.fit = read_fit(entry->get("fit"), names);
  return report;
}

}  // namespace toile
