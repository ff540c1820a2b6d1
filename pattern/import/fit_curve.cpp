#include "pattern/import/fit_curve.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/polygon.h"

namespace toile {

namespace {

/// Points that a curve is fitted to, at least. Long chords get points in between.
constexpr int min_fit_samples = 48;

/// Points that a curve is fitted to, at most. More cost time and change nothing.
constexpr int max_fit_samples = 400;

/// Rounds of moving parameters to the nearest points of the curve.
constexpr int fit_rounds = 60;

Vec2 bezier(const std::array<Vec2, 4>& p, double t) {
  const double s = 1 - t;
  return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

/// A polyline that is walked by length.
class PolylineWalk {
 public:
  explicit PolylineWalk(const std::vector<Vec2>& points) : points_(points), lengths_(1, 0) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      lengths_.push_back(lengths_.back() + (points[i] - points[i - 1]).norm());
    }
  }
  double length() const { return lengths_.back(); }
  double length_to(std::size_t i) const { return lengths_[i]; }
  Vec2 at(double length) const {
    const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
    const auto i = static_cast<std::size_t>(after - lengths_.begin());
    const double step = lengths_[i] - lengths_[i - 1];
    const double share = step > 0 ? std::clamp((length - lengths_[i - 1]) / step, 0.0, 1.0) : 0;
    return points_[i - 1] + share * (points_[i] - points_[i - 1]);
  }

