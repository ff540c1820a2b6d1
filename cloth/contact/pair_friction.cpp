#include "cloth/contact/pair_friction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "cloth/contact/constants.h"

namespace toile {

namespace {

template <typename Pair>
auto key(const Pair& pair) {
  return std::tie(pair.vertices, pair.edges);
}

/// The anchor in `sorted` that belongs to `pair`; null without one.
const PairAnchor* anchor_of(const ContactPair& pair, const std::vector<PairAnchor>& sorted) {
  const auto found =
      std::lower_bound(sorted.begin(), sorted.end(), pair,
                       [](const PairAnchor& a, const ContactPair& b) { return key(a) < key(b); });
  return found != sorted.end() && key(*found) == key(pair) ? &*found : nullptr;
}

}  // namespace

void PairFriction::set_coefficients(std::vector<double> coefficients) {
  coefficients_ = std::move(coefficients);
  const bool any =
      std::any_of(coefficients_.begin(), coefficients_.end(), [](double c) { return c > 0; });
  if (!any) coefficients_.clear();
}

double PairFriction::coefficient(const ContactPair& pair) const {
  const auto mean = [&](int begin, int end) {
    double sum = 0;
    for (int j = begin; j < end; ++j) {
      const auto v = static_cast<std::size_t>(pair.vertices[j]);
      sum += v < coefficients_.size() ? coefficients_[v] : std::numeric_limits<double>::infinity();
    }
    return sum / (end - begin);
  };
  const int second = pair.edges ? 2 : 1;
  return std::min(mean(0, second), mean(second, 4));
}

std::vector<PairAnchor> PairFriction::anchors() const {
  std::vector<PairAnchor> anchors;
  for (const PairState& state : states_) {
    if (state.sticks) anchors.push_back(state.anchor);
  }
  std::sort(anchors.begin(), anchors.end(),
            [](const PairAnchor& a, const PairAnchor& b) { return key(a) < key(b); });
  return anchors;
}

void PairFriction::activate(const std::vector<ContactPair>& pairs) {
  const std::vector<PairAnchor> anchors =
      given_anchors_.empty() ? this->anchors() : std::move(given_anchors_);
  given_anchors_.clear();
  states_.clear();
  if (coefficients_.empty()) return;
  states_.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    PairState& state = states_[i];
    state.friction = coefficient(pairs[i]);
    state.anchor = {pairs[i].vertices, pairs[i].edges, {}, Vec3::Zero()};
    const PairAnchor* anchor = anchor_of(pairs[i], anchors);
    state.sticks = anchor != nullptr;
    if (state.sticks) state.anchor = *anchor;
  }
}

void PairFriction::add(std::size_t i, const NearestPoints& nearest, double push, const Vec4s& x,
                       Vec4* on_vertices) {
  PairState& state = states_[i];
  const double distance = nearest.apart.norm();
  if (push <= 0 || distance <= 0 || state.friction <= 0) {
    state.sticks = false;
    return;
  }
  PairAnchor& anchor = state.anchor;
  if (!state.sticks) {
    state.sticks = true;
    anchor.weights = nearest.weights;
    anchor.offset = Vec3::Zero();
  }
  Vec3 slip = -anchor.offset;
  for (int j = 0; j < 4; ++j) slip += anchor.weights[j] * as_vec3(x[anchor.vertices[j]]);
  const Vec3 normal = nearest.apart / distance;
  slip -= normal.dot(slip) * normal;
  const double max_slip = state.friction * push / pair_friction_stiffness;
  const double squared = slip.squaredNorm();
  if (squared > max_slip * max_slip) {
    slip *= max_slip / std::sqrt(squared);
    anchor.weights = nearest.weights;
    anchor.offset = -slip;
  }
  for (int j = 0; j < 4; ++j) {
    Vec4 force = as_vec4(-pair_friction_stiffness * anchor.weights[j] * slip);
    force[3] = 2 * pair_friction_stiffness * std::abs(anchor.weights[j]);
    on_vertices[j] += force;
  }
}

}  // namespace toile
