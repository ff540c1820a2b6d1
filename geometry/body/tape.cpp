#include "geometry/body/tape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/convex_hull.h"

namespace toile {

namespace {

/// A place on a polyline: on the side from point `side` to the next one.
struct Foot {
  std::size_t side = 0;
  Vec3 place = Vec3::Zero();
  double distance = std::numeric_limits<double>::infinity();
};

Foot foot_on(const Section& section, const Vec3& p) {
  Foot best;
  const std::size_t n = section.points.size();
  for (std::size_t i = 0; i + (section.closed ? 0 : 1) < n; ++i) {
    const Vec3& from = section.points[i];
    const Vec3 side = section.points[(i + 1) % n] - from;
    const double t = std::clamp((p - from).dot(side) / side.squaredNorm(), 0.0, 1.0);
    const Vec3 at = from + t * side;
    const double distance = (p - at).norm();
    if (distance < best.distance) best = {i, at, distance};
  }
  return best;
}

/// The points from one foot on to another, forward along a closed section.
std::vector<Vec3> forward(const Section& section, const Foot& from, const Foot& to) {
  const std::size_t n = section.points.size();
  std::vector<Vec3> line = {from.place};
  const double along_from = (from.place - section.points[from.side]).squaredNorm();
  const double along_to = (to.place - section.points[to.side]).squaredNorm();
  const bool same_side = from.side == to.side && along_to >= along_from;
  if (!same_side) {
    std::size_t i = from.side;
    do {
      i = (i + 1) % n;
      line.push_back(section.points[i]);
    } while (i != to.side);
  }
  line.push_back(to.place);
  return line;
}

double mean_along(const std::vector<Vec3>& line, const Vec3& direction) {
  double sum = 0;
  double length = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double part = (line[i + 1] - line[i]).norm();
    sum += part * direction.dot(line[i] + line[i + 1]) / 2;
    length += part;
  }
  return length > 0 ? sum / length : direction.dot(line.front());
}

/// The corner of the hull that is nearest to a point.
std::size_t nearest(const std::vector<int>& hull, const std::vector<Vec2>& flat, const Vec2& p) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < hull.size(); ++i) {
    if ((flat[hull[i]] - p).norm() < (flat[hull[best]] - p).norm()) best = i;
  }
  return best;
}

}  // namespace

double length_of(const std::vector<Vec3>& line) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += (line[i + 1] - line[i]).norm();
  return length;
}

std::vector<Vec3> part_between(const Section& section, const Vec3& a, const Vec3& b,
                               const Vec3& toward) {
  if (section.points.size() < 2) return {};
  const Foot from = foot_on(section, a);
  const Foot to = foot_on(section, b);
  if (!section.closed) return {};
  std::vector<Vec3> one = forward(section, from, to);
  std::vector<Vec3> other = forward(section, to, from);
  std::reverse(other.begin(), other.end());
  return mean_along(one, toward) >= mean_along(other, toward) ? one : other;
}

std::vector<Vec3> taut(const std::vector<Vec3>& part, const Vec3& toward) {
  if (part.size() < 3) return part;
  const Vec3 chord = part.back() - part.front();
  if (chord.norm() < 1e-9) return part;
  const Vec3 u = chord.normalized();
  const Vec3 v = (toward - toward.dot(u) * u).normalized();
  std::vector<Vec2> flat;
  for (const Vec3& p : part) flat.emplace_back(u.dot(p - part.front()), v.dot(p - part.front()));
  const std::vector<int> hull = convex_hull(flat);
  if (hull.size() < 3) return {part.front(), part.back()};
  const std::size_t first = nearest(hull, flat, flat.front());
  const std::size_t last = nearest(hull, flat, flat.back());
  // The hull runs counter-clockwise: from the first point backward it goes over the side of v.
  std::vector<Vec3> line = {part.front()};
  for (std::size_t i = first;; i = (i + hull.size() - 1) % hull.size()) {
    if (hull[i] != 0 && hull[i] != static_cast<int>(part.size()) - 1) {
      line.push_back(part[hull[i]]);
    }
    if (i == last) break;
  }
  line.push_back(part.back());
  return line;
}

std::vector<Vec3> tape_between(const TriangleMesh& mesh, const Vec3& a, const Vec3& b,
                               const Vec3& across, const Vec3& toward) {
  const Vec3 normal = (b - a).cross(across);
  if (normal.norm() < 1e-9) return {};
  const std::vector<Section> sections = slice(mesh, a, normal);
  const Section* joined = nullptr;
  double distance = 0.01;  // metres off the skin at which a point is none of it
  for (const Section& section : sections) {
    if (!section.closed || section.points.size() < 3) continue;
    const double off = std::max(foot_on(section, a).distance, foot_on(section, b).distance);
    if (off >= distance) continue;
    distance = off;
    joined = &section;
  }
  if (joined == nullptr) return {};
  return taut(part_between(*joined, a, b, toward), toward);
}

std::vector<Vec3> tape_around(const Section& section, const Vec3& normal) {
  const Vec3 u = normal.unitOrthogonal();
  const Vec3 v = normal.normalized().cross(u);
  std::vector<Vec2> flat;
  for (const Vec3& p : section.points) flat.emplace_back(u.dot(p), v.dot(p));
  std::vector<Vec3> line;
  for (const int i : convex_hull(flat)) line.push_back(section.points[i]);
  return line;
}

std::vector<Vec3> clipped(const std::vector<Vec3>& closed_line,
                          const std::vector<HalfSpace>& spaces) {
  // The sides are clipped one by one, then put in order from the longest gap on.
  const std::size_t n = closed_line.size();
  std::vector<std::pair<Vec3, Vec3>> sides;
  for (std::size_t i = 0; i < n; ++i) {
    Vec3 from = closed_line[i];
    Vec3 to = closed_line[(i + 1) % n];
    bool is_left = true;
    for (const HalfSpace& space : spaces) {
      const double a = space.inside.dot(from - space.origin);
      const double b = space.inside.dot(to - space.origin);
      if (a < 0 && b < 0) is_left = false;
      if (!is_left) break;
      const Vec3 at = a != b ? Vec3(from + a / (a - b) * (to - from)) : from;
      if (a < 0) from = at;
      if (b < 0) to = at;
    }
    if (is_left) sides.emplace_back(from, to);
  }
  if (sides.empty()) return {};
  std::size_t first = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::size_t before = (i + sides.size() - 1) % sides.size();
    if ((sides[i].first - sides[before].second).norm() > 1e-9) first = i;
  }
  std::vector<Vec3> line;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto& [from, to] = sides[(first + k) % sides.size()];
    if (line.empty() || (line.back() - from).norm() > 1e-12) line.push_back(from);
    line.push_back(to);
  }
  return line;
}

}  // namespace toile
