#include "tools/import_pattern/report.h"

#include <nlohmann/json.hpp>
#include <numbers>

#include "io/text.h"
#include "tools/remarks.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

nlohmann::ordered_json import_pattern_json(const std::string& file, const std::string& format,
                                           const PieceDrawing& drawing,
                                           const ImportedPattern& pattern,
                                           const std::vector<Remark>& remarks) {
  Json report;
  report["drawing"] = file;
  report["format"] = format;
  report["pieces"] = drawing.pieces.size();
  report["size"] = valid_utf8(pattern.size);
  report["sizes"] = Json::array();
  for (const std::string& size : pattern.sizes) report["sizes"].push_back(valid_utf8(size));
  report["panels"] = Json::array();
  for (const ImportedPanel& panel : pattern.panels) {
    Json entry = {{"name", panel.name},
                  {"piece", valid_utf8(panel.piece)},
                  {"area_cm2", 1e4 * panel.area},
                  {"edges", panel.outline.edges.size()},
                  {"notches", panel.outline.notches.size()},
                  {"internal_lines", panel.internal_lines.size()},
                  {"cut_outs", panel.cut_outs.size()},
                  {"drill_holes", panel.drill_holes.size()},
                  {"quantity", panel.quantity},
                  {"material", valid_utf8(panel.material)},
                  {"turned_degrees", panel.turned * 180 / std::numbers::pi},
                  {"moved_cm", {100 * panel.moved.x(), 100 * panel.moved.y()}}};
    if (panel.grain) entry["grain_degrees"] = *panel.grain * 180 / std::numbers::pi;
    report["panels"].push_back(std::move(entry));
  }
  report["left_out"] = Json::array();
  for (const LeftOutPiece& piece : pattern.left_out) {
    report["left_out"].push_back(
        {{"piece", valid_utf8(piece.name)}, {"why", valid_utf8(piece.error.what())}});
  }
  report["ignored"] = Json::object();
  for (const auto& [what, count] : drawing.ignored) report["ignored"][valid_utf8(what)] = count;
  add_remarks(remarks, report);
  return report;
}

}  // namespace toile
