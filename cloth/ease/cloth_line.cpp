#include "cloth/ease/cloth_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/slice.h"

namespace toile {

namespace {

/// Metres: what a straight line misses or has too much beside the line of the plane before the
/// latter counts. Trousers differ by 2 cm at the hip. Half and double were not tried.
constexpr double line_differs = 0.01;

using Interval = std::pair<double, double>;

/// The line in which a plane cuts a panel, on the flat.
struct FlatLine {
  std::vector<std::array<Vec2, 2>> pieces;  ///< one a triangle
  double length = 0;                        ///< metres
  Vec2 moment{0, 0};                        ///< sum of lengths times middles
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
              std::array<Vec2, 2>& ends) {
  int found = 0;
  for (int i = 0; i < 3 && found < 2; ++i) {
    const int j = (i + 1) % 3;
    if ((height[i] >= 0) == (height[j] >= 0)) continue;
    const double along = height[i] / (height[i] - height[j]);
    ends[found++] = (1 - along) * corners[i] + along * corners[j];
  }
  return found;
}

std::array<Vec2, 3> flat_corners_of(const DressedGarment& garment, std::size_t t) {
  const Triangle& points = garment.flat_triangles[t];
  return {garment.flat[points[0]], garment.flat[points[1]], garment.flat[points[2]]};
}

/// The step across a triangle that the plane cuts, in either direction.
PathStep step_across(const DressedGarment& garment, const CuttingPlane& plane, int t) {
  const Triangle& nodes = garment.triangles[t];
  const std::array<Vec2, 3> corners = flat_corners_of(garment, t);
  PathStep step;
  step.panel = garment.panel_of_triangle[t];
  bool is_second = false;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vec3& p = garment.points[nodes[i]];
    const Vec3& q = garment.points[nodes[j]];
    const double from = (p - plane.origin).dot(plane.normal);
    const double to = (q - plane.origin).dot(plane.normal);
    if ((from >= 0) == (to >= 0)) continue;
    const double share = from / (from - to);
    (is_second ? step.worn_to : step.worn_from) = p + share * (q - p);
    (is_second ? step.flat_to : step.flat_from) = (1 - share) * corners[i] + share * corners[j];
    is_second = true;
  }
  return step;
}

/// The shadow of a piece of line on the direction `run`.
Interval shadow(const std::array<Vec2, 2>& piece, const Vec2& run) {
  return std::minmax({piece[0].dot(run), piece[1].dot(run)});
}

/// Metres: intervals that are nearer are one. Pieces of a line meet but for rounding.
constexpr double rounding = 1e-9;

/// The same as disjoint intervals in ascending order.
std::vector<Interval> joined(std::vector<Interval> parts) {
  std::ranges::sort(parts);
  std::vector<Interval> disjoint;
  for (const Interval& part : parts) {
    if (disjoint.empty() || part.first > disjoint.back().second + rounding) {
      disjoint.push_back(part);
    } else {
      disjoint.back().second = std::max(disjoint.back().second, part.second);
    }
  }
  return disjoint;
}

double length_of(const std::vector<Interval>& disjoint) {
  double length = 0;
  for (const auto& [low, high] : disjoint) length += high - low;
  return length;
}

/// Metres of the straight line's cloth that the plane's line covers. At a slanting side the latter
/// ends a little before or beyond: less than `line_differs` there does not count.
double covered_length(const std::vector<Interval>& covered, const std::vector<Interval>& cloth) {
  double length = 0;
  for (const auto& [low, high] : cloth) {
    double first = high;
    double last = low;
    for (const auto& [from, to] : covered) {
      if (to <= low || from >= high) continue;
      length += std::min(high, to) - std::max(low, from);
      first = std::min(first, std::max(low, from));
      last = std::max(last, std::min(high, to));
    }
    if (first >= last) continue;
    if (first - low < line_differs) length += first - low;
    if (high - last < line_differs) length += high - last;
  }
  return length;
}

/// Where the straight line across a flat panel at a height along `up` has cloth, along `run`.
std::vector<Interval> cloth_at(const DressedGarment& garment, int panel, const Vec2& up,
                               const Vec2& run, double height) {
  std::vector<Interval> parts;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (garment.panel_of_triangle[t] != panel) continue;
    const std::array<Vec2, 3> corners = flat_corners_of(garment, t);
    std::array<double, 3> above;
    for (int i = 0; i < 3; ++i) above[i] = corners[i].dot(up) - height;
    std::array<Vec2, 2> ends;
    if (crossings(corners, above, ends) == 2) parts.push_back(shadow(ends, run));
  }
  return joined(std::move(parts));
}

