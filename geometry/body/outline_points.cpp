#include "geometry/body/outline_points.h"

#include <algorithm>
#include <cmath>

#include "geometry/body/extreme.h"

namespace toile {

Vec3 farthest(const std::vector<Vec3>& points, const Vec3& direction) {
  return *std::max_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
    return direction.dot(a) < direction.dot(b);
  });
}

Vec3 on_ray(const Section& section, const Vec3& from, const Vec3& direction, const Vec3& normal) {
  const Vec3 across = normal.cross(direction);
  std::optional<Vec3> best;
  const std::size_t n = section.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3& a = section.points[i];
    const Vec3& b = section.points[(i + 1) % n];
    const double low = across.dot(a - from);
    const double high = across.dot(b - from);
    if (low * high > 0 || low == high) continue;
    const Vec3 p = a + low / (low - high) * (b - a);
    if (!best || direction.dot(p) > direction.dot(*best)) best = p;
  }
  return best.value_or(farthest(section.points, direction));
}

Vec3 corner_of(const std::vector<Vec3>& outline, const Vec3& direction, double reach) {
  const Vec3 out = direction.normalized();
  const Vec3 along = Vec3::UnitX().cross(out);
  Vec3 tip = farthest(outline, out);
  std::vector<Vec2> samples;
  for (const Vec3& p : outline) {
    if (std::abs(along.dot(p - tip)) < 1.5 * reach && out.dot(p - tip) > -reach) {
      samples.emplace_back(along.dot(p - tip), out.dot(p - tip));
    }
  }
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  if (samples.size() < 6) return tip;
  const Extreme most = greatest(samples, reach);
  return most.is_end ? tip : Vec3(tip + most.at * along + most.value * out);
}

double width_of(const Section& section) {
  return farthest(section.points, Vec3::UnitX()).x() - farthest(section.points, -Vec3::UnitX()).x();
}

std::optional<Vec3> bulge(const std::vector<Vec3>& curve, const Vec3& toward, double reach) {
  const Vec3 along = (curve.back() - curve.front()).normalized();
  const Vec3 out = (toward - toward.dot(along) * along).normalized();
  std::vector<Vec2> samples;
  // Samples at equal steps: an edge's points are no measure of where the curve is.
  constexpr double step = 0.002;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const Vec3 side = curve[i + 1] - curve[i];
    const int n = std::max(1, static_cast<int>(side.norm() / step));
    for (int k = 0; k < n; ++k) {
      const Vec3 p = curve[i] + (static_cast<double>(k) / n) * side - curve.front();
      samples.emplace_back(along.dot(p), out.dot(p));
    }
  }
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  const double length = (curve.back() - curve.front()).norm();
  const Extreme most = greatest(samples, reach * length);
  if (most.is_end) return std::nullopt;
  return curve.front() + most.at * along + most.value * out;
}

std::optional<Vec3> at_x(const Section& section, double x, double side) {
  std::optional<Vec3> found;
  const std::size_t n = section.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3& a = section.points[i];
    const Vec3& b = section.points[(i + 1) % n];
    if ((a.x() - x) * (b.x() - x) > 0 || a.x() == b.x()) continue;
    const Vec3 p = a + (x - a.x()) / (b.x() - a.x()) * (b - a);
    if (!found || side * p.z() > side * found->z()) found = p;
  }
  return found;
}

}  // namespace toile
