#include "cloth/ease/ease.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "geometry/parallel.h"
#include "geometry/triangle_area.h"

namespace toile {

namespace {

/// A gap with the area that it stands for.
struct WeightedGap {
  double gap = 0;
  double area = 0;
};

/// Metres: the gap below which `share` of the area lies. Each gap stands at the middle of its own
/// area, and values between these middles are interpolated. `sorted` ascends and is not empty.
double percentile(const std::vector<WeightedGap>& sorted, double total, double share) {
  const double wanted = share * total;
  double before = 0;
  double last_middle = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double middle = before + 0.5 * sorted[i].area;
    if (middle >= wanted) {
      if (i == 0 || middle <= last_middle) return sorted[i].gap;
      const double part = (wanted - last_middle) / (middle - last_middle);
      return sorted[i - 1].gap + part * (sorted[i].gap - sorted[i - 1].gap);
    }
    before += sorted[i].area;
    last_middle = middle;
  }
  return sorted.back().gap;
}

EaseStatistics statistics_of(std::vector<WeightedGap> gaps, double contact) {
  EaseStatistics result;
  if (gaps.empty()) return result;
  result.points = static_cast<int>(gaps.size());
  std::ranges::sort(gaps, {}, [](const WeightedGap& g) { return std::tie(g.gap, g.area); });
  for (const WeightedGap& g : gaps) result.area += g.area;
  double total = result.area;
  if (!(total > 0)) {
    // Cloth crumpled to nothing still has points.
    for (WeightedGap& g : gaps) g.area = 1;
    total = static_cast<double>(gaps.size());
  }
  for (const WeightedGap& g : gaps) {
    result.mean += g.gap * g.area / total;
    if (g.gap < contact) result.contact += g.area / total;
    if (g.gap < 0) result.inside += g.area / total;
  }
  double variance = 0;
  for (const WeightedGap& g : gaps) {
    variance += (g.gap - result.mean) * (g.gap - result.mean) * g.area / total;
  }
  result.deviation = std::sqrt(variance);
  // Rounding may leave sums of shares just above 1.
  result.contact = std::min(result.contact, 1.0);
  result.inside = std::min(result.inside, 1.0);
  result.min = gaps.front().gap;
  result.max = gaps.back().gap;
  result.p5 = percentile(gaps, total, 0.05);
  result.p50 = percentile(gaps, total, 0.50);
  result.p95 = percentile(gaps, total, 0.95);
  return result;
}

/// A triangle's corner with a third of the triangle's area.
struct Corner {
  int panel;
  int flat;
  int node;
  double area;

  auto key() const { return std::tie(panel, flat, node); }
};

}  // namespace

EaseMap measure_ease(const DressedGarment& garment, const SurfaceDistance& body,
                     const EaseOptions& options) {
  EaseMap map;
  map.node_gaps.resize(garment.points.size());
  parallel_for_items(garment.points.size(), [&](std::size_t i) {
    map.node_gaps[i] = body.closest_point(garment.points[i]).distance;
  });

  std::vector<Corner> corners;
  corners.reserve(3 * garment.triangles.size());
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const Triangle& nodes = garment.triangles[t];
    const auto point = [&](std::size_t k) -> const Vec3& {
      return garment.points[static_cast<std::size_t>(nodes[k])];
    };
    const double area = triangle_area(point(0), point(1), point(2));
    for (std::size_t k = 0; k < 3; ++k) {
      corners.push_back(
          {garment.panel_of_triangle[t], garment.flat_triangles[t][k], nodes[k], area / 3});
    }
  }
  // Stable, so that areas are summed in the order of the triangles.
  std::ranges::stable_sort(corners, {}, &Corner::key);

  std::vector<std::vector<WeightedGap>> of_panel(garment.panels.size());
  std::vector<WeightedGap> all;
  for (std::size_t i = 0; i < corners.size();) {
    const Corner& corner = corners[i];
    WeightedGap weighted{map.node_gaps[static_cast<std::size_t>(corner.node)], 0};
    for (; i < corners.size() && corners[i].key() == corner.key(); ++i) {
      weighted.area += corners[i].area;
    }
    map.points.push_back({corner.panel, corner.node, corner.flat, weighted.gap});
    of_panel[static_cast<std::size_t>(corner.panel)].push_back(weighted);
    all.push_back(weighted);
  }
  for (std::vector<WeightedGap>& gaps : of_panel) {
    map.panels.push_back(statistics_of(std::move(gaps), options.contact));
  }
  map.garment = statistics_of(std::move(all), options.contact);
  return map;
}

int farthest_node(const EaseMap& map, const std::vector<int>& nodes) {
  return *std::ranges::max_element(
      nodes, {}, [&](int node) { return map.node_gaps[static_cast<std::size_t>(node)]; });
}

}  // namespace toile
