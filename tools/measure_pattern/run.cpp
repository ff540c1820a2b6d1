#include "tools/measure_pattern/run.h"

#include <nlohmann/json.hpp>

#include "io/csv.h"
#include "io/output_file.h"
#include "io/text.h"
#include "pattern/check/check_pattern.h"
#include "pattern/check/left_out.h"
#include "pattern/file/pattern_file.h"
#include "pattern/measure/spec_sheet.h"
#include "tools/remarks.h"
#include "tools/report.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

namespace po = boost::program_options;

/// Metres, where the sheet states none, as is the trade's custom.
constexpr double woven_tolerance = 0.005;
constexpr double knit_tolerance = 0.015;

std::string shown_cm(const std::optional<double>& metres) {
  return metres ? fixed_number(100 * *metres, 2) : "";
}

std::string pom_csv(const std::vector<MeasuredPoint>& points) {
  std::string text = csv_line(
      {"name", "measured", "spec_cm", "actual_cm", "difference_cm", "tolerance_cm", "result"});
  for (const MeasuredPoint& point : points) {
    text += csv_line({valid_utf8(point.name), valid_utf8(point.rule), shown_cm(point.spec),
                      shown_cm(point.actual), shown_cm(point.difference()),
                      point.spec ? shown_cm(point.tolerance) : "", point.result()});
  }
  return text;
}

nlohmann::ordered_json pom_json(const MeasurePatternSettings& settings,
                                const std::vector<MeasuredPoint>& points,
                                const std::vector<Remark>& remarks) {
  Json report;
  report["pattern"] = settings.pattern.string();
  if (settings.spec) {
    report["spec"] = settings.spec->string();
    if (!settings.size.empty()) report["size"] = valid_utf8(settings.size);
  }
  report["points"] = Json::array();
  for (const MeasuredPoint& point : points) {
    Json row = {{"name", valid_utf8(point.name)}};
    const auto add = [&](const char* key, const std::optional<double>& metres) {
      if (metres) row[key] = 100 * *metres;
    };
    if (!point.rule.empty()) row["measured"] = valid_utf8(point.rule);
    add("spec_cm", point.spec);
    add("actual_cm", point.actual);
    add("difference_cm", point.difference());
    if (point.spec) row["tolerance_cm"] = 100 * point.tolerance;
    if (!point.result().empty()) row["result"] = point.result();
    report["points"].push_back(std::move(row));
  }
  add_remarks(remarks, report);
  return report;
}

}  // namespace

void add_pom_options(po::options_description& options) {
  options.add_options()("pom", po::value<std::string>(),
                        "a table of points of measure as they should be, CSV: name, spec_cm or "
                        "one column a size, and if wanted tolerance_cm, measured")(
      "knit", po::bool_switch(), "points without a tolerance have 1.5 cm, not 0.5 cm");
  if (options.find_nothrow("size", false) != nullptr) return;  // of a drawing, and of its spec
  options.add_options()("size", po::value<std::string>(), "the column of --pom that holds");
}

void check_pom_options(const po::variables_map& given, bool size_is_of_drawing) {
  for (const char* option : {"size", "knit"}) {
    if (size_is_of_drawing && option == std::string("size")) continue;
    if (!given[option].empty() && !given[option].defaulted() && given.count("pom") == 0) {
      throw po::error("--" + std::string(option) + " is for --pom, which is not given");
    }
  }
}

void read_pom_options(const po::variables_map& given, MeasurePatternSettings& settings) {
  if (given.count("pom") != 0) settings.spec = given["pom"].as<std::string>();
  if (given.count("size") != 0) settings.size = given["size"].as<std::string>();
  settings.knit = given["knit"].as<bool>();
  if (settings.spec) {
    settings.rows =
        read_spec_sheet(read_file(*settings.spec), settings.spec->string(), settings.size);
  }
}

MeasurePatternEnd run_measure_pattern(const MeasurePatternSettings& settings,
                                      const CommonSettings& common) {
  std::vector<Remark> remarks;
  const std::string text = read_file(settings.pattern);
  const std::string name = settings.pattern.string();
  const Pattern mended = without_left_out(parse_pattern(text, name, remarks), remarks);
  check_pattern(mended, remarks);
  std::vector<Remark> twice;  // said of the mended pattern
  const Pattern drawn = without_left_out(parse_drawn_pattern(text, name, twice), twice);
  const SewnPanels panels(drawn, panel_classes(mended));
  if (settings.says_remarks) say_remarks(remarks, common);
  std::vector<MeasuredPoint> points;
  if (settings.spec) {
    points = measure_to_spec(panels, settings.rows, settings.spec->string(),
                             settings.knit ? knit_tolerance : woven_tolerance);
  } else {
    points = measure_all_points(panels);
  }
  int off = 0;
  for (const MeasuredPoint& point : points) {
    std::string line = "  " + valid_utf8(point.name) + ": ";
    line += point.actual ? shown_cm(point.actual) + " cm" : "not found on this garment";
    if (point.difference()) {
      line += ", " + point.result() + " (" + shown_cm(point.spec) + " \xC2\xB1 " +
              shown_cm(point.tolerance) + " cm)";
    }
    common.say(line);
    off += static_cast<int>(!point.result().empty() && point.result() != "in tolerance");
  }
  std::optional<std::string> off_spec;
  if (off > 0) {
    off_spec = std::to_string(off) + " of " + std::to_string(points.size()) +
               " points of measure are out of tolerance or not found";
    CommonSettings::warn(*off_spec);
    remarks.push_back({true, *off_spec});
  }
  OutputFiles files;
  write_file(files.at(common.output), pom_csv(points));
  write_report(files, common, pom_json(settings, points, remarks));
  files.commit();
  return {std::move(points), std::move(off_spec)};
}

}  // namespace toile
