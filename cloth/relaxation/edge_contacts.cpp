#include "cloth/relaxation/edge_contacts.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

namespace toile {

namespace {

/// Edges or vertices that one task handles; fixed, so that sums don't depend on the threads.
constexpr std::size_t chunk = 512;

template <typename Work>
void in_chunks(std::size_t items, const Work& work) {
  tbb::parallel_for(
      std::size_t{0}, (items + chunk - 1) / chunk,
      [&](std::size_t c) { work(c * chunk, std::min(items, (c + 1) * chunk)); },
      tbb::static_partitioner());
}

}  // namespace

EdgeContacts::EdgeContacts(const std::vector<Triangle>& triangles, const Vec4s& x,
                           double shortest) {
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      const int a = std::min(t[i], t[(i + 1) % 3]);
      const int b = std::max(t[i], t[(i + 1) % 3]);
      const Vec4 along = x[b] - x[a];
      if (squared_length(along) > shortest * shortest) edges_.push_back({a, b});
    }
  }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  if (edges_.empty()) return;
  contacts_.resize(edges_.size());
  forces_.assign(edges_.size(), Vec4{});
  first_.assign(x.size() + 1, 0);
  for (const auto& edge : edges_) {
    for (const int v : edge) ++first_[v + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  of_vertex_.resize(2 * edges_.size());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    for (const int v : edges_[e]) of_vertex_[next[v]++] = static_cast<int>(e);
  }
}

void EdgeContacts::look_anew() {
  for (BodyContact& contact : contacts_) contact.forget();
}

void EdgeContacts::add(const Scene& scene, double offset, const std::vector<double>& friction,
                       const std::vector<int>& node, bool rubbing, const Vec4s& x, Vec4s& force) {
  in_chunks(edges_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const auto [a, b] = edges_[e];
      const Vec4 middle = 0.5 * (x[a] + x[b]);
      const Vec3 p = as_vec3(middle);
      if (contacts_[e].remaining(p) <= 0) contacts_[e].look(scene, p, offset);
      Vec4 sum = {0, 0, 0, 0};
      double stiffness = 0;
      const double rub = rubbing ? friction[node.empty() ? a : node[a]] : 0;
      contacts_[e].add(middle, rub, sum, stiffness);
      forces_[e] = 0.5 * sum;
      forces_[e][3] = 0.5 * stiffness;
    }
  });
  in_chunks(first_.size() - 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      for (int i = first_[v]; i < first_[v + 1]; ++i) force[v] += forces_[of_vertex_[i]];
    }
  });
}

}  // namespace toile