 private:
  const std::vector<Vec2>& points_;
  std::vector<double> lengths_;
};

/// The polyline in steps of nearly equal length, and its own points where they are few.
std::vector<Vec2> samples_of(const std::vector<Vec2>& points, const PolylineWalk& walk) {
  std::vector<double> places;
  if (points.size() <= static_cast<std::size_t>(max_fit_samples) / 2) {
    for (std::size_t i = 0; i < points.size(); ++i) places.push_back(walk.length_to(i));
  }
  const int steps =
      std::clamp(static_cast<int>(points.size()), min_fit_samples, max_fit_samples / 2);
  for (int i = 0; i <= steps; ++i) places.push_back(walk.length() * i / steps);
  std::sort(places.begin(), places.end());
  std::vector<Vec2> samples;
  double last = -1;
  for (const double place : places) {
    if (place - last < 1e-9) continue;
    samples.push_back(walk.at(place));
    last = place;
  }
  samples.back() = points.back();
  return samples;
}

/// Metres. `near` is the segment that was nearest to the point before, and becomes this point's.
/// Only segments up to `reach` before and behind it are looked at.
double distance_to_polyline(const std::vector<Vec2>& points, const Vec2& point, std::size_t reach,
                            std::size_t& near) {
  double least = 1e300;
  std::size_t best = near;
  const std::size_t first = near > reach ? near - reach : 0;
  for (std::size_t i = first; i + 1 < points.size() && i < near + reach; ++i) {
    const double distance = distance_to_segment(point, points[i], points[i + 1]);
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  near = best;
  return least;
}

/// Unit vectors along which a curve has to leave its ends; none: it is free.
struct EndTangents {
  std::optional<Vec2> start;
  std::optional<Vec2> end;  ///< backwards, into the curve
};

struct CubicFit {
  std::array<Vec2, 4> points;
  double error = 1e300;
  std::size_t worst = 0;  ///< the sample that is farthest off
};

/// The best curve for the samples at the parameters. Ends with a tangent keep it.
bool solve(const std::vector<Vec2>& samples, const std::vector<double>& parameters,
           const EndTangents& tangents, std::array<Vec2, 4>& p) {
  const int first = tangents.start ? 1 : 2;
  const int second = tangents.end ? 1 : 2;
  const auto rows = static_cast<Eigen::Index>(2 * samples.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows, first + second);
  Eigen::VectorXd known(rows);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = parameters[i];
    const double s = 1 - t;
    const double b1 = 3 * s * s * t;
    const double b2 = 3 * s * t * t;
    const Vec2 rest = samples[i] - (s * s * s + b1) * p[0] - (t * t * t + b2) * p[3];
    for (Eigen::Index k = 0; k < 2; ++k) {
      const auto row = static_cast<Eigen::Index>(2 * i) + k;
      known(row) = rest(k);
      if (tangents.start)
        matrix(row, 0) = b1 * (*tangents.start)(k);
      else
        matrix(row, k) = b1;
      if (tangents.end)
        matrix(row, first) = b2 * (*tangents.end)(k);
      else
        matrix(row, first + k) = b2;
    }
  }
  const Eigen::MatrixXd normal = matrix.transpose() * matrix;
  const Eigen::VectorXd handles = normal.ldlt().solve(matrix.transpose() * known);
  if (!handles.allFinite()) return false;
  const double chord = (p[3] - p[0]).norm();
  if (tangents.start) {
    if (handles(0) <= 1e-3 * chord) return false;
    p[1] = p[0] + handles(0) * *tangents.start;
  } else {
    p[1] = p[0] + Vec2(handles(0), handles(1));
  }
  if (tangents.end) {
    if (handles(first) <= 1e-3 * chord) return false;
    p[2] = p[3] + handles(first) * *tangents.end;
  } else {
    p[2] = p[3] + Vec2(handles(first), handles(first + 1));
  }
  return true;
}

/// One step of Newton's method towards the curve's point that is nearest to `sample`.
double nearer(const std::array<Vec2, 4>& p, const Vec2& sample, double t) {
  const double s = 1 - t;
  const Vec2 off = bezier(p, t) - sample;
  const Vec2 slope =
      3 * (s * s * (p[1] - p[0]) + 2 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
  const Vec2 bend = 6 * (s * (p[2] - 2 * p[1] + p[0]) + t * (p[3] - 2 * p[2] + p[1]));
  const double gradient = off.dot(slope);
  const double change = slope.squaredNorm() + off.dot(bend);
  if (!(change > 0)) return t;
  return std::clamp(t - gradient / change, 0.0, 1.0);
}

CubicFit fit_one(const std::vector<Vec2>& points, const std::vector<Vec2>& samples,
                 const EndTangents& tangents, double tolerance) {
  CubicFit best;
  best.worst = samples.size() / 2;
  std::vector<double> parameters(1, 0);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    parameters.push_back(parameters.back() + (samples[i] - samples[i - 1]).norm());
  }
  const double length = parameters.back();
  for (double& t : parameters) t /= length;
  std::array<Vec2, 4> p = {samples.front(), samples.front(), samples.back(), samples.back()};
  double last_error = 1e300;
  for (int round = 0; round < fit_rounds; ++round) {
    if (!solve(samples, parameters, tangents, p)) break;
    double error = 0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      parameters[i] = nearer(p, samples[i], parameters[i]);
      const double off = (bezier(p, parameters[i]) - samples[i]).norm();
      if (off > error) {
        error = off;
        worst = i;
      }
    }
    std::sort(parameters.begin(), parameters.end());
    parameters.front() = 0;
    parameters.back() = 1;
    if (error < best.error) best = {p, error, worst};
    if (error < tolerance / 2) break;
    // The rounds close in by a steady share: stop where that won't do.
    const double rate = error / last_error;
    const double hoped = error * std::pow(rate, fit_rounds - 1 - round);
    if (round > 3 && !(hoped < tolerance)) break;
    last_error = error;
  }
  if (best.error > tolerance) return best;
  // Neither the curve nor the polyline must leave the other between the samples.
  const int checks = std::clamp(static_cast<int>(points.size()), 200, 20000);
  std::vector<Vec2> chords;
  for (int i = 0; i <= checks; ++i) {
    chords.push_back(bezier(best.points, static_cast<double>(i) / checks));
  }
  double walked = 0;
  std::size_t near = 0;
  constexpr std::size_t near_by =
      60;  // the curve is walked in order, in steps of a segment or less
  for (std::size_t i = 0; i < chords.size(); ++i) {
    if (i > 0) walked += (chords[i] - chords[i - 1]).norm();
    best.error = std::max(best.error, distance_to_polyline(points, chords[i], near_by, near));
  }
  near = 0;
  // From one point to the next there are many chords where points are few.
  const std::size_t reach = points.size() < 1000 ? chords.size() : near_by;
  for (const Vec2& point : points) {
    best.error = std::max(best.error, distance_to_polyline(chords, point, reach, near));
  }
  if (walked > 1.1 * length + tolerance) best.error = 1e300;  // it loops
  return best;
}

