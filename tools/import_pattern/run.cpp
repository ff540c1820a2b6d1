#include "tools/import_pattern/run.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "geometry/error.h"
#include "io/json_words.h"
#include "io/output_file.h"
#include "io/text.h"
#include "pattern/check/check_pattern.h"
#include "pattern/file/pattern_file.h"
#include "pattern/import/drawing_format.h"
#include "pattern/import/repair_pattern.h"
#include "pattern/import/svg_pieces.h"
#include "pattern/import/whole_garment.h"
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

/// Grading rules beside a drawing: what a reader of them would add is said.
void note_grading_rules(const std::filesystem::path& drawing, std::vector<Remark>& remarks) {
  for (const char* extension : {".rul", ".RUL"}) {
    std::filesystem::path rules = drawing;
    rules.replace_extension(extension);
    std::error_code missing;
    if (!std::filesystem::exists(rules, missing)) continue;
    remarks.push_back({false, rules.string() + ": grading rules beside the drawing are not read; "
                                               "only sizes that the drawing has are there"});
    return;
  }
}

/// The pattern of a drawing as a file's content. What is written has to be a pattern, with remarks
/// that are for mesh-pattern to make.
std::string content_of(const ImportedPattern& pattern, const std::string& file,
                       std::vector<Remark>& remarks) {
  std::string content = readable_json(pattern_json(pattern));
  std::vector<Remark> later;
  warn_of_outlines(parse_pattern(content, file, later), remarks);
  return content;
}

/// A size as a file name.
std::string size_file(const std::string& size) {
  std::string name = valid_utf8(size);
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= ' ' || std::string("/\\:*?\"<>|").find(c) < 10) c = '_';
  }
  return name + ".json";
}

/// Numbers edges as those of the base size, where they are as many.
void number_as(const ImportedPattern& base, ImportedPattern& pattern) {
  for (ImportedPanel& panel : pattern.panels) {
    const auto same = std::ranges::find(base.panels, panel.name, &ImportedPanel::name);
    if (same != base.panels.end()) number_alike(panel.outline, same->outline);
  }
}

/// Panels that have not as many edges as those of the base size, in words; empty: all have.
std::string differing_panels(const ImportedPattern& base, const ImportedPattern& pattern) {
  std::string words;
  for (const ImportedPanel& panel : base.panels) {
    const auto same = std::ranges::find(pattern.panels, panel.name, &ImportedPanel::name);
    const std::size_t edges = panel.outline.edges.size();
    if (same != pattern.panels.end() && same->outline.edges.size() == edges) continue;
    words += (words.empty() ? "" : ", ") + shown_text(panel.name) +
             (same == pattern.panels.end() ? " is not there"
                                           : " has " + std::to_string(same->outline.edges.size()) +
                                                 " edges, not " + std::to_string(edges));
  }
  return words;
}

}  // namespace

ImportedFile import_drawing(const std::string& text, const std::string& name,
                            const std::string& output, const ImportPatternSettings& settings) {
  const DrawingFormat format = drawing_format(text, name);
  const char* formats[] = {"dxf", "svg", "json"};
  ImportedFile imported;
  imported.format = formats[static_cast<int>(format)];
  std::string& content = imported.text;
  std::vector<Remark>& remarks = imported.remarks;
  ImportEnd& end = imported.end;
  if (format == DrawingFormat::json) {
    if (!settings.of_drawings.empty()) {
      throw Error(name, "is a pattern; " + settings.of_drawings.front() + " is for a drawing",
                  "leave it out");
    }
    content = repaired_pattern(text, name, remarks);
    const Pattern pattern = parse_pattern(content, name, remarks);
    imported.panels = pattern.panels.size();
    warn_of_outlines(pattern, remarks);
    remarks.push_back({false, name + ": is a pattern already; it is written " +
                                  (content == text ? "as it is" : "with these repairs")});
  } else {
    end.drawing = read_drawing(format, text, name, settings.drawn);
    end.pattern = import_pieces(end.drawing, settings.pieces, remarks);
    if (settings.makes_whole && std::ranges::none_of(end.drawing.pieces, &Piece::is_panel)) {
      const ImportOptions whole = whole_garment(end.pattern, settings.pieces);
      const bool is_half = whole.unfold != settings.pieces.unfold;
      if (is_half || whole.pairs != settings.pieces.pairs) {
        try {
          std::vector<Remark> said;
          end.pattern = import_pieces(end.drawing, whole, said);
          remarks = std::move(said);
          end.is_half_garment = is_half;
        } catch (const Error&) {
          // A guess that can't be drawn was none.
        }
      }
    }
    content = content_of(end.pattern, output, remarks);
    imported.panels = end.pattern.panels.size();
  }
  return imported;
}

