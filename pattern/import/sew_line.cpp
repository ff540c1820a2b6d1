#include "pattern/import/sew_line.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.h"
#include "pattern/import/join_paths.h"
#include "pattern/import/piece_shape.h"

namespace toile {

namespace {

/// Metres: the widest seam allowance, measured into corners.
constexpr double max_allowance = 0.06;

/// Metres: a sew line leaves the boundary by less, where they are one.
constexpr double drawing_noise = 1e-3;

/// Metres: chords that are good enough to compare lines.
constexpr double comparing_chords = 1e-4;

/// Some hundred of the points.
std::vector<Vec2> thinned(const std::vector<Vec2>& points) {
  constexpr std::size_t max_points = 400;
  const std::size_t step = points.size() / max_points + 1;
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < points.size(); i += step) kept.push_back(points[i]);
  return kept;
}

}  // namespace

bool runs_along(const std::vector<Vec2>& boundary, const PiecePath& path) {
  const std::vector<Vec2> inner = loop_points(path, comparing_chords);
  const double whole = std::abs(signed_area(boundary));
  const double share = inner.size() < 3 ? 0 : std::abs(signed_area(inner)) / whole;
  // What leaves no allowance is the boundary once more.
  if (share < 0.2 || share > 0.998) return false;
  const std::vector<Vec2> some = thinned(inner);
  const std::vector<Vec2> outer = thinned(boundary);
  return std::all_of(some.begin(), some.end(),
                     [&](const Vec2& point) {
                       return inside(boundary, point) ||
                              nearest_place(boundary, point).distance < drawing_noise;
                     }) &&
         std::all_of(outer.begin(), outer.end(), [&](const Vec2& point) {
           return nearest_place(inner, point).distance <= max_allowance;
         });
}

}  // namespace toile
