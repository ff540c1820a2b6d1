#include "io/dxf_curves.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace toile {

namespace {

DxfCurve hermite(const Vec2& start, const Vec2& start_slope, const Vec2& end, const Vec2& end_slope,
                 double step) {
  return {{start, start + step / 3 * start_slope, end - step / 3 * end_slope, end}, false};
}

/// A natural cubic spline through points, by the lengths of their chords.
std::vector<DxfCurve> interpolated(std::vector<Vec2> points) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const std::size_t n = points.size();
  if (n < 2) return {};
  if (n == 2) return {dxf_line(points[0], points[1])};
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < n; ++i) steps.push_back((points[i + 1] - points[i]).norm());
  // Slopes m: h[i] m[i-1] + 2 (h[i-1] + h[i]) m[i] + h[i-1] m[i+1] is known; free ends bend not.
  std::vector<double> diagonal(n);
  std::vector<double> upper(n);
  std::vector<Vec2> slopes(n);
  diagonal[0] = 2;
  upper[0] = 1;
  slopes[0] = 3 / steps[0] * (points[1] - points[0]);
  for (std::size_t i = 1; i < n; ++i) {
    const bool last = i + 1 == n;
    const double lower = last ? 1 : steps[i];
    const double factor = lower / diagonal[i - 1];
    diagonal[i] = (last ? 2 : 2 * (steps[i - 1] + steps[i])) - factor * upper[i - 1];
    upper[i] = last ? 0 : steps[i - 1];
    const Vec2 before = (points[i] - points[i - 1]) / steps[i - 1];
    const Vec2 known =
        last
            ? Vec2(3 * before)
            : Vec2(3 * (steps[i] * before + steps[i - 1] * (points[i + 1] - points[i]) / steps[i]));
    slopes[i] = known - factor * slopes[i - 1];
  }
  slopes[n - 1] /= diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) {
    slopes[i] = (slopes[i] - upper[i] * slopes[i + 1]) / diagonal[i];
  }
  std::vector<DxfCurve> curves;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    curves.push_back(hermite(points[i], slopes[i], points[i + 1], slopes[i + 1], steps[i]));
  }
  return curves;
}

/// The spline's polar form on one span of its knots, in homogeneous coordinates.
class Span {
 public:
  /// The span from knot `at` to the next.
  Span(const DxfSpline& spline, std::size_t at) : spline_(spline), at_(at) {}

  /// The polar form at as many parameters as the degree; `parameters` may repeat.
  Vec3 blossom(const std::vector<double>& parameters) const {
    const auto degree = static_cast<std::size_t>(spline_.degree);
    std::vector<Vec3> points;
    for (std::size_t i = at_ - degree; i <= at_; ++i) {
      const double weight = spline_.weights.empty() ? 1 : spline_.weights[i];
      const Vec2& point = spline_.control_points[i];
      points.emplace_back(weight * point.x(), weight * point.y(), weight);
    }
    for (std::size_t level = 1; level <= degree; ++level) {
      for (std::size_t i = 0; i + level <= degree; ++i) {
        const double low = spline_.knots[at_ - degree + i + level];
        const double high = spline_.knots[at_ + 1 + i];
        const double share = (parameters[level - 1] - low) / (high - low);
        points[i] = (1 - share) * points[i] + share * points[i + 1];
      }
    }
    return points[0];
  }

  Vec2 at(double parameter) const {
    const Vec3 point =
        blossom(std::vector<double>(static_cast<std::size_t>(spline_.degree), parameter));
    return point.head<2>() / point.z();
  }

 private:
  const DxfSpline& spline_;
  std::size_t at_;
};

void append_exact(std::vector<DxfCurve>& curves, const Span& span, int degree, double low,
                  double high) {
  std::vector<Vec2> points;
  for (int k = 0; k <= degree; ++k) {
    std::vector<double> parameters(static_cast<std::size_t>(degree), low);
    std::fill(parameters.begin(), parameters.begin() + k, high);
    points.push_back(span.blossom(parameters).head<2>());
  }
  if (degree == 1) {
    curves.push_back(dxf_line(points[0], points[1]));
  } else if (degree == 2) {
    curves.push_back({{points[0], points[0] + 2.0 / 3 * (points[1] - points[0]),
                       points[2] + 2.0 / 3 * (points[1] - points[2]), points[2]},
                      false});
  } else {
    curves.push_back({{points[0], points[1], points[2], points[3]}, false});
  }
}

