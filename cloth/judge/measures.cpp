#include "cloth/judge/measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "cloth/judge/constants.h"
#include "cloth/judge/yarn_strain.h"
#include "cloth/model/gathers.h"
#include "geometry/border_loops.h"
#include "geometry/error.h"
#include "geometry/half_edges.h"
#include "geometry/statistics.h"
#include "geometry/triangle_area.h"

namespace toile {

namespace {

using Edge = std::pair<int, int>;

/// Each edge of the triangles [first, last) with the number of those that have it. `points` is the
/// number of points.
std::vector<std::pair<Edge, int>> edge_uses(const std::vector<Triangle>& triangles, int first,
                                            int last, std::size_t points) {
  const std::span<const Triangle> some(triangles.data() + first,
                                       static_cast<std::size_t>(last - first));
  std::vector<std::pair<Edge, int>> uses;
  uses.reserve(2 * some.size());
  for (const HalfEdge& side : half_edges(some, points)) {
    const Edge edge(side.low, side.high);
    if (uses.empty() || uses.back().first != edge) uses.push_back({edge, 0});
    ++uses.back().second;
  }
  return uses;
}

std::vector<Vec3> in_space(const std::vector<Vec2>& flat) {
  std::vector<Vec3> points;
  points.reserve(flat.size());
  for (const Vec2& p : flat) points.emplace_back(p.x(), p.y(), 0);
  return points;
}

double area(const std::vector<Vec3>& p, const Triangle& t) {
  return triangle_area(p[t[0]], p[t[1]], p[t[2]]);
}

double perimeter(const std::vector<Vec3>& p, const Triangle& t) {
  return (p[t[1]] - p[t[0]]).norm() + (p[t[2]] - p[t[1]]).norm() + (p[t[0]] - p[t[2]]).norm();
}

template <typename Measure>
std::vector<double> sum_triangles(const PanelMesh& garment, const std::vector<Vec3>& points,
                                  const Measure& measure) {
  std::vector<double> sums;
  for (const MeshedPanel& panel : garment.panels) {
    double sum = 0;
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      sum += measure(points, garment.triangles[t]);
    }
    sums.push_back(sum);
  }
  return sums;
}

/// Strains are sorted first, so that the root mean square adds the small ones up first.
StrainStatistics statistics_of(std::vector<double> strains) {
  if (strains.empty()) return {};
  std::sort(strains.begin(), strains.end());
  return {strains.back(), percentile(strains, 0.99), root_mean_square(strains)};
}

SeamMeasurements measure_seams(const PanelMesh& pattern, const std::vector<Vec3>& points) {
  SeamMeasurements measured;
  for (const MeshedSeam& seam : pattern.seams) {
    double gap = 0;
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      gap = std::max(gap, (points[seam.a[i]] - points[seam.b[i]]).norm());
    }
    measured.max_gap = std::max(measured.max_gap, gap);
    if (gap <= sewn_gap) {
      ++measured.sewn;
    } else {
      ++measured.open;
      measured.open_seams.push_back({seam.name, gap});
    }
  }
  return measured;
}

void measure_yarns(const PanelMesh& pattern, const std::vector<Vec3>& points,
                   GarmentMeasurements& measured) {
  const std::vector<char> gathered = on_gathers(pattern);
  const std::vector<YarnStrain> yarns = yarn_strains(pattern, points);
  std::vector<double> longer;
  std::vector<double> shear;
  for (std::size_t t = 0; t < yarns.size(); ++t) {
    if (gathered[t]) continue;
    longer.push_back(std::max(yarns[t].largest(), 0.0));
    shear.push_back(std::abs(yarns[t].shear));
  }
  measured.warp_weft_strain = statistics_of(longer);
  measured.shear = statistics_of(shear);
}

/// Metres, per material point: its place in the dressed garment.
std::vector<Vec3> dressed_points(const PanelMesh& pattern, const DressedGarment& dressed) {
  if (dressed.flat_triangles != pattern.triangles) {
    throw Error("dressed garment", "has other faces than its pattern",
                "dress the garment of the same name again");
  }
  std::vector<Vec3> points(pattern.flat.size(), Vec3::Zero());
  for (std::size_t t = 0; t < pattern.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      points[pattern.triangles[t][i]] = dressed.points[dressed.triangles[t][i]];
    }
  }
  return points;
}

}  // namespace

