#include "tools/ease_map/maps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cloth/ease/mean_curvature.h"
#include "cloth/scene/constants.h"
#include "cloth/scene/fabric.h"
#include "io/text.h"
#include "tools/ease_map/findings.h"
#include "tools/ease_map/numbers.h"

namespace toile {

namespace {

/// Share of the points that a scale holds.
constexpr double scale_share = 0.995;

/// The least end of a scale: values below a tenth of it are within their error. Of strain a
/// fraction, of tension N/m, of pressure Pa.
constexpr double least_strain = 0.05;
constexpr double least_tension = 20;
constexpr double least_pressure = 500;

/// A round end for values up to `high`; `limit` where they go beyond that.
double scale_end(double high, double least, double limit) {
  return high >= limit ? limit : std::min(limit, round_up(std::max(high, least)));
}

/// A quantity of the triangles at each material point, weighted with their areas.
std::vector<double> at_points(const EaseReport& report, double TriangleLoad::*quantity) {
  const DressedGarment& garment = report.garment;
  std::vector<double> sums(garment.flat.size(), 0);
  std::vector<double> areas(garment.flat.size(), 0);
  for (std::size_t t = 0; t < garment.flat_triangles.size(); ++t) {
    const TriangleLoad& load = report.loads->triangles[t];
    for (const int point : garment.flat_triangles[t]) {
      sums[point] += load.area * (load.*quantity);
      areas[point] += load.area;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (areas[i] > 0) sums[i] /= areas[i];
  }
  return sums;
}

std::vector<double> grain_at_points(const EaseReport& report) {
  const DressedGarment& garment = report.garment;
  std::vector<Vec3> sums(garment.flat.size(), Vec3::Zero());
  for (std::size_t t = 0; t < garment.flat_triangles.size(); ++t) {
    const TriangleLoad& load = report.loads->triangles[t];
    for (const int point : garment.flat_triangles[t]) sums[point] += load.area * load.warp;
  }
  std::vector<double> degrees;
  for (const Vec3& warp : sums) {
    TriangleLoad mean;
    mean.warp = warp.norm() > 0 ? Vec3(warp.normalized()) : warp;
    degrees.push_back(mean.grain_from_plumb());
  }
  return degrees;
}

std::vector<double> scaled(std::vector<double> values, double by) {
  for (double& value : values) value *= by;
  return values;
}

/// `values` of the nodes, times `by`, at each point.
std::vector<double> spread(const std::vector<int>& node_of, const std::vector<double>& values,
                           double by = 1) {
  std::vector<double> points;
  points.reserve(node_of.size());
  for (const int node : node_of) points.push_back(by * values[node]);
  return points;
}

/// The stretch of the fabric that yields least at which a hand's pull is reached; a fraction.
double limit_of(const EaseReport& report, double Fabric::*modulus) {
  double limit = std::numeric_limits<double>::infinity();
  for (const UsedFabric& used : report.dressing->fabrics) {
    limit = std::min(limit, hand_pull / (used.fabric.*modulus));
  }
  return limit;
}

/// A bar from slack to `limit`, or to a rounder end where no value gets near it. What is beyond the
/// limit is almost black.
ColourBar load_bar(const std::string& title, double end, double limit, const std::string& beyond) {
  ColourBar bar{title, warm_ramp(end)};
  if (end >= limit) {
    bar.ramp.above = beyond_colour();
    bar.above = beyond;
  }
  return bar;
}

class MapMaker {
 public:
  explicit MapMaker(const EaseReport& report)
      : report_(report), node_of_(nodes_of_points(report.garment)) {}

  std::vector<PageMap> maps() {
    add_ease();
    if (report_.loads) {
      add_strain("warp", &TriangleLoad::strain_warp, limit_of(report_, &Fabric::stretch_warp));
      add_strain("weft", &TriangleLoad::strain_weft, limit_of(report_, &Fabric::stretch_weft));
      add_strain("bias", &TriangleLoad::strain_bias,
                 std::max(limit_of(report_, &Fabric::stretch_warp),
                          limit_of(report_, &Fabric::stretch_weft)));
      add_tension();
      add_pressure();
    }
    add_contact();
    if (report_.loads) add_grain();
    add_curvature();
    return std::move(maps_);
  }

 private:
  PageMap& add(const std::string& tab, const std::string& name, const std::string& unit,
               std::vector<double> values, ColourBar bar, const std::string& meaning) {
    PageMap map;
    map.tab = tab;
    map.name = name;
    map.unit = unit;
    map.values = std::move(values);
    map.bar = std::move(bar);
    map.meaning = meaning;
    return maps_.emplace_back(std::move(map));
  }

  void add_ease() {
    EaseScale scale = ease_scale(report_);
    add("Ease", "", "", std::move(scale.points), std::move(scale.bar),
        report_.loads
            ? "Orange touches the skin and is stretched, white touches at its own length, blue "
              "stands off."
            : "White touches the skin, blue stands off.");
    PageMap gap;
    gap.reading = "gap";
    gap.unit = "mm";
    gap.values = spread(node_of_, report_.map.node_gaps, 1000);
    maps_.push_back(std::move(gap));
  }

  void add_strain(const std::string& yarns, double TriangleLoad::*quantity, double limit) {
    std::vector<double> values = scaled(at_points(report_, quantity), 100);
    const double end = scale_end(scale_high(values), 100 * least_strain, 100 * limit);
    ColourBar bar{"Strain along the " + yarns + ", %", two_sided_ramp(end, false)};
    bar.ramp.below = bar.ramp.steps.front();
    if (end >= 100 * limit) {
      bar.ramp.above = beyond_colour();
      bar.above = "beyond a hand's pull";
    }
    PageMap& map =
        add("Strain", yarns, "%", std::move(values), std::move(bar),
            "White is cloth at its own length. Blue is pushed together, orange is stretched. A "
            "hand's pull stretches it by " +
                fixed_number(100 * limit, 0) + " %.");
    map.reading = "strain, " + yarns;
  }

  void add_tension() {
    std::vector<double> values = at_points(report_, &TriangleLoad::tension_most);
    const double end = scale_end(scale_high(values), least_tension, hand_pull);
    PageMap& map =
        add("Tension", "", "N/m", std::move(values),
            load_bar("Larger principal tension, N/m", end, hand_pull, "more than a hand's pull"),
            "Pull in the cloth for each metre of its width. A hand's pull is " +
                fixed_number(hand_pull, 0) + " N/m.");
    map.reading = "tension";
    map.decimals = 0;
  }

  void add_pressure() {
    std::vector<double> of_nodes;
    for (const NodeLoad& load : report_.loads->nodes) of_nodes.push_back(load.pressure);
    std::vector<double> values = spread(node_of_, of_nodes, 0.001);
    const double end = scale_end(scale_high(values), least_pressure / 1000, hard_pressure / 1000);
    PageMap& map = add("Pressure", "", "kPa", std::move(values),
                       load_bar("Pressure on the skin, kPa", end, hard_pressure / 1000, "hard"),
                       "What the cloth presses on the skin. More than " +
                           fixed_number(hard_pressure / 1000, 1) + " kPa is hard for daily wear.");
    map.reading = "pressure";
    map.decimals = 2;
  }

  void add_contact() {
    std::vector<double> of_nodes;
    for (std::size_t n = 0; n < report_.map.node_gaps.size(); ++n) {
      const bool touches = report_.loads ? report_.loads->nodes[n].touches
                                         : report_.map.node_gaps[n] < report_.options.contact;
      of_nodes.push_back(touches ? 1 : 0);
    }
    ColourBar bar{"Contact", cool_ramp(1), "", "", {{0.0, "clear of the skin"}, {1.0, "touches"}}};
    add("Contact", "", "", spread(node_of_, of_nodes), std::move(bar),
        "Cloth that is nearer to the skin than " + mm(report_.options.contact) + " mm touches it.");
  }

  void add_grain() {
    PageMap& map = add("Grain", "", "\xC2\xB0", grain_at_points(report_),
                       ColourBar{"Warp against the vertical, degrees", magnitude_ramp(0, 90)},
                       "How far the warp leans from the vertical as worn.");
    map.reading = "grain";
    map.decimals = 0;
  }

  void add_curvature() {
    std::vector<double> values =
        spread(node_of_, mean_curvatures({report_.garment.points, report_.garment.triangles}));
    std::vector<double> sizes = values;
    for (double& size : sizes) size = std::abs(size);
    const double end = round_up(std::max(10.0, scale_high(sizes)));
    ColourBar bar{"Mean curvature, 1/m", two_sided_ramp(end, false)};
    bar.ramp.below = bar.ramp.steps.front();
    PageMap& map = add("Curvature", "", "1/m", std::move(values), std::move(bar),
                       "Folds: orange bulges outwards, blue inwards.");
    map.reading = "curvature";
    map.decimals = 0;
  }

  const EaseReport& report_;
  std::vector<int> node_of_;
  std::vector<PageMap> maps_;
};

}  // namespace

double scale_high(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto at = values.begin() +
                  static_cast<std::ptrdiff_t>(scale_share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

std::vector<int> nodes_of_points(const DressedGarment& garment) {
  std::vector<int> nodes(garment.flat.size(), 0);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) nodes[garment.flat_triangles[t][k]] = garment.triangles[t][k];
  }
  return nodes;
}

EaseScale ease_scale(const EaseReport& report) {
  const std::vector<int> node_of = nodes_of_points(report.garment);
  const double contact = report.options.contact;
  const double top = std::max(report.top, contact + 0.001);
  EaseScale scale;
  std::vector<double> stretch(node_of.size(), 0);
  double most = 0;  // stretch at -1
  if (report.loads) {
    const std::vector<double> warp = at_points(report, &TriangleLoad::strain_warp);
    const std::vector<double> weft = at_points(report, &TriangleLoad::strain_weft);
    std::vector<double> touching;
    for (std::size_t i = 0; i < node_of.size(); ++i) {
      stretch[i] = std::max({0.0, warp[i], weft[i]});
      if (report.map.node_gaps[node_of[i]] < contact) touching.push_back(stretch[i]);
    }
    const double limit =
        std::max(limit_of(report, &Fabric::stretch_warp), limit_of(report, &Fabric::stretch_weft));
    most = scale_end(scale_high(std::move(touching)), least_strain, limit);
  }
  scale.nodes.assign(report.garment.points.size(), 1);
  for (std::size_t i = 0; i < node_of.size(); ++i) {
    const double gap = report.map.node_gaps[node_of[i]];
    double value = 0;
    if (gap < 0) {
      value = -2;
    } else if (gap >= contact) {
      value = std::min(1.0, (gap - contact) / (top - contact));
    } else if (most > 0) {
      value = -std::min(1.0, stretch[i] / most);
    }
    scale.points.push_back(value);
    scale.nodes[node_of[i]] = std::min(scale.nodes[node_of[i]], value);
  }
  scale.bar.title = report.loads
                        ? "Ease: stretch of cloth that touches, gap of cloth that stands off"
                        : "Gap between cloth and skin";
  scale.bar.ramp = report.loads ? two_sided_ramp(1, true) : cool_ramp(1);
  scale.bar.ramp.below = beyond_colour();
  scale.bar.below = "inside";
  if (report.loads) {
    for (const double part : {1.0, 0.5}) {
      const double percent = 100 * most * part;
      scale.bar.marks.push_back({-part, fixed_number(percent, percent < 10 ? 1 : 0) + " %"});
    }
  }
  scale.bar.marks.push_back({0, "touches"});
  for (const double tick : round_ticks(0, 1000 * top, 5)) {
    const double place = (tick / 1000 - contact) / (top - contact);
    if (place > 0.1) scale.bar.marks.push_back({place, fixed_number(tick, 0) + " mm"});
  }
  return scale;
}

std::vector<PageMap> ease_maps(const EaseReport& report) { return MapMaker(report).maps(); }

}  // namespace toile
