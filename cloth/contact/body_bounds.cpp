#include "cloth/contact/body_bounds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "cloth/contact/clip_to_ball.h"
#include "cloth/contact/constants.h"
#include "geometry/closest_points.h"
#include "geometry/columns.h"
#include "geometry/parallel.h"
#include "geometry/triangle_tree.h"

namespace toile {

namespace {

/// Metres between a plane and the facets behind it. It is far above what rounding can do.
constexpr double safety = 1e-7;
constexpr double infinite = std::numeric_limits<double>::infinity();
/// Regions that one task updates. Often only a few are due, and each takes microseconds.
constexpr std::size_t nodes_of_a_task = 8;

/// Whether an edge of `s` passes through the triangle `t`, or touches it, up to rounding.
bool pierces(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const std::array<double, 3> above = {normal.dot(s[0] - t[0]), normal.dot(s[1] - t[0]),
                                       normal.dot(s[2] - t[0])};
  for (int e = 0; e < 3; ++e) {
    const Vec3& a = s[e];
    const Vec3& b = s[(e + 1) % 3];
    if (above[e] * above[(e + 1) % 3] > 0) continue;
    int positive = 0;
    int negative = 0;
    for (int i = 0; i < 3; ++i) {
      const double side = (b - a).dot((t[i] - a).cross(t[(i + 1) % 3] - a));
      positive += side >= 0;
      negative += side <= 0;
    }
    if (positive == 3 || negative == 3) return true;
  }
  return false;
}

/// Metres between two triangles; 0 where they intersect.
double distance_of(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t) {
  if (pierces(s, t) || pierces(t, s)) return 0;
  double squared = std::numeric_limits<double>::max();
  for (int i = 0; i < 3; ++i) {
    const Vec3 on_t = closest_on_triangle(s[i], t[0], t[1], t[2]);
    squared =
        std::min(squared, (s[i] - on_t[0] * t[0] - on_t[1] * t[1] - on_t[2] * t[2]).squaredNorm());
    const Vec3 on_s = closest_on_triangle(t[i], s[0], s[1], s[2]);
    squared =
        std::min(squared, (t[i] - on_s[0] * s[0] - on_s[1] * s[1] - on_s[2] * s[2]).squaredNorm());
    for (int j = 0; j < 3; ++j) {
      const Vec3& a = s[i];
      const Vec3& b = s[(i + 1) % 3];
      const Vec3& c = t[j];
      const Vec3& d = t[(j + 1) % 3];
      const auto [u, v] = closest_on_segments(a, b, c, d);
      squared = std::min(squared, (a + u * (b - a) - c - v * (d - c)).squaredNorm());
    }
  }
  return std::sqrt(squared);
}

/// The least and the largest of some numbers.
struct Range {
  double low = std::numeric_limits<double>::max();
  double high = -std::numeric_limits<double>::max();

