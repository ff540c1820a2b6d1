#include "cloth/ease/panel_widths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace toile {

namespace {

/// Metres, and a share of the level's line: a straight line that is shorter by more leaves the
/// panel on its way.
constexpr double min_cut_short = 0.01;
constexpr double cut_short_share = 0.04;

/// The line in which a level cuts a panel, on the flat.
struct FlatLine {
  double length = 0;  ///< metres
  Vec2 moment{0, 0};  ///< sum of lengths times middles
  /// Of four directions, the sum of lengths across each: weft, warp, and the drawing's x and y.
  std::array<double, 4> across{};
};

std::array<Vec2, 4> height_directions(double grain) {
  const YarnDirections yarns = yarn_directions(grain);
  return {yarns.warp, yarns.weft, Vec2::UnitY(), Vec2::UnitX()};
}

double grain_of(const std::vector<double>& grains, int panel) {
  return grains.empty() ? 0 : grains[static_cast<std::size_t>(panel)];
}

/// The points in which a line cuts the sides of a flat triangle: where `height` of its corners is
/// 0.
int crossings(const std::array<Vec2, 3>& corners, const std::array<double, 3>& height,
              Vec2 (&ends)[2]) {
  int found = 0;
  for (int i = 0; i < 3 && found < 2; ++i) {
    const int j = (i + 1) % 3;
    if ((height[i] >= 0) == (height[j] >= 0)) continue;
    const double along = height[i] / (height[i] - height[j]);
    ends[found++] = (1 - along) * corners[i] + along * corners[j];
  }
  return found;
}

std::array<Vec2, 3> flat_corners(const DressedGarment& garment, std::size_t t) {
  const Triangle& points = garment.flat_triangles[t];
  return {garment.flat[points[0]], garment.flat[points[1]], garment.flat[points[2]]};
}

/// Metres of cloth on the straight line across a flat panel at a height along `up`.
double width_at(const DressedGarment& garment, int panel, const Vec2& up, double height) {
  double width = 0;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (garment.panel_of_triangle[t] != panel) continue;
    const std::array<Vec2, 3> corners = flat_corners(garment, t);
    std::array<double, 3> above;
    for (int i = 0; i < 3; ++i) above[i] = corners[i].dot(up) - height;
    Vec2 ends[2];
    if (crossings(corners, above, ends) == 2) width += (ends[1] - ends[0]).norm();
  }
  return width;
}

}  // namespace

std::vector<PanelWidth> panel_widths(const DressedGarment& garment,
                                     const std::vector<int>& triangles, const CuttingPlane& plane,
                                     const std::vector<double>& grains) {
  std::map<int, FlatLine> lines;
  for (const int t : triangles) {
    const Triangle& nodes = garment.triangles[t];
    std::array<double, 3> above;
    for (int i = 0; i < 3; ++i) {
      above[i] = (garment.points[nodes[i]] - plane.origin).dot(plane.normal);
    }
    Vec2 ends[2];
    if (crossings(flat_corners(garment, t), above, ends) < 2) continue;
    const int panel = garment.panel_of_triangle[t];
    FlatLine& line = lines[panel];
    const double length = (ends[1] - ends[0]).norm();
    line.length += length;
    line.moment += length * 0.5 * (ends[0] + ends[1]);
    const std::array<Vec2, 4> directions = height_directions(grain_of(grains, panel));
    for (int i = 0; i < 4; ++i) line.across[i] += std::abs(directions[i].dot(ends[1] - ends[0]));
  }
  std::vector<PanelWidth> widths;
  for (const auto& [panel, line] : lines) {
    if (!(line.length > 0)) continue;
    // The line runs around the body: the direction that it runs along the least runs down it.
    const auto least = std::ranges::min_element(line.across) - line.across.begin();
    const Vec2 up = height_directions(grain_of(grains, panel))[least];
    const double at = line.moment.dot(up) / line.length;
    const double width = width_at(garment, panel, up, at);
    // Warp and weft, and the drawing's x and y, are square to each other.
    const double run = line.across[static_cast<std::size_t>(least) ^ 1U];
    const bool leaves = width < run - std::max(min_cut_short, cut_short_share * run);
    widths.push_back({panel, at, leaves ? run : width, leaves});
  }
  return widths;
}

}  // namespace toile