bool is_line(const std::vector<Vec2>& points, double tolerance) {
  return std::all_of(points.begin(), points.end(), [&](const Vec2& point) {
    return distance_to_segment(point, points.front(), points.back()) <= tolerance;
  });
}

/// The direction of the polyline around its point `i`, by what lies within `reach` of it.
Vec2 direction_at(const std::vector<Vec2>& points, const PolylineWalk& walk, std::size_t i,
                  double reach) {
  const double place = walk.length_to(i);
  const Vec2 along =
      walk.at(std::min(walk.length(), place + reach)) - walk.at(std::max(0.0, place - reach));
  const Vec2 own = points[std::min(i + 1, points.size() - 1)] - points[i > 0 ? i - 1 : 0];
  return (along.squaredNorm() > 0 ? along : own).normalized();
}

void fit(const std::vector<Vec2>& points, const EndTangents& tangents, double tolerance,
         std::vector<FittedCurve>& curves, int depth) {
  const Vec2& start = points.front();
  const Vec2& end = points.back();
  const auto line = [&] {
    curves.push_back({{start, start + (end - start) / 3, end - (end - start) / 3, end}, true});
  };
  if (points.size() == 2) {
    line();
    return;
  }
  // Within a chain a line would meet the curves beside it in a corner.
  if (is_line(points, tangents.start || tangents.end ? tolerance / 20 : tolerance / 4)) {
    line();
    return;
  }
  const PolylineWalk walk(points);
  const std::vector<Vec2> samples = samples_of(points, walk);
  const CubicFit one = fit_one(points, samples, tangents, tolerance);
  if (one.error <= tolerance) {
    curves.push_back({one.points, false});
    return;
  }
  // Cut near the worst sample, at a point of the polyline, but not close to an end.
  std::size_t cut = 1;
  double nearest = 1e300;
  double place = 0;
  for (std::size_t i = 1; i <= one.worst; ++i) place += (samples[i] - samples[i - 1]).norm();
  place = std::clamp(place, walk.length() / 4, walk.length() * 3 / 4);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double off = std::abs(walk.length_to(i) - place);
    if (off < nearest) {
      nearest = off;
      cut = i;
    }
  }
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(cut);
  const std::vector<Vec2> first(points.begin(), middle + 1);
  const std::vector<Vec2> second(middle, points.end());
  EndTangents before{tangents.start, std::nullopt};
  EndTangents after{std::nullopt, tangents.end};
  constexpr int max_smooth_depth = 12;
  if (depth < max_smooth_depth) {
    const double reach = std::min({walk.length_to(cut), walk.length() - walk.length_to(cut),
                                   std::max(10 * tolerance, walk.length() / 40)});
    const Vec2 along = direction_at(points, walk, cut, reach);
    before.end = -along;
    after.start = along;
  }
  fit(first, before, tolerance, curves, depth + 1);
  fit(second, after, tolerance, curves, depth + 1);
}

}  // namespace

std::vector<FittedCurve> fit_curves(const std::vector<Vec2>& points, double tolerance) {
  std::vector<FittedCurve> curves;
  fit(points, {}, tolerance, curves, 0);
  return curves;
}

}  // namespace toile