  void add(double number) {
    low = std::min(low, number);
    high = std::max(high, number);
  }
  void add(const Range& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

double gap(const Range& a, const Range& b) { return std::max(a.low - b.high, b.low - a.high); }

Range range_along(const Vec3& direction, const std::array<Vec3, 3>& corners) {
  Range range;
  for (const Vec3& corner : corners) range.add(direction.dot(corner));
  return range;
}

/// Whether two triangles are more than `distance` (metres) apart along x, y or z.
bool boxes_apart(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t, double distance) {
  const Vec3 above = t[0].cwiseMin(t[1]).cwiseMin(t[2]) - s[0].cwiseMax(s[1]).cwiseMax(s[2]);
  const Vec3 below = s[0].cwiseMin(s[1]).cwiseMin(s[2]) - t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  return above.cwiseMax(below).maxCoeff() > distance;
}

}  // namespace

BodyBounds::BodyBounds(const Collider& collider, const std::vector<Triangle>& triangles,
                       std::size_t vertices)
    : collider_(collider),
      triangles_(triangles),
      corners_(corners_by_vertex(triangles, vertices)),
      regions_(triangles.size()),
      due_(triangles.size(), 1),
      next_update_(triangles.size(), 0),
      extra_offset_(vertices, 0) {
  bounds_.assign(3 * triangles.size(), {Vec4{}, Vec4{0, 0, 0, -infinite}});
  bounds_of_.resize(triangles.size());
  int next = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    for (const auto& [t, corner] : corners_[v]) bounds_of_[t][corner] = next++;
  }
}

BodyBounds::CornerBound BodyBounds::corner_bound(const Region& region, int corner) const {
  CornerBound bound = {as_vec4(region.at[corner]), as_vec4(region.normal)};
  const bool has_plane = !region.intersects && region.normal != Vec3::Zero();
  bound.ball[3] = region.intersects ? infinite : region.reach;
  bound.plane[3] = has_plane ? region.level : -infinite;
  return bound;
}

BodyBounds::Region BodyBounds::region_of(const Triangle& corners, const Vec4s& x, int near_facet,
                                         std::vector<int>& near) const {
  Region region;
  region.at = {as_vec3(x[corners[0]]), as_vec3(x[corners[1]]), as_vec3(x[corners[2]])};
  const auto& p = region.at;
  const Vec3 centre = (p[0] + p[1] + p[2]) / 3;
  const double radius =
      std::sqrt(std::max({(p[0] - centre).squaredNorm(), (p[1] - centre).squaredNorm(),
                          (p[2] - centre).squaredNorm()}));
  SurfacePoint hint;
  hint.triangle = near_facet;
  const SurfacePoint nearest_point = collider_.skin().closest_point(centre, hint);
  region.facet = nearest_point.triangle;
  region.intersects = nearest_point.distance < 0;
  if (region.intersects) return region;
  const double sphere_clearance = nearest_point.distance - radius;
  if (sphere_clearance > facet_search_distance) {
    region.reach = sphere_clearance - safety;
    return region;
  }
  region.reach = facet_search_distance;
  near.clear();
  const Vec3 margin = Vec3::Constant(facet_search_distance);
  collider_.skin().tree().meeting(p[0].cwiseMin(p[1]).cwiseMin(p[2]) - margin,
                                  p[0].cwiseMax(p[1]).cwiseMax(p[2]) + margin, near);
  if (near.empty()) return region;

  const TriangleMesh& body = collider_.body();
  // Candidates for a plane with all facets behind it: square to the gradient of the distance, or
  // parallel to the triangle.
  const Vec3 own = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
  const Vec3 out = collider_.grid().at(centre).gradient.normalized();
  const auto corners_of = [&body](int f) -> std::array<Vec3, 3> {
    const Triangle& c = body.triangles[f];
    return {body.points[c[0]], body.points[c[1]], body.points[c[2]]};
  };
  Range all_out;
  Range all_own;
  for (const int f : near) {
    all_out.add(range_along(out, corners_of(f)));
    all_own.add(range_along(own, corners_of(f)));
  }
  const std::pair<Vec3, double> planes[] = {
      {out, all_out.high}, {own, all_own.high}, {-own, -all_own.low}};
  for (const auto& [normal, highest] : planes) {
    const double lowest = std::min({normal.dot(p[0]), normal.dot(p[1]), normal.dot(p[2])});
    // With half of the safety, a corner that was stopped at its level may slide along it.
    const double slack = lowest - highest - 0.5 * safety;
    if (slack <= 0 || (region.normal != Vec3::Zero() && slack <= region.slack)) continue;
    region.normal = normal;
    region.level = highest + safety;
    region.slack = slack;
  }
  if (region.normal != Vec3::Zero() && region.slack >= facet_clearance) return region;
  // The facet nearest to the middle comes first, for it rules out most of the others: those that
  // are farther along any of the axes.
  const auto first = std::ranges::find(near, region.facet);
  if (first != near.end()) std::iter_swap(near.begin(), first);
  const Range along_out = range_along(out, p);
  const Range along_own = range_along(own, p);
  double nearest = facet_search_distance;
  for (const int f : near) {
    const std::array<Vec3, 3> facet = corners_of(f);
    const double ruled_out = nearest + safety;
    if (gap(range_along(out, facet), along_out) > ruled_out ||
        gap(range_along(own, facet), along_own) > ruled_out || boxes_apart(p, facet, ruled_out)) {
      continue;
    }
    nearest = std::min(nearest, distance_of(p, facet));
  }
  region.extra_offset = std::max(facet_clearance - nearest, 0.0);
  if (region.normal != Vec3::Zero() && nearest < facet_clearance) return region;
  // In an armpit, or another hollow of the body, there may be no plane above all facets although
  // the triangle is well clear of them. Or there is one that would stop it.
  region.normal = Vec3::Zero();
  region.intersects = nearest == 0;
  region.reach = std::max(nearest - safety, 0.0);
  return region;
}

const std::vector<int>& BodyBounds::update(const Vec4s& x) {
  updated_.clear();
  std::vector<int> due;
  ++updates_;
  any_due_ = false;
  const auto next_due = [&](std::size_t from) {
    const void* at = std::memchr(due_.data() + from, 1, due_.size() - from);
    return at == nullptr ? due_.size()
                         : static_cast<std::size_t>(static_cast<const char*>(at) - due_.data());
  };
  for (std::size_t t = next_due(0); t < due_.size(); t = next_due(t + 1)) {
    if (updates_ < next_update_[t]) {
      any_due_ = true;
      continue;
    }
    due_[t] = 0;
    next_update_[t] = updates_ + region_update_interval;
    due.push_back(static_cast<int>(t));
  }
  parallel_for(chunks_of(due.size(), nodes_of_a_task), [&](std::size_t c) {
    std::vector<int> near;
    const std::size_t end = std::min(due.size(), (c + 1) * nodes_of_a_task);
    for (std::size_t i = c * nodes_of_a_task; i < end; ++i) {
      Region& region = regions_[due[i]];
      region = region_of(triangles_[due[i]], x, region.facet, near);
      for (int k = 0; k < 3; ++k) bounds_[bounds_of_[due[i]][k]] = corner_bound(region, k);
    }
  });
  std::map<int, double> lifted;
  for (const int t : due) {
    for (const int v : triangles_[t]) {
      if (regions_[t].extra_offset > 0) lifted[v] = std::max(lifted[v], regions_[t].extra_offset);
    }
    updated_.insert(updated_.end(), triangles_[t].begin(), triangles_[t].end());
  }
  for (const auto& [v, more] : lifted)
    extra_offset_[v] = std::min(extra_offset_[v] + more, max_facet_lift);
  std::sort(updated_.begin(), updated_.end());
  updated_.erase(std::unique(updated_.begin(), updated_.end()), updated_.end());
  return updated_;
}

void BodyBounds::make_due(int triangle) {
  std::atomic_ref(due_[triangle]).store(1, std::memory_order_relaxed);
  any_due_.store(true, std::memory_order_relaxed);
}

/// Four corners at a time.
TOILE_CLONES
double BodyBounds::free_radius(int vertex, const Vec3& p) const {
  const auto corners = corners_[vertex];
  if (corners.empty()) return std::numeric_limits<double>::max();
  const CornerBound* const bounds = &bounds_[bounds_of_[corners[0].triangle][corners[0].corner]];
  const Vec4 x = repeated(p.x());
  const Vec4 y = repeated(p.y());
  const Vec4 z = repeated(p.z());
  Vec4 radius = repeated(std::numeric_limits<double>::max());
  for (std::size_t first = 0; first < corners.size(); first += 4) {
    const auto at = [&](std::size_t i) -> const CornerBound& {
      return bounds[std::min(first + i, corners.size() - 1)];
    };
    Vec4 reach;
    const Columns ball = columns_of(at(0).ball, at(1).ball, at(2).ball, at(3).ball, &reach);
    const Columns away = {x - ball.x, y - ball.y, z - ball.z};
    // The order of the sums is that of Vec3's norm and product.
    const Vec4 left = reach - square_root(away.x * away.x + (away.y * away.y + away.z * away.z));
    Vec4 level;
    const Columns normal = columns_of(at(0).plane, at(1).plane, at(2).plane, at(3).plane, &level);
    const Vec4 above = normal.x * x + (normal.y * y + normal.z * z) - level;
    radius = smaller(above, smaller(left, radius));
  }
  return std::max(std::min({radius[0], radius[1], radius[2], radius[3]}), 0.0);
}

double BodyBounds::allowed_share(int vertex, const Vec3& p, const Vec3& wanted, Vec3* stopped_by) {
  double share = 1;
  if (stopped_by != nullptr) *stopped_by = Vec3::Zero();
  const Vec3 displacement = wanted - p;
  for (const auto& [t, corner] : corners_[vertex]) {
    const Region& region = regions_[t];
    if (region.intersects) continue;
    const Vec3 away = p - region.at[corner];
    if ((away + displacement).norm() > (1 - due_region_share) * region.reach) make_due(t);
    const double in_ball = clip_to_ball(away, displacement, region.reach);
    if (in_ball < share && stopped_by != nullptr) *stopped_by = Vec3::Zero();
    share = std::min(share, in_ball);
    if (region.normal == Vec3::Zero()) continue;
    const double from = region.normal.dot(p) - region.level;
    const double to = region.normal.dot(wanted) - region.level;
    if (to < due_region_share * region.slack) make_due(t);
    if (to >= 0 || to >= from) continue;
    // Slightly less, for the quotient may round to the outside.
    constexpr double inside = 1 - 1e-9;
    const double own = std::clamp(from / (from - to) * inside, 0.0, 1.0);
    if (own < share && stopped_by != nullptr) *stopped_by = region.normal;
    share = std::min(share, own);
  }
  return share;
}

Vec3 BodyBounds::reached(int vertex, const Vec3& p, const Vec3& wanted) {
  // In a corner of three planes there is nowhere to slide.
  constexpr int most_planes = 3;
  Vec3 to = wanted;
  Vec3 normal;
  for (int i = 0; i < most_planes; ++i) {
    const double share = allowed_share(vertex, p, to, &normal);
    if (share >= 1) return to;
    if (normal == Vec3::Zero()) break;
    to -= (1 - share) * normal.dot(to - p) * normal;
  }
  return p + allowed_share(vertex, p, to) * (to - p);
}

void BodyBounds::recheck_intersecting() {
  for (std::size_t t = 0; t < regions_.size(); ++t) {
    if (regions_[t].intersects) make_due(static_cast<int>(t));
  }
}

}  // namespace toile
