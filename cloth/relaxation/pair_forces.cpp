#include "cloth/relaxation/pair_forces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace toile {

void PairForces::activate(const std::vector<Vec3>& x) {
  active_.clear();
  for (const ContactPair& pair : pairs_) {
    const auto& v = pair.vertices;
    const double reach = pair.gap + margin;
    if (nearest_points(pair.edges, {x[v[0]], x[v[1]], x[v[2]], x[v[3]]}).apart.squaredNorm() <
        reach * reach) {
      active_.push_back(pair);
    }
  }
  first_.clear();
  if (active_.empty()) return;
  slots_.assign(4 * active_.size(), Vec4{});
  first_.assign(x.size() + 1, 0);
  for (const ContactPair& pair : active_) {
    for (const int v : pair.vertices) ++first_[v + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  gather_.resize(4 * active_.size());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < active_.size(); ++i) {
    for (int j = 0; j < 4; ++j)
      gather_[next[active_[i].vertices[j]]++] = static_cast<int>(4 * i + j);
  }
}

void PairForces::push(std::size_t begin, std::size_t end, bool barrier, const Vec4s& x) {
  for (std::size_t i = begin; i < end; ++i) {
    const auto& v = active_[i].vertices;
    const NearestPoints nearest = nearest_points(
        active_[i].edges, {as_vec3(x[v[0]]), as_vec3(x[v[1]]), as_vec3(x[v[2]]), as_vec3(x[v[3]])});
    const double distance = nearest.apart.norm();
    const auto [push, stiffness] = contact_push(distance, active_[i].gap, barrier);
    const Vec3 force = distance > 0 ? Vec3(push / distance * nearest.apart) : Vec3::Zero();
    for (int j = 0; j < 4; ++j) {
      Vec4 slot = as_vec4(nearest.weights[j] * force);
      slot[3] = 2 * stiffness * std::abs(nearest.weights[j]);
      slots_[4 * i + j] = slot;
    }
  }
}

}  // namespace toile
