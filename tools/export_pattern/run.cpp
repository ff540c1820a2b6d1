#include "tools/export_pattern/run.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "io/output_file.h"
#include "io/text.h"
#include "pattern/check/check_pattern.h"
#include "pattern/file/pattern_file.h"
#include "tools/remarks.h"
#include "tools/report.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

/// The output's extension in small letters, with its dot.
std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::string content_of(const Sheet& sheet, const std::string& extension) {
  if (extension == ".svg") return sheet_svg(sheet);
  return extension == ".dxf" ? sheet_dxf(sheet) : sheet_pdf(sheet);
}

nlohmann::ordered_json export_pattern_json(const std::string& pattern, const std::string& format,
                                           const Pattern& content, const Sheet& sheet,
                                           double seam_allowance,
                                           const std::vector<Remark>& remarks) {
  Json report;
  report["pattern"] = pattern;
  report["format"] = format;
  report["seam_allowance_mm"] = 1000 * seam_allowance;
  report["sheet"] = {{"width_cm", 100 * sheet.size.x()}, {"height_cm", 100 * sheet.size.y()}};
  report["panels"] = Json::array();
  for (const PatternPanel& panel : content.panels) {
    report["panels"].push_back({{"name", panel.name},
                                {"edges", panel.outline.size()},
                                {"notches", panel.notches.size()},
                                {"internal_lines", panel.internal_lines.size()},
                                {"cut_outs", panel.cut_outs.size()},
                                {"drill_holes", panel.drill_holes.size()},
                                {"quantity", panel.quantity},
                                {"material", valid_utf8(panel.material)}});
    if (!panel.left_out.empty()) {
      report["panels"].back()["left_out"] = valid_utf8(panel.left_out);
    }
  }
  report["seams"] = content.stitches.size();
  add_remarks(remarks, report);
  return report;
}

}  // namespace

void run_export_pattern(const ExportPatternSettings& settings, const CommonSettings& common) {
  std::vector<Remark> remarks;
  const Pattern pattern = read_pattern(settings.pattern, remarks);
  warn_of_outlines(pattern, remarks);
  say_remarks(remarks, common);
  const Sheet sheet = pattern_sheet(pattern, settings.sheet);
  const std::string extension = extension_of(common.output);
  OutputFiles files;
  write_file(files.at(common.output), content_of(sheet, extension));
  common.say(std::to_string(pattern.panels.size()) + " panels and " +
             std::to_string(pattern.stitches.size()) + " seams on " +
             fixed_number(sheet.size.x() * 100, 1) + " cm by " +
             fixed_number(sheet.size.y() * 100, 1) + " cm, scale 1:1");
  write_report(files, common,
               export_pattern_json(settings.pattern.string(), extension.substr(1), pattern, sheet,
                                   settings.sheet.seam_allowance, remarks));
  files.commit();
}

}  // namespace toile
