#include "cloth/relaxation/edge_contacts.h"

#include <algorithm>

namespace toile {

EdgeContacts::EdgeContacts(const std::vector<Triangle>& triangles, const Vec4s& x, double shortest,
                           const std::vector<double>& friction,
                           const std::vector<double>& approach_bound) {
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
  for (const auto& [a, b] : edges_) friction_.push_back(0.5 * (friction[a] + friction[b]));
  for (const auto& [a, b] : edges_)
    approach_bound_.push_back(std::max(approach_bound[a], approach_bound[b]));
  forces_.assign(edges_.size(), Vec4{});
  free_balls_.assign(edges_.size(), Vec4{});
  pushed_.assign(edges_.size(), 0);
  edges_of_ = Adjacency<int>(x.size(), [&](const auto& add) {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      for (const int v : edges_[e]) add(v, static_cast<int>(e));
    }
  });
}

void EdgeContacts::forget() {
  for (BodyContact& contact : contacts_) contact.forget();
  free_balls_.assign(edges_.size(), Vec4{});
}

std::vector<EdgeAnchor> EdgeContacts::anchors() const {
  std::vector<EdgeAnchor> anchors;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto anchor = contacts_[e].anchor();
    if (anchor) anchors.push_back({edges_[e], *anchor});
  }
  return anchors;
}

void EdgeContacts::set_anchors(const std::vector<EdgeAnchor>& anchors) {
  for (const EdgeAnchor& anchor : anchors) {
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), anchor.edge);
    if (found == edges_.end() || *found != anchor.edge) continue;
    contacts_[found - edges_.begin()].set_anchor(anchor.position);
  }
}

TOILE_CLONES
void EdgeContacts::push(std::size_t begin, std::size_t end, const GarmentModel& model,
                        const ForceOptions& options, const Vec4s& x) {
  for (std::size_t e = begin; e < end; ++e) {
    const auto [a, b] = edges_[e];
    const Vec4 middle = 0.5 * (x[a] + x[b]);
    pushed_[e] = 0;
    const Vec4 away = middle - free_balls_[e];
    if (squared_length(away) < free_balls_[e][3]) continue;
    pushed_[e] = 1;
    const Vec3 p = as_vec3(middle);
    if (contacts_[e].remaining(p) <= 0) {
      contacts_[e].linearize(model.scene, p, model.body_offset, options.linearization_radius,
                             approach_bound_[e], options.firm_push);
      const double reach = contacts_[e].near() ? 0 : contacts_[e].remaining(p);
      free_balls_[e] = middle;
      free_balls_[e][3] = reach * reach;
    }
    Vec4 sum = {0, 0, 0, 0};
    double stiffness = 0;
    contacts_[e].add(middle, options.friction ? friction_[e] : 0, sum, stiffness);
    forces_[e] = 0.5 * sum;
    forces_[e][3] = 0.5 * stiffness;
  }
}

TOILE_CLONES
void EdgeContacts::add(std::size_t begin, std::size_t end, Vec4s& force) const {
  for (std::size_t v = begin; v < end; ++v) {
    for (const int e : edges_of_[v]) {
      if (pushed_[e] != 0) force[v] += forces_[e];
    }
  }
}

}  // namespace toile
