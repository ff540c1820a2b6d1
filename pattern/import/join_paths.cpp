#include "pattern/import/join_paths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "io/text.h"

namespace toile {

namespace {

/// Metres: shorter curves are points.
constexpr double min_curve_length = 1e-6;

/// Steps along one curve at most.
constexpr int max_curve_steps = 1000;

/// Free ends of paths in square cells as wide as a gap may be. End 2p is the start of path p, end
/// 2p + 1 its end. All ends are opened before the first search.
class FreeEnds {
 public:
  explicit FreeEnds(const std::vector<PiecePath>& paths) : free_(2 * paths.size(), false) {
    points_.reserve(free_.size());
    for (const PiecePath& path : paths) {
      points_.push_back(path.front().start());
      points_.push_back(path.back().end());
    }
    std::vector<int> order(points_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [this](int a, int b) {
      const Vec2& p = at(a);
      const Vec2& q = at(b);
      return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Vec2& point = at(order[i]);
      std::vector<Place>& places = cells_[key(cell(point.x()), cell(point.y()))];
      if (i == 0 || at(order[i - 1]) != point) places.emplace_back();
      places.back().ends.push_back(order[i]);
    }
  }

  void open(int end) { free_[static_cast<std::size_t>(end)] = true; }
  void close(int end) { free_[static_cast<std::size_t>(end)] = false; }
  const Vec2& at(int end) const { return points_[static_cast<std::size_t>(end)]; }
  bool is_free(int end) const { return free_[static_cast<std::size_t>(end)]; }

  /// The nearest free end within max_outline_gap; -1: none. Of two as near, the first.
  int nearest(const Vec2& point) {
    int best = -1;
    double least = max_outline_gap;
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const auto found = cells_.find(key(cell(point.x()) + dx, cell(point.y()) + dy));
        if (found == cells_.end()) continue;
        std::vector<Place>& places = found->second;
        for (std::size_t i = 0; i < places.size();) {
          const int end = first_free(places[i]);
          if (end < 0) {
            std::swap(places[i], places.back());
            places.pop_back();
            continue;
          }
          ++i;
          const double distance = (at(end) - point).norm();
          if (distance > least || (distance == least && best >= 0 && end > best)) continue;
          least = distance;
          best = end;
        }
      }
    }
    return best;
  }

 private:
  /// The ends that lie in one point, in rising order. Thousands may: only the first that is free is
  /// looked at, and what was joined before it never again.
  struct Place {
    std::vector<int> ends;
    std::size_t first = 0;
  };

  int first_free(Place& place) const {
    while (place.first < place.ends.size() && !is_free(place.ends[place.first])) ++place.first;
    return place.first < place.ends.size() ? place.ends[place.first] : -1;
  }

  static std::int64_t cell(double x) {
    return static_cast<std::int64_t>(std::floor(x / max_outline_gap));
  }
  // Unsigned: far cells wrap around, and two that share a key are told apart by distance.
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) * 2'147'483'647U + static_cast<std::uint64_t>(y);
  }

  std::vector<Vec2> points_;
  std::vector<bool> free_;
  std::unordered_map<std::uint64_t, std::vector<Place>> cells_;
};

/// The curve with other ends that are near its own.
EdgeCurve ending_at(const EdgeCurve& curve, const Vec2& start, const Vec2& end) {
  if (curve.start() == start && curve.end() == end) return curve;
  if (curve.straight() || (curve.end() - curve.start()).norm() < 10 * max_outline_gap) {
    return EdgeCurve::line(start, end);
  }
  return curve.moved_to(start, end);
}

void append_path(PiecePath& path, const PiecePath& more) {
  for (const EdgeCurve& curve : more) {
    path.push_back(path.empty() ? curve : ending_at(curve, path.back().end(), curve.end()));
  }
}

}  // namespace

double path_length(const PiecePath& path) {
  double length = 0;
  for (const EdgeCurve& curve : path) length += curve.length();
  return length;
}

std::string millimetres_text(const Vec2& metres) {
  std::string text(1, '(');
  text.append(fixed_number(metres.x() * 1000, 1)).append(", ");
  return text.append(fixed_number(metres.y() * 1000, 1)).append(") mm");
}

PiecePath reversed_path(const PiecePath& path) {
  PiecePath reversed;
  reversed.reserve(path.size());
  for (auto curve = path.rbegin(); curve != path.rend(); ++curve) {
    reversed.push_back(curve->reversed());
  }
  return reversed;
}

