#include "cloth/springs/collision_candidates.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cloth/springs/constants.h"
#include "geometry/closest_points.h"

namespace toile {

namespace {

/// Drops what is farther, of triangles without area what has no distance, and sorts the rest.
void keep_within(double reach, std::vector<Candidate>& list) {
  std::erase_if(list, [&](const Candidate& c) { return !(c.distance <= reach); });
  std::sort(list.begin(), list.end(), [](const Candidate& a, const Candidate& b) {
    if (a.distance != b.distance) return a.distance < b.distance;
    if (a.own != b.own) return a.own < b.own;
    return a.subject < b.subject;
  });
}

double segment_distance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto [s, t] = closest_on_segments(a, b, c, d);
  return (a + s * (b - a) - c - t * (d - c)).norm();
}

bool same(const ClothTriangle& a, const ClothTriangle& b) {
  return a.nodes == b.nodes && a.owns_node == b.owns_node && a.owns_side == b.owns_side;
}

}  // namespace

double NearTriangle::moved(const Triangle& nodes, const std::vector<Vec3>& x) const {
  double most = 0;
  for (int i = 0; i < 3; ++i) most = std::max(most, (x[nodes[i]] - at[i]).squaredNorm());
  return std::sqrt(most);
}

void CollisionCandidates::set_cloth(const std::vector<Triangle>& triangles) {
  const std::vector<ClothTriangle> before = std::move(cloth_);
  cloth_.assign(triangles.size(), {});
  std::set<int> nodes;
  std::map<std::pair<int, int>, std::pair<int, int>> sides;  // first triangle and side of an edge
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    ClothTriangle& own = cloth_[t];
    own.nodes = triangles[t];
    const Triangle& n = own.nodes;
    own.whole = n[0] != n[1] && n[1] != n[2] && n[2] != n[0];
    for (int i = 0; i < 3; ++i) {
      own.owns_node[i] = nodes.insert(n[i]).second;
      const int a = n[i];
      const int b = n[(i + 1) % 3];
      if (a == b) continue;
      const auto [first, is_new] = sides.try_emplace(std::minmax(a, b), t, i);
      own.owns_side[i] = is_new;
      if (is_new) continue;
      const auto [other, side] = first->second;
      own.across[i] = triangles[other][(side + 2) % 3];
      cloth_[other].across[side] = n[(i + 2) % 3];
    }
  }
  near_.resize(triangles.size());
  for (std::size_t t = 0; t < cloth_.size(); ++t) {
    if (t >= before.size() || !same(cloth_[t], before[t])) near_[t].reach = -1;
  }
}

const NearTriangle& CollisionCandidates::refreshed(int t, const std::vector<Vec3>& x, double reach,
                                                   double pair_reach, double margin) {
  const ClothTriangle& own = cloth_[t];
  NearTriangle& near = near_[t];
  if (near.reach >= 0) {
    const double needed = near.behind ? std::max(reach, behind_depth_) : reach;
    const double moved = near.moved(own.nodes, x);
    if (moved + needed <= near.reach && moved + pair_reach <= near.pair_reach) {
      if (!near.listed || moved <= stale_distance) return near;
      near.reach -= moved;
      near.pair_reach -= moved;
      for (int i = 0; i < 3; ++i) near.at[i] = x[own.nodes[i]];
      measure(near);
      return near;
    }
  }

  for (int i = 0; i < 3; ++i) near.at[i] = x[own.nodes[i]];
  near.reach = std::max(reach, behind_depth_) + margin;
  near.pair_reach = pair_reach + margin;
  near.facets.clear();
  near.edges.clear();
  near.vertices.clear();
  if (!near.listed) {
    const Vec3 middle = (near.at[0] + near.at[1] + near.at[2]) / 3;
    double radius = 0;
    for (const Vec3& corner : near.at) radius = std::max(radius, (corner - middle).norm());
    const double clear = subject_.distance(middle) - radius;
    if (clear > near.reach) {
      near.reach = clear;
      near.pair_reach = clear;
      near.behind = false;
      return near;
    }
  }
  ask(own, near);
  return near;
}

void CollisionCandidates::ask(const ClothTriangle& own, NearTriangle& near) const {
  const std::array<Vec3, 3>& at = near.at;
  const Vec3 pad = Vec3::Constant(near.reach);
  thread_local std::vector<int> facets;
  subject_.facets_in_box(at[0].cwiseMin(at[1]).cwiseMin(at[2]) - pad,
                         at[0].cwiseMax(at[1]).cwiseMax(at[2]) + pad, facets);
  for (const int facet : facets) {
    const Triangle& corners = subject_.mesh().triangles[facet];
    for (int i = 0; i < 3; ++i) {
      if (own.owns_node[i]) near.facets.push_back({0, i, facet});
      const int edge = subject_.facet_edges(facet)[i];
      if (subject_.owns_edge(facet, i) && subject_.edge(edge).ridge) {
        for (int side = 0; side < 3; ++side) {
          if (own.owns_side[side]) near.edges.push_back({0, side, edge});
        }
      }
      if (own.whole && subject_.owns_vertex(facet, i) && subject_.is_tip(corners[i])) {
        near.vertices.push_back({0, 0, corners[i]});
      }
    }
  }
  measure(near);
  near.listed = !facets.empty();
}

void CollisionCandidates::measure(NearTriangle& near) const {
  const std::array<Vec3, 3>& at = near.at;
  std::array<double, 3> nearest;
  nearest.fill(near.reach);
  std::array<bool, 3> behind = {};
  for (Candidate& c : near.facets) {
    const SubjectNearest found = subject_.nearest(at[c.own], c.subject);
    c.distance = std::abs(found.distance);
    if (c.distance >= nearest[c.own]) continue;
    nearest[c.own] = c.distance;
    behind[c.own] = found.distance < 0;
  }
  for (Candidate& c : near.edges) {
    const SubjectEdge& edge = subject_.edge(c.subject);
    c.distance = segment_distance(at[c.own], at[(c.own + 1) % 3], subject_.point(edge.a),
                                  subject_.point(edge.b));
  }
  for (Candidate& c : near.vertices) {
    const Vec3& vertex = subject_.point(c.subject);
    const Vec3 w = closest_on_triangle(vertex, at[0], at[1], at[2]);
    c.distance = (w[0] * at[0] + w[1] * at[1] + w[2] * at[2] - vertex).norm();
  }
  near.behind = behind[0] || behind[1] || behind[2];
  keep_within(near.reach, near.facets);
  keep_within(near.pair_reach, near.edges);
  keep_within(near.pair_reach, near.vertices);
}

}  // namespace toile
