#include "cloth/springs/crossing_guard.h"

#include <algorithm>
#include <span>

#include "cloth/springs/constants.h"
#include "geometry/closest_points.h"

namespace toile {

namespace {

class Guard {
 public:
  Guard(const CollisionStep& step, std::vector<Vec3>& v) : step_(step), v_(v) {}

  /// All speed is cut from now on, not only the speed towards the subject.
  void be_strict() { strict_ = true; }
  bool cut() const { return cut_; }
  void start_sweep() { cut_ = false; }

  void check(int t, const NearTriangle& near);

 private:
  double fastest(const Triangle& nodes) const {
    return std::max({v_[nodes[0]].norm(), v_[nodes[1]].norm(), v_[nodes[2]].norm()});
  }
  void pair(std::span<const int> nodes, const Vec3& away);

  const CollisionStep& step_;
  std::vector<Vec3>& v_;
  bool strict_ = false;
  bool cut_ = false;
};

void Guard::pair(std::span<const int> nodes, const Vec3& away) {
  const double distance = away.norm();
  if (distance < touching) return;
  const Vec3 direction = away / distance;
  const double slowest = -usable_distance_share * distance / step_.dt;
  bool crosses = false;
  for (const int node : nodes) {
    crosses = crosses || direction.dot(v_[node]) < slowest * (1 + 1e-9);
  }
  if (!crosses) return;
  for (const int node : nodes) {
    if (step_.inverse_mass[node] == 0) continue;
    cut_ = true;
    Vec3& v = v_[node];
    if (strict_) {
      v *= std::min(1.0, -slowest / v.norm());
    } else {
      v += std::max(0.0, slowest - direction.dot(v)) * direction;
    }
  }
}

void Guard::check(int t, const NearTriangle& near) {
  const SubjectSurface& subject = step_.subject;
  const Triangle& nodes = step_.cloth[t].nodes;
  const double moved = near.moved(nodes, step_.x);
  const double reach = fastest(nodes) * step_.dt / usable_distance_share;
  for (const Candidate& c : near.facets) {
    if (c.distance - moved > reach) break;
    const int node = nodes[c.own];
    const SubjectNearest nearest = subject.nearest(step_.x[node], c.subject);
    if (nearest.distance >= 0) pair({&node, 1}, nearest.distance * nearest.direction);
  }
  for (const Candidate& c : near.edges) {
    if (c.distance - moved > reach) break;
    const SubjectEdge& edge = subject.edge(c.subject);
    const std::array<int, 2> ends = {nodes[c.own], nodes[(c.own + 1) % 3]};
    const Vec3& p1 = step_.x[ends[0]];
    const Vec3& p2 = step_.x[ends[1]];
    const Vec3& q1 = subject.point(edge.a);
    const Vec3& q2 = subject.point(edge.b);
    const auto [s, u] = closest_on_segments(p1, p2, q1, q2);
    const Vec3 away = p1 + s * (p2 - p1) - q1 - u * (q2 - q1);
    if (edge.rim || away.dot(edge.normal) >= 0) pair(ends, away);
  }
  for (const Candidate& c : near.vertices) {
    if (c.distance - moved > reach) break;
    const Vec3& q = subject.point(c.subject);
    const Vec3 w = closest_on_triangle(q, step_.x[nodes[0]], step_.x[nodes[1]], step_.x[nodes[2]]);
    if (!w.allFinite()) continue;
    const Vec3 away =
        w[0] * step_.x[nodes[0]] + w[1] * step_.x[nodes[1]] + w[2] * step_.x[nodes[2]] - q;
    if (subject.on_rim(c.subject) || away.dot(subject.vertex_normal(c.subject)) >= 0) {
      pair(nodes, away);
    }
  }
}

}  // namespace

bool keep_from_crossing(const CollisionStep& step, const std::vector<int>& triangles,
                        const CollisionCandidates& near, std::vector<Vec3>& v) {
  Guard guard(step, v);
  bool any = false;
  // The strict sweep only shortens velocities, which breaks no pair that is already kept.
  for (int sweep = 0; sweep <= guard_sweeps; ++sweep) {
    guard.start_sweep();
    if (sweep == guard_sweeps) guard.be_strict();
    for (const int t : triangles) guard.check(t, near.near(t));
    if (!guard.cut()) break;
    any = true;
  }
  return any;
}

}  // namespace toile