PanelWidth width_of(const DressedGarment& garment, int panel, const FlatLine& line, double grain) {
  // The line runs around the body: the direction that it runs along the least runs down it.
  const std::array<Vec2, 4> directions = height_directions(grain);
  const auto least = std::ranges::min_element(line.across) - line.across.begin();
  const Vec2& up = directions[static_cast<std::size_t>(least)];
  // Warp and weft, and the drawing's x and y, are square to each other.
  const Vec2& run = directions[static_cast<std::size_t>(least) ^ 1U];
  PanelWidth width;
  width.panel = panel;
  width.flat_height = line.moment.dot(up) / line.length;
  width.on_the_line = line.length;
  std::vector<Interval> covered;
  covered.reserve(line.pieces.size());
  for (const auto& piece : line.pieces) covered.push_back(shadow(piece, run));
  covered = joined(std::move(covered));
  width.width = covered_length(covered, cloth_at(garment, panel, up, run, width.flat_height));
  width.along_line = length_of(covered) - width.width > line_differs;
  if (width.along_line) width.width = line.length;
  return width;
}

}  // namespace

ClothLine line_on_panels(const DressedGarment& garment, const std::vector<int>& triangles,
                         const CuttingPlane& plane, const std::vector<double>& grains) {
  std::map<int, FlatLine> lines;
  for (const int t : triangles) {
    const PathStep step = step_across(garment, plane, t);
    const std::array<Vec2, 2> ends = {step.flat_from, step.flat_to};
    const int panel = step.panel;
    FlatLine& line = lines[panel];
    const double length = (ends[1] - ends[0]).norm();
    line.pieces.push_back(ends);
    line.length += length;
    line.moment += length * 0.5 * (ends[0] + ends[1]);
    const std::array<Vec2, 4> directions = height_directions(grain_of(grains, panel));
    for (int i = 0; i < 4; ++i) line.across[i] += std::abs(directions[i].dot(ends[1] - ends[0]));
  }
  ClothLine found;
  for (const auto& [panel, line] : lines) {
    if (!(line.length > 0)) continue;
    found.panels.push_back(width_of(garment, panel, line, grain_of(grains, panel)));
    found.as_cut += found.panels.back().width;
    found.on_the_line += line.length;
  }
  if (found.as_cut - found.on_the_line > line_differs) found.as_cut = found.on_the_line;
  return found;
}

namespace {

void turn(PathStep& step) {
  std::swap(step.worn_from, step.worn_to);
  std::swap(step.flat_from, step.flat_to);
}

}  // namespace

std::vector<ClothPath> paths_on_plane(const DressedGarment& garment, const CuttingPlane& plane) {
  std::vector<ClothPath> paths;
  for (const Section& section :
       slice({garment.points, garment.triangles}, plane.origin, plane.normal)) {
    if (section.closed) continue;
    ClothPath path;
    Vec3 at = section.points.front();
    for (const int t : section.triangles) {
      path.push_back(step_across(garment, plane, t));
      if ((path.back().worn_to - at).norm() < (path.back().worn_from - at).norm()) {
        turn(path.back());
      }
      at = path.back().worn_to;
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

ClothPath reversed(const ClothPath& path) {
  ClothPath back(path.rbegin(), path.rend());
  for (PathStep& step : back) turn(step);
  return back;
}

double flat_length(const ClothPath& path) {
  double length = 0;
  for (std::size_t first = 0; first < path.size();) {
    std::size_t last = first;
    while (last + 1 < path.size() && path[last + 1].panel == path[first].panel) ++last;
    length += (path[last].flat_to - path[first].flat_from).norm();
    first = last + 1;
  }
  return length;
}

std::map<std::pair<int, int>, FlatEdge> flat_edges(const DressedGarment& garment) {
  std::map<std::pair<int, int>, FlatEdge> edges;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const Triangle& flat = garment.flat_triangles[t];
      const double length = (garment.flat[flat[i]] - garment.flat[flat[j]]).norm();
      const std::pair<int, int> edge =
          std::minmax(garment.triangles[t][i], garment.triangles[t][j]);
      const auto [at, is_new] = edges.emplace(edge, FlatEdge{length, {}});
      if (!is_new) at->second.length = std::min(at->second.length, length);
      at->second.panels.insert(garment.panel_of_triangle[t]);
    }
  }
  return edges;
}

double worn_length(const ClothPath& path) {
  double length = 0;
  for (const PathStep& step : path) length += (step.worn_to - step.worn_from).norm();
  return length;
}

}  // namespace toile
