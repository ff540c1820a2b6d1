#include "tools/ease_map/against.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cloth/ease/figure_errors.h"
#include "geometry/parallel.h"
#include "tools/ease_map/maps.h"
#include "tools/ease_map/numbers.h"

namespace toile {

namespace {

/// Below every ramp: a value that is not told.
constexpr double not_told = -1e9;

/// The flat triangles of each panel, and its box on the flat.
struct FlatPanel {
  std::vector<int> triangles;
  Eigen::AlignedBox2d box;
};

std::vector<FlatPanel> flat_panels(const DressedGarment& garment) {
  std::vector<FlatPanel> panels(garment.panels.size());
  for (std::size_t t = 0; t < garment.flat_triangles.size(); ++t) {
    FlatPanel& panel = panels[garment.panel_of_triangle[t]];
    panel.triangles.push_back(static_cast<int>(t));
    for (const int point : garment.flat_triangles[t]) panel.box.extend(garment.flat[point]);
  }
  return panels;
}

/// A place in a flat triangle: its points and their shares.
struct FlatPlace {
  Triangle points{};
  Vec3 shares = Vec3::Zero();
};

/// The place in a panel that is nearest to `at`: within a triangle, or beside it the least.
FlatPlace find_place(const DressedGarment& garment, const FlatPanel& panel, const Vec2& at) {
  FlatPlace best;
  double least = -std::numeric_limits<double>::infinity();
  for (const int t : panel.triangles) {
    const Triangle& points = garment.flat_triangles[t];
    const Vec2& a = garment.flat[points[0]];
    const Vec2 u = garment.flat[points[1]] - a;
    const Vec2 v = garment.flat[points[2]] - a;
    const double doubled = u.x() * v.y() - u.y() * v.x();
    if (doubled == 0) continue;
    const Vec2 to = at - a;
    const double second = (to.x() * v.y() - to.y() * v.x()) / doubled;
    const double third = (u.x() * to.y() - u.y() * to.x()) / doubled;
    const Vec3 shares(1 - second - third, second, third);
    if (shares.minCoeff() <= least) continue;
    least = shares.minCoeff();
    best = {points, shares};
    if (least >= 0) break;
  }
  best.shares = best.shares.cwiseMax(0);
  best.shares /= best.shares.sum();
  return best;
}

/// Of each material point, where the other garment has the same place; none: it lacks the panel.
std::vector<std::optional<FlatPlace>> same_places(const DressedGarment& here,
                                                  const DressedGarment& there) {
  const std::vector<FlatPanel> own = flat_panels(here);
  const std::vector<FlatPanel> others = flat_panels(there);
  std::vector<int> panel_of(here.flat.size(), -1);
  for (std::size_t t = 0; t < here.flat_triangles.size(); ++t) {
    for (const int point : here.flat_triangles[t]) panel_of[point] = here.panel_of_triangle[t];
  }
  std::vector<std::optional<FlatPlace>> places(here.flat.size());
  parallel_for_items(places.size(), [&](std::size_t i) {
    if (panel_of[i] < 0) return;
    const auto named = std::ranges::find(there.panels, here.panels[panel_of[i]]);
    if (named == there.panels.end()) return;
    const FlatPanel& from = own[panel_of[i]];
    const FlatPanel& to = others[named - there.panels.begin()];
    if (to.triangles.empty()) return;
    const Vec2 share = (here.flat[i] - from.box.min()).cwiseQuotient(from.box.sizes());
    places[i] = find_place(there, to, to.box.min() + share.cwiseProduct(to.box.sizes()));
  });
  return places;
}

PageMap difference_map(const std::string& name, const std::string& unit,
                       const std::vector<double>& here, const std::vector<double>& there,
                       const std::vector<std::optional<FlatPlace>>& places,
                       const std::function<double(double)>& error) {
  PageMap map;
  map.tab = "Difference";
  map.name = name;
  map.unit = unit;
  std::vector<double> sizes;
  for (std::size_t i = 0; i < places.size(); ++i) {
    double value = not_told;
    if (places[i]) {
      double other = 0;
      for (int k = 0; k < 3; ++k) other += places[i]->shares[k] * there[places[i]->points[k]];
      const double bar = std::hypot(error(here[i]), error(other));
      if (std::abs(here[i] - other) >= bar) value = here[i] - other;
    }
    map.values.push_back(value);
    if (value != not_told) sizes.push_back(std::abs(value));
  }
  const double end = round_up(std::max(1e-3, scale_high(std::move(sizes))));
  for (double& value : map.values) {
    if (value != not_told) value = std::clamp(value, -end, end);
  }
  map.bar.title = "More here than there: " + name + ", " + unit;
  map.bar.ramp = two_sided_ramp(end, name == "gap");
  map.bar.ramp.below = oklch(0.75, 0, 0);
  map.bar.below = "within its error";
  map.meaning = "Values here less those of the other drape at the same place of the panel.";
  return map;
}

/// The figure of `all` with that name; null: there is none.
template <typename Figure>
const Figure* same(const std::vector<Figure>& all, const std::string& name) {
  const auto found = std::ranges::find(all, name, &Figure::name);
  return name.empty() || found == all.end() ? nullptr : &*found;
}

}  // namespace

std::vector<FigureDifference> differences(const EaseReport& here, const EaseReport& there) {
  std::vector<FigureDifference> all;
  for (const Girth& girth : here.figures.girths.rows) {
    const Girth* other = same(there.figures.girths.rows, girth.name);
    if (other == nullptr || !girth.is_girth() || !other->is_girth()) continue;
    all.push_back(
        {"ease", girth.name, girth.ease(), other->ease(), std::hypot(girth.error, other->error)});
  }
  for (const GarmentLevel& level : here.figures.levels) {
    const GarmentLevel* other = same(there.figures.levels, level.name);
    if (other == nullptr) continue;
    all.push_back({"height", level.name, level.height, other->height,
                   std::hypot(level.height_error, other->height_error)});
  }
  for (const GarmentLength& length : here.figures.lengths) {
    const GarmentLength* other = same(there.figures.lengths, length.name);
    if (other == nullptr) continue;
    all.push_back(
        {"length", length.name, length.worn, other->worn, std::hypot(length.error, other->error)});
  }
  return all;
}

PageTable difference_table(const std::vector<FigureDifference>& differences,
                           const std::string& other) {
  PageTable table;
  table.caption = "Against " + other + ", cm";
  table.sheet = 2;
  table.columns = {"figure", "of"};
  for (const char* name : {"here", "there", "difference", "\xC2\xB1"}) {
    table.columns.emplace_back(name, true);
  }
  for (const FigureDifference& row : differences) {
    table.rows.push_back(
        {row.name, row.what, cm(row.here), cm(row.there), cm(row.difference()), cm(row.error)});
    table.quiet.push_back(!row.is_sure());
  }
  table.remark = "Grey: the difference is within its error.";
  return table;
}

std::vector<PageMap> difference_maps(const EaseReport& here, const EaseReport& there) {
  const auto places = same_places(here.garment, there.garment);
  if (std::ranges::none_of(places, [](const auto& place) { return place.has_value(); })) return {};
  std::vector<PageMap> maps;
  const std::vector<PageMap> own = ease_maps(here);
  const std::vector<PageMap> others = ease_maps(there);
  const auto add = [&](const std::string& reading, const std::function<double(double)>& error) {
    const auto mine = std::ranges::find(own, reading, &PageMap::reading);
    const auto theirs = std::ranges::find(others, reading, &PageMap::reading);
    if (mine == own.end() || theirs == others.end()) return;
    maps.push_back(
        difference_map(reading, mine->unit, mine->values, theirs->values, places, error));
  };
  add("gap", [](double) { return 0; });
  add("tension", tension_error);
  add("pressure", [](double kPa) { return mean_pressure_error(1000 * kPa) / 1000; });
  return maps;
}

}  // namespace toile
