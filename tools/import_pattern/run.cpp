#include "tools/import_pattern/run.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "geometry/error.h"
#include "io/output_file.h"
#include "io/text.h"
#include "pattern/check/check_pattern.h"
#include "pattern/file/pattern_file.h"
#include "pattern/import/drawing_format.h"
#include "pattern/import/repair_pattern.h"
#include "pattern/import/svg_pieces.h"
#include "tools/import_pattern/report.h"
#include "tools/remarks.h"
#include "tools/report.h"

namespace toile {

namespace {

void say_panels(const ImportedPattern& pattern, const CommonSettings& common) {
  for (const ImportedPanel& panel : pattern.panels) {
    char figures[120];
    std::snprintf(figures, sizeof figures, "%3zu edges %3zu notches  %7.1f cm2  ",
                  panel.outline.edges.size(), panel.outline.notches.size(), panel.area * 1e4);
    std::string line = "  panel " + panel.name;
    line.resize(std::max<std::size_t>(line.size() + 1, 30), ' ');
    line += figures;
    line += panel.grain ? "grain " + fixed_number(*panel.grain * 180 / std::numbers::pi, 1) + " deg"
                        : "no grain";
    if (panel.quantity > 1) line += ", cut " + std::to_string(panel.quantity);
    common.say(line);
  }
}

/// The pieces of a drawing that is no JSON.
PieceDrawing read_drawing(DrawingFormat format, const std::string& text, const std::string& name,
                          const DrawingOptions& options) {
  if (format == DrawingFormat::dxf) return dxf_pieces(parse_dxf(text, name), name, options);
  return svg_pieces(text, name, options);
}

}  // namespace

ImportEnd run_import_pattern(const ImportPatternSettings& settings, const CommonSettings& common) {
  const std::string name = settings.drawing.string();
  const std::string text = read_file(settings.drawing);
  const DrawingFormat format = drawing_format(text, name);
  std::vector<Remark> remarks;
  ImportEnd end;
  std::string content = text;
  std::size_t panels = 0;
  if (format == DrawingFormat::json) {
    if (!settings.of_drawings.empty()) {
      throw Error(name, "is a pattern; " + settings.of_drawings.front() + " is for a drawing",
                  "leave it out");
    }
    content = repaired_pattern(text, name, remarks);
    const Pattern pattern = parse_pattern(content, name, remarks);
    panels = pattern.panels.size();
    warn_of_outlines(pattern, remarks);
    remarks.push_back({false, name + ": is a pattern already; it is written " +
                                  (content == text ? "as it is" : "with these repairs")});
  } else {
    end.drawing = read_drawing(format, text, name, settings.drawn);
    end.pattern = import_pieces(end.drawing, settings.pieces, remarks);
    content = readable_json(pattern_json(end.pattern));
    panels = end.pattern.panels.size();
    // What is written has to be a pattern, with remarks that are for mesh-pattern to make.
    std::vector<Remark> later;
    warn_of_outlines(parse_pattern(content, common.output.string(), later), remarks);
  }
  say_remarks(remarks, common);
  say_panels(end.pattern, common);
  common.say(std::to_string(panels) + " panels");
  OutputFiles files;
  write_file(files.at(common.output), content);
  const char* formats[] = {"dxf", "svg", "json"};
  write_report(files, common,
               import_pattern_json(name, formats[static_cast<int>(format)], end.drawing,
                                   end.pattern, remarks));
  files.commit();
  return end;
}

}  // namespace toile
