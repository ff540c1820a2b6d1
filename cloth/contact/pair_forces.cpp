#include "cloth/contact/pair_forces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "cloth/contact/constants.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

/// Metres: more than the error of a distance between two nearly parallel edges.
constexpr double approach_slack = 1e-6;

/// The share of their push that two edges get, by the angle between them.
struct EdgeShare {
  double share = 1;
  Vec3 first = Vec3::Zero();   // 1/m: derivative of the share by the first edge's vector
  Vec3 second = Vec3::Zero();  // 1/m: by the second edge's
  double curvature = 0;        // 1/m²: a bound of the second derivatives
};

EdgeShare share_of(const Vec3& a, const Vec3& b) {
  const double aa = a.squaredNorm();
  const double bb = b.squaredNorm();
  const double ab = a.dot(b);
  EdgeShare result;
  if (aa == 0 || bb == 0) return result;
  const double squared_sine = a.cross(b).squaredNorm() / (aa * bb);
  if (squared_sine >= parallel_squared_sine) return result;
  const double c = squared_sine / parallel_squared_sine;
  result.share = (2 - c) * c;
  const double slope = 2 * (1 - c) / parallel_squared_sine * 2 * ab / (aa * bb);
  result.first = slope * (ab / aa * a - b);
  result.second = slope * (ab / bb * b - a);
  result.curvature = 12 / (parallel_squared_sine * std::min(aa, bb));
  return result;
}

}  // namespace

void PairForces::activate(const std::vector<Vec3>& x, const std::vector<char>& ignored) {
  near_.resize(pairs_.size());
  parallel_for_chunks(pairs_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double reach = pairs_[i].gap + pair_activation_margin;
      const auto is_ignored = [&](int v) { return !ignored.empty() && ignored[v] != 0; };
      near_[i] =
          std::ranges::none_of(pairs_[i].vertices, is_ignored) && is_nearer(pairs_[i], x, reach);
    }
  });
  active_.clear();
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (near_[i] != 0) active_.push_back(pairs_[i]);
  }
  friction_.activate(active_);
  if (active_.empty()) return;
  slots_.assign(4 * active_.size(), Vec4{});
  apart_until_.assign(active_.size(), -1);
  pushed_at_.resize(x.size(), 0);
  lay_out_slots(x.size());
}

void PairForces::lay_out_slots(std::size_t vertices) {
  first_slot_.assign(vertices + 1, 0);
  for (const ContactPair& pair : active_) {
    for (const int v : pair.vertices) ++first_slot_[v + 1];
  }
  std::partial_sum(first_slot_.begin(), first_slot_.end(), first_slot_.begin());
  std::vector<int> next(first_slot_.begin(), first_slot_.end() - 1);
  slots_of_.resize(active_.size());
  for (std::size_t i = 0; i < active_.size(); ++i) {
    for (int j = 0; j < 4; ++j) slots_of_[i][j] = next[active_[i].vertices[j]]++;
  }
}

PairPush push_of(const ContactPair& pair, const std::array<Vec3, 4>& at, bool barrier,
                 double early) {
  const NearestPoints nearest = nearest_points(pair.edges, at);
  const double distance = nearest.apart.norm();
  const ContactPush push = contact_push(distance, pair.gap, barrier, early);
  PairPush result;
  result.nearest = nearest;
  const EdgeShare edges =
      pair.edges && push.stiffness > 0 ? share_of(at[1] - at[0], at[3] - at[2]) : EdgeShare{};
  result.force = edges.share * push.force;
  const Vec3 along = distance > 0 ? Vec3(result.force / distance * nearest.apart) : Vec3::Zero();
  // Edges that turn parallel lose energy, so the push also turns them.
  const Vec3 first = push.energy * edges.first;
  const Vec3 second = push.energy * edges.second;
  const std::array<Vec3, 4> turn = {first, -first, second, -second};
  for (int j = 0; j < 4; ++j) {
    result.on[j] = nearest.weights[j] * along + turn[j];
    result.stiffness[j] = 2 * edges.share * push.stiffness * std::abs(nearest.weights[j]) +
                          push.energy * edges.curvature;
  }
  return result;
}

void PairForces::push(std::size_t begin, std::size_t end, bool barrier, double early,
                      const Vec4s& x) {
  const double path = path_.length();
  for (std::size_t i = begin; i < end; ++i) {
    if (path < apart_until_[i]) continue;
    const auto& v = active_[i].vertices;
    const std::array<Vec3, 4> at = {as_vec3(x[v[0]]), as_vec3(x[v[1]]), as_vec3(x[v[2]]),
                                    as_vec3(x[v[3]])};
    // Each side moves no farther than the fastest vertex.
    const auto path_to = [&](double distance) {
      return path + 0.5 * (distance - active_[i].gap - early - approach_slack);
    };
    if (apart_until_[i] >= 0) {
      const double until = path_to(distance_bounds(active_[i], at).least);
      if (until > path) {
        apart_until_[i] = until;
        continue;
      }
    }
    const PairPush push = push_of(active_[i], at, barrier, early);
    keep_nearest(push.nearest, active_[i]);
    Vec4 on[4];
    for (int j = 0; j < 4; ++j) {
      on[j] = as_vec4(push.on[j]);
      on[j][3] = push.stiffness[j];
    }
    if (!friction_.empty()) friction_.add(i, push.nearest, push.force, x, on);
    for (int j = 0; j < 4; ++j) slots_[slots_of_[i][j]] = on[j];
    const double until = path_to(push.nearest.apart.norm());
    apart_until_[i] = until > path ? until : -1;
    if (until > path) continue;
    for (const int p : v) {
      std::atomic_ref(pushed_at_[p]).store(pushes_, std::memory_order_relaxed);
    }
  }
}

}  // namespace toile
