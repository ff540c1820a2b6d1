#include "pattern/import/sew_line.h"

#include <Eigen/Geometry>
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

/// Share of the boundary's area that a named sew line bounds at least. Narrow bands keep a sixth; a
/// mark in the middle of a small piece less.
constexpr double least_named_share = 0.1;

/// Share of a piece that may lie farther beyond its sew line than an allowance is wide. Sound lines
/// in 110 pieces of Valentina had up to 0.5 %, by a spike of the boundary. Lines that cut across
/// had half and more. Twice as much or half of it takes the same lines.
constexpr double max_far_share = 0.05;

/// Points along the longer side of a piece, to measure its area beyond a line.
constexpr int samples_along = 60;

double area_share(const std::vector<Vec2>& boundary, const std::vector<Vec2>& inner) {
  return inner.size() < 3 ? 0 : std::abs(signed_area(inner)) / std::abs(signed_area(boundary));
}

bool lies_within(const std::vector<Vec2>& boundary, const std::vector<Vec2>& inner) {
  const std::vector<Vec2> some = thinned(inner);
  return std::all_of(some.begin(), some.end(), [&](const Vec2& point) {
    return inside(boundary, point) || nearest_place(boundary, point).distance < drawing_noise;
  });
}

/// Whether no point of the boundary is farther from the line than an allowance is wide.
bool is_near_all(const std::vector<Vec2>& boundary, const std::vector<Vec2>& inner) {
  const std::vector<Vec2> some = thinned(boundary);
  return std::all_of(some.begin(), some.end(), [&](const Vec2& point) {
    return nearest_place(inner, point).distance <= max_allowance;
  });
}

/// The share of the boundary's area that lies outside of the line, and farther from it than an
/// allowance is wide. Spikes, where an allowance fails at a corner, are long and have no area.
double far_share(const std::vector<Vec2>& boundary, const std::vector<Vec2>& inner) {
  const std::vector<Vec2> outer_line = thinned(boundary);
  const std::vector<Vec2> inner_line = thinned(inner);
  Eigen::AlignedBox2d box;
  for (const Vec2& point : outer_line) box.extend(point);
  const double step = box.sizes().maxCoeff() / samples_along;
  int all = 0;
  int far = 0;
  for (double x = box.min().x() + step / 2; x < box.max().x(); x += step) {
    for (double y = box.min().y() + step / 2; y < box.max().y(); y += step) {
      const Vec2 point(x, y);
      if (!inside(outer_line, point)) continue;
      ++all;
      if (!inside(inner_line, point) && nearest_place(inner_line, point).distance > max_allowance) {
        ++far;
      }
    }
  }
  return all == 0 ? 0 : static_cast<double>(far) / all;
}

}  // namespace

bool runs_along(const std::vector<Vec2>& boundary, const PiecePath& path) {
  const std::vector<Vec2> inner = loop_points(path, comparing_chords);
  const double share = area_share(boundary, inner);
  // What leaves no allowance is the boundary once more.
  return share >= 0.2 && share <= 0.998 && lies_within(boundary, inner) &&
         is_near_all(boundary, inner);
}

bool can_be_sew_line(const std::vector<Vec2>& boundary, const PiecePath& path) {
  const std::vector<Vec2> inner = loop_points(path, comparing_chords);
  return area_share(boundary, inner) >= least_named_share && lies_within(boundary, inner) &&
         far_share(boundary, inner) <= max_far_share;
}

}  // namespace toile