void append_sampled(std::vector<DxfCurve>& curves, const Span& span, double low, double high) {
  constexpr int pieces = 16;
  const double step = (high - low) / pieces;
  const double nudge = step * 1e-4;
  const auto slope = [&](double t) -> Vec2 {
    return (span.at(t + nudge) - span.at(t - nudge)) / (2 * nudge);
  };
  for (int i = 0; i < pieces; ++i) {
    const double from = low + i * step;
    const double to = i + 1 == pieces ? high : from + step;
    curves.push_back(hermite(span.at(from), slope(from), span.at(to), slope(to), to - from));
  }
}

}  // namespace

DxfCurve dxf_line(const Vec2& start, const Vec2& end) {
  return {{start, start + (end - start) / 3, end - (end - start) / 3, end}, true};
}

void append_dxf_arc(std::vector<DxfCurve>& curves, const Vec2& centre, const Vec2& first,
                    const Vec2& second, double from, double to) {
  constexpr double max_angle = std::numbers::pi / 8;
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / max_angle)));
  const double step = (to - from) / pieces;
  const double handle = 4.0 / 3 * std::tan(step / 4);
  const auto point = [&](double t) -> Vec2 {
    return centre + std::cos(t) * first + std::sin(t) * second;
  };
  const auto slope = [&](double t) -> Vec2 { return std::cos(t) * second - std::sin(t) * first; };
  for (int i = 0; i < pieces; ++i) {
    const double start = from + i * step;
    const double end = i + 1 == pieces ? to : start + step;
    curves.push_back({{point(start), point(start) + handle * slope(start),
                       point(end) - handle * slope(end), point(end)},
                      false});
  }
}

void append_dxf_bulge(std::vector<DxfCurve>& curves, const Vec2& start, const Vec2& end,
                      double bulge) {
  const Vec2 chord = end - start;
  // Below, the arc leaves its chord by less than a hundred-millionth of its length.
  if (std::abs(bulge) < 1e-8 || chord.squaredNorm() == 0) {
    curves.push_back(dxf_line(start, end));
    return;
  }
  const Vec2 left(-chord.y(), chord.x());
  const Vec2 centre = (start + end) / 2 + (1 - bulge * bulge) / (4 * bulge) * left;
  const Vec2 arm = start - centre;
  const std::size_t before = curves.size();
  append_dxf_arc(curves, centre, arm, Vec2(-arm.y(), arm.x()), 0, 4 * std::atan(bulge));
  curves[before].points[0] = start;
  curves.back().points[3] = end;
}

std::string spline_problem(const DxfSpline& spline) {
  const std::size_t count = spline.control_points.size();
  if (count == 0) return spline.fit_points.size() >= 2 ? "" : "has neither control nor fit points";
  if (spline.degree < 1 || spline.degree > 10) {
    return "is of degree " + std::to_string(spline.degree);
  }
  const auto degree = static_cast<std::size_t>(spline.degree);
  if (count <= degree) return "has too few control points for its degree";
  if (spline.knots.size() != count + degree + 1) {
    return "has " + std::to_string(spline.knots.size()) + " knots instead of " +
           std::to_string(count + degree + 1);
  }
  if (!std::is_sorted(spline.knots.begin(), spline.knots.end())) return "has knots that decrease";
  if (!(spline.knots[count] > spline.knots[degree])) return "has knots that are all alike";
  if (!spline.weights.empty()) {
    if (spline.weights.size() != count) return "has not as many weights as control points";
    for (const double weight : spline.weights) {
      if (!(weight >= 1e-6 && weight <= 1e6)) return "has a weight that is not positive";
    }
  }
  return "";
}

std::vector<DxfCurve> spline_curves(const DxfSpline& given) {
  if (given.control_points.empty()) return interpolated(given.fit_points);
  std::vector<DxfCurve> curves;
  DxfSpline spline = given;
  if (std::adjacent_find(given.weights.begin(), given.weights.end(), std::not_equal_to<>()) ==
      given.weights.end()) {
    spline.weights.clear();
  }
  const auto degree = static_cast<std::size_t>(spline.degree);
  for (std::size_t k = degree; k < spline.control_points.size(); ++k) {
    const double low = spline.knots[k];
    const double high = spline.knots[k + 1];
    if (!(high > low)) continue;
    const Span span(spline, k);
    if (spline.weights.empty() && spline.degree <= 3) {
      append_exact(curves, span, spline.degree, low, high);
    } else {
      append_sampled(curves, span, low, high);
    }
  }
  return curves;
}

}  // namespace toile
