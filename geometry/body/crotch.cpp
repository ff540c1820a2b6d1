#include "geometry/body/crotch.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/parallel.h"
#include "geometry/slice.h"

namespace toile {

namespace {

// Shares of the height. Finer steps move the crotch of five bodies by less than 1 mm.
constexpr double level_step = 0.0015;
constexpr double column_step = 0.002;
constexpr double columns_reach = 0.03;  // to the front and to the back
constexpr double down = 0.012;          // from where the sections touch
constexpr double search_up = 0.06;
// Of air between thighs that don't touch. Half or double moves the crotch of five bodies by 0.6 mm.
constexpr double least_gap = 0.0012;
// What is as low as the lowest of the perineum. At half or double the crotch of five bodies moves
// by 1 to 9 mm, nearly all of that from front to back.
constexpr double flat = 0.003;

/// Metres of air between two x in the line at z of a level cut, less what is covered twice.
double air(const std::vector<Section>& sections, double z, double from, double to) {
  struct Crossing {
    double x;
    int turn;
  };
  std::vector<Crossing> crossings;
  for (const Section& section : sections) {
    if (!section.closed) continue;
    const std::size_t n = section.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3& a = section.points[i];
      const Vec3& b = section.points[(i + 1) % n];
      if ((a.z() < z) == (b.z() < z)) continue;
      const double x = a.x() + (z - a.z()) / (b.z() - a.z()) * (b.x() - a.x());
      // Seen from above, z runs down where x runs right: the material is to the left of a side.
      crossings.push_back({x, a.z() < z ? 1 : -1});
    }
  }
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
  double sum = 0;
  double at = from;
  int inside = 0;
  for (const Crossing& crossing : crossings) {
    const double x = std::clamp(crossing.x, from, to);
    sum += (1 - inside) * (x - at);
    at = x;
    inside += crossing.turn;
  }
  return sum + (1 - inside) * (to - at);
}

/// The height at which the air in a column ends, from above; nothing where there is none. `gaps`
/// are widths at `levels`, which rise.
std::optional<double> top_of_air(const std::vector<double>& gaps, const std::vector<double>& levels,
                                 double least) {
  constexpr std::size_t lasting = 3;  // levels: a bubble has fewer
  for (std::size_t i = gaps.size(); i-- > lasting;) {
    bool opens = true;
    for (std::size_t k = 0; k < lasting; ++k) opens = opens && gaps[i - k] > least;
    if (!opens) continue;
    if (i + 1 == gaps.size()) return std::nullopt;
    // An arch's width squared falls to nothing in proportion to the height.
    const double here = gaps[i] * gaps[i];
    const double below = gaps[i - 1] * gaps[i - 1];
    const double more = below > here ? std::min(1.0, here / (below - here)) : 1.0;
    return levels[i] + more * (levels[i + 1] - levels[i]);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Vec3> find_crotch(const TriangleMesh& body, const CrotchSearch& search) {
  const double h = search.height;
  std::vector<double> levels;
  for (double y = search.near.y() - down * h; y < search.near.y() + search_up * h;
       y += level_step * h) {
    levels.push_back(y);
  }
  std::vector<double> columns;
  for (double z = -columns_reach; z <= columns_reach; z += column_step) {
    columns.push_back(search.near.z() + z * h);
  }
  std::vector<std::vector<double>> gaps(levels.size());
  parallel_for(levels.size(), [&](std::size_t i) {
    const std::vector<Section> sections = slice(body, {0, levels[i], 0}, Vec3::UnitY());
    for (const double z : columns) {
      gaps[i].push_back(air(sections, z, search.right.x(), search.left.x()));
    }
  });
  std::vector<Vec2> tops;  // z, height
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::vector<double> column;
    column.reserve(gaps.size());
    for (const std::vector<double>& level : gaps) column.push_back(level[k]);
    const auto top = top_of_air(column, levels, least_gap * h);
    if (top) tops.emplace_back(columns[k], *top);
  }
  if (tops.size() < 5) return std::nullopt;
  // The perineum is nearly flat from front to back: its lowest point would be anywhere.
  const auto lowest = std::min_element(tops.begin(), tops.end(), [](const Vec2& a, const Vec2& b) {
                        return a.y() < b.y();
                      })->y();
  double sum = 0;
  Vec2 mean = Vec2::Zero();
  for (const Vec2& top : tops) {
    const double share = std::max(0.0, 1 - (top.y() - lowest) / (flat * h));
    sum += share * share;
    mean += share * share * top;
  }
  mean /= sum;
  return Vec3(0, mean.y(), mean.x());
}

}  // namespace toile