ImportEnd run_import_pattern(const ImportPatternSettings& settings, const CommonSettings& common) {
  const std::string name = settings.drawing.string();
  auto [content, format, panels, remarks, end] =
      import_drawing(read_file(settings.drawing), name, common.output.string(), settings);
  if (format != "json") note_grading_rules(settings.drawing, remarks);
  say_remarks(remarks, common);
  say_panels(end.pattern, common);
  common.say(std::to_string(panels) + " panels");
  OutputFiles files;
  write_file(files.at(common.output), content);
  write_report(files, common, import_pattern_json(name, format, end.drawing, end.pattern, remarks));
  files.commit();
  return end;
}

bool import_all_sizes(const ImportPatternSettings& settings, const CommonSettings& common) {
  const std::string name = settings.drawing.string();
  const std::string text = read_file(settings.drawing);
  const DrawingFormat format = drawing_format(text, name);
  if (format == DrawingFormat::json) {
    throw Error(name, "is a pattern; --all-sizes is for a drawing", "leave it out");
  }
  const PieceDrawing drawing = read_drawing(format, text, name, settings.drawn);
  std::vector<Remark> remarks;
  const ImportedPattern base = import_pieces(drawing, settings.pieces, remarks);
  if (base.sizes.empty()) throw Error(name, "its pieces state no size", "leave --all-sizes out");
  note_grading_rules(settings.drawing, remarks);
  std::filesystem::create_directories(common.output);
  OutputFiles files;
  bool all_read = true;
  nlohmann::ordered_json sizes = nlohmann::ordered_json::array();
  for (const std::string& size : base.sizes) {
    ImportPatternSettings of_size = settings;
    of_size.pieces.size = size;
    // What holds for all sizes was said of the base size.
    std::vector<Remark> said;
    ImportedPattern pattern;
    try {
      pattern = import_pieces(drawing, of_size.pieces, said);
    } catch (const Error& error) {
      all_read = false;
      remarks.push_back(
          {true, std::string(error.what()) + "; there is no pattern of size " + in_quotes(size)});
      sizes.push_back(
          {{"size", valid_utf8(size)}, {"file", ""}, {"panels", 0}, {"as_base_size", false}});
      continue;
    }
    number_as(base, pattern);
    const std::filesystem::path file = common.output / size_file(size);
    write_file(files.at(file), content_of(pattern, file.string(), said));
    const std::string differ = differing_panels(base, pattern);
    std::string place = name;
    place.append(": size ").append(in_quotes(size)).append(": ");
    for (const LeftOutPiece& piece : pattern.left_out) {
      all_read = false;
      remarks.push_back(
          {true, std::string(place).append(piece.error.what()).append("; the piece is left out")});
    }
    if (!differ.empty()) {
      remarks.push_back({true, std::string(place)
                                   .append("edges are not numbered as in the base size: ")
                                   .append(differ)});
    }
    sizes.push_back({{"size", valid_utf8(size)},
                     {"file", file.filename().string()},
                     {"panels", pattern.panels.size()},
                     {"as_base_size", differ.empty()}});
  }
  say_remarks(remarks, common);
  common.say(std::to_string(base.sizes.size()) + " sizes");
  auto report = import_pattern_json(name, format == DrawingFormat::dxf ? "dxf" : "svg", drawing,
                                    base, remarks);
  report["all_sizes"] = std::move(sizes);
  write_report(files, common, report);
  files.commit();
  return all_read;
}

}  // namespace toile
