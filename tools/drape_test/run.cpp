#include "tools/drape_test/run.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "io/output_file.h"
#include "io/text.h"
#include "io/view/picture.h"
#include "tools/report.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

struct Spread {
  double mean = 0;
  double deviation = 0;  ///< standard, of one sheet
  double least = 0;
  double most = 0;
};

Spread spread_of(const std::vector<double>& values) {
  Spread spread;
  const double count = static_cast<double>(values.size());
  for (const double value : values) spread.mean += value / count;
  for (const double value : values) spread.deviation += std::pow(value - spread.mean, 2);
  spread.deviation = values.size() > 1 ? std::sqrt(spread.deviation / (count - 1)) : 0;
  spread.least = *std::ranges::min_element(values);
  spread.most = *std::ranges::max_element(values);
  return spread;
}

Json spread_json(const Spread& spread) {
  return {{"mean", spread.mean},
          {"standard_deviation", spread.deviation},
          {"least", spread.least},
          {"most", spread.most}};
}

std::string range(const Spread& spread, int decimals) {
  return fixed_number(spread.mean, decimals) + " (" + fixed_number(spread.least, decimals) +
         " to " + fixed_number(spread.most, decimals) + ")";
}

std::string picture_of(const TestDrape& drape, const std::string& title) {
  PictureMesh sheet;
  sheet.mesh = drape.mesh;
  sheet.colour = {0.45, 0.58, 0.72};
  Picture picture;
  picture.title = title;
  picture.views = {View::front, View::top};
  picture.view_width = 600;
  std::vector<PictureMesh> meshes;
  meshes.push_back(std::move(sheet));
  return picture_png(std::move(meshes), picture);
}

}  // namespace

ExitCode run_drape_test(const DrapeTestSettings& settings, const CommonSettings& common) {
  const DrapeTester tester(settings.sizes);
  std::vector<double> coefficients;
  std::vector<double> nodes;
  std::vector<double> drops;
  std::optional<TestDrape> first;
  int at_rest = 0;
  Json sheets = Json::array();
  for (int start = 1; start <= settings.starts; ++start) {
    TestDrape drape = tester.drape(settings.fabric, start);
    coefficients.push_back(100 * drape.coefficient);
    nodes.push_back(drape.nodes);
    drops.push_back(1000 * drape.drop);
    at_rest += static_cast<int>(drape.at_rest);
    sheets.push_back({{"coefficient_percent", 100 * drape.coefficient},
                      {"nodes", drape.nodes},
                      {"drop_mm", 1000 * drape.drop},
                      {"at_rest", drape.at_rest}});
    if (!first) first = std::move(drape);
  }
  const Spread coefficient = spread_of(coefficients);
  const Spread folds = spread_of(nodes);
  const Spread drop = spread_of(drops);
  common.say(valid_utf8(settings.fabric.name) + ": drape coefficient " + range(coefficient, 1) +
             " %, nodes " + range(folds, 1) + ", drop " + range(drop, 1) + " mm");
  std::vector<Warning> warnings;
  if (at_rest < settings.starts) {
    warnings.push_back({"not_at_rest", "",
                        std::to_string(settings.starts - at_rest) + " of " +
                            std::to_string(settings.starts) + " sheets did not come to rest"});
    CommonSettings::warn(warnings.back().text);
  }
  OutputFiles files;
  write_file(files.at(common.output),
             picture_of(*first, settings.fabric.name + ": drape coefficient " +
                                    fixed_number(coefficients.front(), 1) + " %, " +
                                    std::to_string(first->nodes) + " nodes"));
  write_report(files, common,
               {{"fabric", fabric_json(settings.fabric)},
                {"plate_cm", 200 * settings.sizes.plate},
                {"sheet_cm", 200 * settings.sizes.sheet},
                {"edge_length_mm", 1000 * tester.spacing()},
                {"coefficient_percent", spread_json(coefficient)},
                {"nodes", spread_json(folds)},
                {"drop_mm", spread_json(drop)},
                {"sheets", sheets},
                {"warnings", warnings_json(warnings)}});
  files.commit();
  common.say("wrote " + common.output.string());
  return at_rest == settings.starts ? exit_done : exit_negative;
}

}  // namespace toile
