#include "tools/ease_map/load_report.h"

#include <nlohmann/json.hpp>

#include "cloth/ease/figure_errors.h"
#include "io/text.h"
#include "tools/ease_map/numbers.h"

namespace toile {

namespace {

using LoadError = double (*)(double);

/// A load's mean and largest value with their errors, in a unit of which `scale` is one, and where
/// the largest is.
nlohmann::ordered_json load_json(const EaseReport& report, const LoadFigure& figure, double scale,
                                 LoadError mean_error, LoadError largest_error) {
  nlohmann::ordered_json json = {{"mean", rounded(figure.mean / scale)},
                                 {"plus_minus_mean", rounded(mean_error(figure.mean) / scale)}};
  if (figure.node < 0) return json;
  const Vec3& at = report.garment.points[static_cast<std::size_t>(figure.node)];
  json["largest"] = rounded(figure.largest / scale);
  json["plus_minus_largest"] = rounded(largest_error(figure.largest) / scale);
  json["at_cm"] = {rounded(100 * at.x()), rounded(100 * at.y()), rounded(100 * at.z())};
  return json;
}

nlohmann::ordered_json load_row_json(const EaseReport& report, const LoadRow& row) {
  const auto strain = [&](const LoadFigure& figure) {
    return load_json(report, figure, 0.01, strain_error, strain_error);
  };
  return {{"strain_warp_percent", strain(row.strain_warp)},
          {"strain_weft_percent", strain(row.strain_weft)},
          {"strain_bias_percent", strain(row.strain_bias)},
          {"tension_N_per_m", load_json(report, row.tension, 1, tension_error, tension_error)},
          {"pressure_kPa",
           load_json(report, row.pressure, 1000, mean_pressure_error, largest_pressure_error)},
          {"touching_percent", rounded(100 * row.touching)}};
}

}  // namespace

nlohmann::ordered_json loads_json(const EaseReport& report) {
  const Loads& loads = *report.loads;
  const auto newtons = [&](const Vec3& force) {
    return nlohmann::ordered_json{rounded(force.x()), rounded(force.y()), rounded(force.z())};
  };
  nlohmann::ordered_json json = {{"weight_N", rounded(loads.weight)},
                                 {"of_skin_N", newtons(loads.of_skin)},
                                 {"unexplained_N", rounded(loads.unexplained)},
                                 {"largest_over_cm2", rounded(1e4 * load_patch)},
                                 {"panels", nlohmann::ordered_json::array()},
                                 {"levels", nlohmann::ordered_json::array()}};
  for (const LoadRow& row : report.load_rows.panels) {
    json["panels"].push_back({{"name", valid_utf8(row.name)}});
    json["panels"].back().update(load_row_json(report, row));
  }
  for (std::size_t i = 0; i < report.load_rows.levels.size(); ++i) {
    nlohmann::ordered_json level;
    if (!report.load_rows.levels[i].name.empty()) level["level"] = report.load_rows.levels[i].name;
    level["height_cm"] = rounded(100 * report.figures.girths.rows[i].height);
    level.update(load_row_json(report, report.load_rows.levels[i]));
    json["levels"].push_back(std::move(level));
  }
  return json;
}

PageTable load_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Strain, tension and pressure: mean | largest";
  table.columns = {"",          "warp, %",       "weft, %",   "bias, %",
                   "pull, N/m", "pressure, kPa", "at height", "touches, %"};
  const auto add = [&](const LoadRow& row, int region) {
    const auto pair = [](const LoadFigure& figure, double scale, int decimals) {
      return fixed_number(figure.mean / scale, decimals) + " | " +
             fixed_number(figure.largest / scale, decimals);
    };
    const int node = row.pressure.node;
    const bool presses = node >= 0 && row.pressure.largest > 0;
    table.rows.push_back(
        {row.name, pair(row.strain_warp, 0.01, 1), pair(row.strain_weft, 0.01, 1),
         pair(row.strain_bias, 0.01, 1), pair(row.tension, 1, 0), pair(row.pressure, 1000, 2),
         presses ? cm(report.garment.points[static_cast<std::size_t>(node)].y()) : "",
         fixed_number(100 * row.touching, 0)});
    table.regions.push_back(region);
  };
  for (std::size_t i = 0; i < report.load_rows.panels.size(); ++i) {
    if (report.map.panels[i].points > 0) add(report.load_rows.panels[i], static_cast<int>(i));
  }
  for (const LoadRow& row : report.load_rows.levels) {
    if (!row.name.empty()) add(row, -1);
  }
  table.remark =
      "Each pair is the mean and the largest mean over " + fixed_number(1e4 * load_patch, 0) +
      " cm\xC2\xB2. Strain is of the cloth's inner face where it touches. Pull is the larger "
      "principal tension; the mean of a level is along it. The mean pressure is of what touches. "
      "Nine "
      "of ten values at edges of 15 mm are within 0.5 % and 0.4 of themselves (strain), 5 N/m and "
      "0.4 (pull), 0.1 kPa and 0.4 (mean pressure), 0.3 kPa and 0.5 (largest pressure).";
  return table;
}

void add_loads(const Loads& loads, MeshProperties& properties) {
  const auto of_nodes = [&](const std::string& name, const auto& value) {
    MeshProperty& property = properties.points.emplace_back();
    property.name = name;
    for (const NodeLoad& load : loads.nodes) property.values.push_back(value(load));
  };
  of_nodes("pressure_kPa", [](const NodeLoad& load) { return load.pressure / 1000; });
  of_nodes("friction_kPa", [](const NodeLoad& load) { return load.friction / 1000; });
  const auto of_triangles = [&](const std::string& name, const auto& value) {
    MeshProperty& property = properties.triangles.emplace_back();
    property.name = name;
    for (const TriangleLoad& load : loads.triangles) {
      property.values.push_back(value(load));
    }
  };
  of_triangles("strain_warp_percent", [](const auto& load) { return 100 * load.strain_warp; });
  of_triangles("strain_weft_percent", [](const auto& load) { return 100 * load.strain_weft; });
  of_triangles("strain_bias_percent", [](const auto& load) { return 100 * load.strain_bias; });
  of_triangles("tension_warp_N_per_m", [](const auto& load) { return load.tension_warp; });
  of_triangles("tension_weft_N_per_m", [](const auto& load) { return load.tension_weft; });
  of_triangles("tension_most_N_per_m", [](const auto& load) { return load.tension_most; });
  of_triangles("tension_least_N_per_m", [](const auto& load) { return load.tension_least; });
  for (int axis = 0; axis < 3; ++axis) {
    of_triangles(std::string("tension_most_") + "xyz"[axis],
                 [axis](const auto& load) { return load.direction[axis]; });
  }
  of_triangles("grain_degrees", [](const auto& load) { return load.grain_from_plumb(); });
}

}  // namespace toile
