#include "tools/ease_map/dress_report.h"

#include <numbers>

#include "io/json_value.h"
#include "io/output_file.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

/// The garment's entry: the report itself, or one of its layers.
std::optional<JsonValue> entry_of(const JsonValue& root, const fs::path& garment_file) {
  if (!root.is_object()) return std::nullopt;
  const std::optional<JsonValue> layers = root.find("layers");
  if (!layers) return root;
  if (!layers->is_array()) return std::nullopt;
  for (std::size_t i = 0; i < layers->size(); ++i) {
    const JsonValue layer = layers->item(i);
    const std::optional<JsonValue> dressed = layer.find("dressed");
    if (dressed && fs::path(dressed->text()).filename() == garment_file.filename()) return layer;
  }
  return std::nullopt;
}

bool is_of(const JsonValue& entry, const DressedGarment& garment) {
  for (const char* key : {"verdict", "garment", "scene", "fit", "panels", "warnings"}) {
    if (!entry.find(key)) return false;
  }
  const JsonValue counts = entry.get("garment");
  return counts.get("triangles").number() == static_cast<double>(garment.triangles.size()) &&
         counts.get("material_points").number() == static_cast<double>(garment.flat.size()) &&
         entry.get("panels").size() == garment.panels.size();
}

}  // namespace

fs::path dress_report_path(const fs::path& garment_file) {
  return fs::path(garment_file).replace_extension("json");
}

std::optional<DressReport> read_dress_report(const fs::path& file, const fs::path& garment_file,
                                             const DressedGarment& garment) {
  const JsonDocument document(read_file(file), file.string());
  const std::optional<JsonValue> entry = entry_of(document.root(), garment_file);
  if (!entry || !is_of(*entry, garment)) return std::nullopt;
  DressReport report;
  report.verdict = entry->get("verdict").text();
  report.fit = entry->get("fit").get("verdict").text();
  const JsonValue warnings = entry->get("warnings");
  for (std::size_t i = 0; i < warnings.size(); ++i) {
    report.warnings.push_back(warnings.item(i).text());
  }
  report.body_offset = entry->get("scene").get("body_offset_mm").number() / 1000;
  const JsonValue panels = entry->get("panels");
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double degrees = panels.item(i).get("grain_degrees").number();
    report.grains.push_back(degrees * std::numbers::pi / 180);
  }
  return report;
}

}  // namespace toile
