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

/// The closed line without points that lie on the chord past them: corners stay, however many
/// points the curves between them have. O(n).
std::vector<Vec2> thinned(const std::vector<Vec2>& points) {
  constexpr std::size_t max_span = 64;  // bounds the work where many points lie on a line
  std::vector<Vec2> kept;
  std::size_t first = 0;
  while (first < points.size()) {
    kept.push_back(points[first]);
    std::size_t next = first + 1;
    const auto chord_holds = [&](std::size_t end) {
      for (std::size_t i = first + 1; i < end; ++i) {
        if (distance_to_segment(points[i], points[first], points[end]) > comparing_chords) {
          return false;
        }
      }
      return true;
    };
    while (next + 1 < points.size() && next < first + max_span && chord_holds(next + 1)) ++next;
    first = next;
  }
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

std::optional<PiecePath> closed_along(const std::vector<Vec2>& boundary,
                                      const std::vector<PiecePath>& lines) {
  if (lines.empty()) return std::nullopt;
  const std::size_t count = boundary.size();
  std::vector<double> lengths(count + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    lengths[i + 1] = lengths[i] + (boundary[(i + 1) % count] - boundary[i]).norm();
  }
  struct Place {
    double along = 0;  ///< metres from the boundary's first point
    Vec2 at = Vec2::Zero();
  };
  const auto place_of = [&](const Vec2& end) -> std::optional<Place> {
    const OutlinePlace nearest = nearest_place(boundary, end);
    if (nearest.distance > drawing_noise) return std::nullopt;
    return Place{lengths[nearest.segment] + (nearest.at - boundary[nearest.segment]).norm(), end};
  };
  const auto run = [&](double from, double to) {
    return to >= from ? to - from : to - from + lengths.back();
  };
  struct Line {
    PiecePath path;
    Place from;
    Place to;
  };
  std::vector<Line> placed;
  for (const PiecePath& path : lines) {
    const auto from = place_of(path.front().start());
    const auto to = place_of(path.back().end());
    if (!from || !to) return std::nullopt;
    // It runs beside the part of the boundary that its middle is nearest to.
    const std::vector<Vec2> points = path_points(path, comparing_chords);
    double rest = path_length(path) / 2;
    std::size_t middle = 1;
    while (middle + 1 < points.size() && rest > (points[middle] - points[middle - 1]).norm()) {
      rest -= (points[middle] - points[middle - 1]).norm();
      ++middle;
    }
    const Vec2 last = (points[middle] - points[middle - 1]).normalized();
    const OutlinePlace nearest = nearest_place(boundary, points[middle - 1] + rest * last);
    const double beside =
        lengths[nearest.segment] + (nearest.at - boundary[nearest.segment]).norm();
    const bool forward = run(from->along, beside) <= run(from->along, to->along);
    placed.push_back(forward ? Line{path, *from, *to} : Line{reversed_path(path), *to, *from});
  }
  std::ranges::sort(placed, {}, [](const Line& line) { return line.from.along; });
  PiecePath closed;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Line& line = placed[i];
    const Place& next = placed[(i + 1) % placed.size()].from;
    // Lines beside the same part of the boundary are not one sew line.
    if (placed.size() > 1 &&
        run(line.from.along, line.to.along) > run(line.from.along, next.along)) {
      return std::nullopt;
    }
    closed.insert(closed.end(), line.path.begin(), line.path.end());
    Vec2 last = line.to.at;
    const double way = run(line.to.along, next.along);
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(lengths, line.to.along) -
                                                lengths.begin());
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t corner = (after + k) % count;
      const double apart = run(line.to.along, lengths[corner]);
      if (apart >= way) break;
      if ((boundary[corner] - last).norm() <= drawing_noise) continue;
      closed.push_back(EdgeCurve::line(last, boundary[corner]));
      last = boundary[corner];
    }
    closed.push_back(EdgeCurve::line(last, next.at));
  }
  return closed;
}

}  // namespace toile