std::vector<double> panel_areas(const PanelMesh& garment, const std::vector<Vec3>& points) {
  return sum_triangles(garment, points, area);
}

std::vector<double> panel_areas(const PanelMesh& garment) {
  return panel_areas(garment, in_space(garment.flat));
}

std::vector<double> triangle_perimeters(const PanelMesh& garment, const std::vector<Vec3>& points) {
  return sum_triangles(garment, points, perimeter);
}

std::vector<double> triangle_perimeters(const PanelMesh& garment) {
  return triangle_perimeters(garment, in_space(garment.flat));
}

Outlines panel_outlines(const PanelMesh& garment) {
  Outlines outlines;
  for (const MeshedPanel& panel : garment.panels) {
    outlines.emplace_back();
    for (const auto& [edge, uses] :
         edge_uses(garment.triangles, panel.first_triangle, panel.first_triangle + panel.triangles,
                   garment.flat.size())) {
      if (uses == 1) outlines.back().push_back({edge.first, edge.second});
    }
  }
  return outlines;
}

std::vector<double> panel_perimeters(const Outlines& outlines, const std::vector<Vec3>& points) {
  std::vector<double> lengths;
  for (const auto& outline : outlines) {
    double length = 0;
    for (const auto& [a, b] : outline) length += (points[a] - points[b]).norm();
    lengths.push_back(length);
  }
  return lengths;
}

std::vector<double> panel_perimeters(const PanelMesh& garment) {
  return panel_perimeters(panel_outlines(garment), in_space(garment.flat));
}

double largest_change(const std::vector<double>& rest, const std::vector<double>& now) {
  double largest = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    largest = std::max(largest, std::abs(now[i] / rest[i] - 1));
  }
  return largest;
}

GarmentMeasurements measure_garment(const PanelMesh& pattern, const DressedGarment& dressed) {
  const std::vector<Vec3> points = dressed_points(pattern, dressed);
  const std::vector<Vec3> flat = in_space(pattern.flat);
  std::vector<char> on_seam(points.size(), 0);
  for (const MeshedSeam& seam : pattern.seams) {
    for (const int p : seam.a) on_seam[p] = 1;
    for (const int p : seam.b) on_seam[p] = 1;
  }
  std::vector<char> gathered(points.size(), 0);
  for (const GatheredEdges& edges : {gathered_edges(pattern), elastic_edges(pattern)}) {
    for (const auto& [edge, share] : edges) gathered[edge.first] = gathered[edge.second] = 1;
  }
  std::vector<double> strains;
  std::vector<double> off_seams;
  for (const auto& edge : unique_edges(pattern.triangles)) {
    const double rest = (flat[edge[0]] - flat[edge[1]]).norm();
    const double longer = (points[edge[0]] - points[edge[1]]).norm() / rest - 1;
    strains.push_back(std::abs(longer));
    if (on_seam[edge[0]] && on_seam[edge[1]]) continue;
    const bool folds = gathered[edge[0]] || gathered[edge[1]];
    off_seams.push_back(folds ? std::max(longer, 0.0) : std::abs(longer));
  }
  GarmentMeasurements measured;
  measured.strain = statistics_of(strains);
  measured.strain_off_seams = statistics_of(off_seams);
  measure_yarns(pattern, points, measured);
  measured.overstretched = overstretched(pattern, points);
  const std::vector<double> rest_areas = panel_areas(pattern);
  const std::vector<double> areas = panel_areas(pattern, points);
  measured.area_max_panel = largest_change(rest_areas, areas);
  measured.area_total = std::accumulate(areas.begin(), areas.end(), 0.0) /
                            std::accumulate(rest_areas.begin(), rest_areas.end(), 0.0) -
                        1;
  measured.perimeter_max_panel =
      largest_change(panel_perimeters(pattern), panel_perimeters(panel_outlines(pattern), points));
  measured.triangle_perimeter_max_panel =
      largest_change(triangle_perimeters(pattern), triangle_perimeters(pattern, points));
  measured.seams = measure_seams(pattern, points);
  measured.elastics = measure_elastics(pattern, points);
  measured.borders =
      static_cast<int>(border_loops(dressed.triangles, dressed.points.size()).size());
  return measured;
}

}  // namespace toile