std::vector<Vec2> path_points(const PiecePath& path, double tolerance) {
  std::vector<Vec2> points;
  if (path.empty()) return points;
  points.push_back(path.front().start());
  for (const EdgeCurve& curve : path) {
    int steps = 1;
    if (!curve.straight()) {
      // An arc of angle a and length l leaves its chord by a * l / 8. Curves bend unevenly.
      const double chords = std::sqrt(curve.turning() * curve.length() / (8 * tolerance));
      steps = static_cast<int>(std::clamp(std::ceil(1.5 * chords), 1.0, 1.0 * max_curve_steps));
    }
    for (int i = 1; i <= steps; ++i) points.push_back(curve.at(static_cast<double>(i) / steps));
  }
  return points;
}

bool is_line(const std::vector<Vec2>& points) {
  constexpr double width = 1e-3;
  Eigen::AlignedBox2d box;
  for (const Vec2& point : points) box.extend(point);
  return points.size() < 3 || box.sizes().minCoeff() < width;
}

std::vector<Vec2> loop_points(const PiecePath& path, double tolerance) {
  std::vector<Vec2> points = path_points(path, tolerance);
  while (points.size() > 1 && (points.back() - points.front()).norm() < min_curve_length) {
    points.pop_back();
  }
  return points;
}

JoinedPaths join_paths(const std::vector<PiecePath>& given) {
  std::vector<PiecePath> paths;
  for (const PiecePath& path : given) {
    PiecePath kept;
    for (const EdgeCurve& curve : path) {
      if (curve.length() >= min_curve_length) kept.push_back(curve);
    }
    if (!kept.empty()) paths.push_back(std::move(kept));
  }
  JoinedPaths joined;
  FreeEnds ends(paths);
  const auto count = static_cast<int>(paths.size());
  std::vector<bool> closed(paths.size(), false);
  for (int p = 0; p < count; ++p) {
    // What was drawn closed takes no part in joining.
    const double gap = (ends.at(2 * p) - ends.at(2 * p + 1)).norm();
    double length = 0;
    for (const EdgeCurve& curve : paths[static_cast<std::size_t>(p)]) length += curve.length();
    if (gap <= max_outline_gap && length > 10 * max_outline_gap) {
      closed[static_cast<std::size_t>(p)] = true;
    } else {
      ends.open(2 * p);
      ends.open(2 * p + 1);
    }
  }
  const auto finish = [&](PiecePath path) {
    const Vec2 start = path.front().start();
    joined.widest_closed_gap =
        std::max(joined.widest_closed_gap, (path.back().end() - start).norm());
    path.back() = ending_at(path.back(), path.back().start(), start);
    joined.closed.push_back(std::move(path));
  };
  std::vector<bool> used(paths.size(), false);
  for (int p = 0; p < count; ++p) {
    if (used[static_cast<std::size_t>(p)]) continue;
    used[static_cast<std::size_t>(p)] = true;
    if (closed[static_cast<std::size_t>(p)]) {
      finish(paths[static_cast<std::size_t>(p)]);
      continue;
    }
    PiecePath path = paths[static_cast<std::size_t>(p)];
    ends.close(2 * p + 1);
    bool looped = false;
    // Forwards from the end, then backwards from the start.
    for (int pass = 0; pass < 2 && !looped; ++pass) {
      if (pass == 1) path = reversed_path(path);
      for (;;) {
        const Vec2 tip = path.back().end();
        const int next = ends.nearest(tip);
        if (next < 0) break;
        joined.widest_closed_gap = std::max(joined.widest_closed_gap, (ends.at(next) - tip).norm());
        ends.close(next);
        if (next / 2 == p) {
          looped = true;
          break;
        }
        ends.close(next ^ 1);
        used[static_cast<std::size_t>(next / 2)] = true;
        const PiecePath& more = paths[static_cast<std::size_t>(next / 2)];
        append_path(path, next % 2 == 0 ? more : reversed_path(more));
      }
      if (pass == 0) ends.close(2 * p);
    }
    if (looped) {
      finish(std::move(path));
    } else {
      joined.open.push_back(reversed_path(path));
    }
  }
  // What each open path lacks: the nearest end, its own start included.
  for (std::size_t i = 0; i < joined.open.size(); ++i) {
    const Vec2 tip = joined.open[i].back().end();
    PathGap gap{std::numeric_limits<double>::max(), tip};
    for (std::size_t k = 0; k < joined.open.size(); ++k) {
      for (const Vec2& end : {joined.open[k].front().start(), joined.open[k].back().end()}) {
        if (k == i && end == tip) continue;
        const double size = (end - tip).norm();
        if (size < gap.size) gap = {size, (end + tip) / 2};
      }
    }
    joined.gaps.push_back(gap);
    if (joined.open.size() > 1000) break;  // the first says enough
  }
  return joined;
}

}  // namespace toile
