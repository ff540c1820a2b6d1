#include "cloth/contact/pair_friction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace toile {

namespace {

/// N/m. A garment is held by hundreds of pairs: its weight moves them by micrometres.
constexpr double rub_stiffness = 50;

template <typename Pair>
auto key(const Pair& pair) {
  return std::tie(pair.vertices, pair.edges);
}

/// The one of `sorted` with the same vertices; none: null.
const PairAnchor* grip_of(const ContactPair& pair, const std::vector<PairAnchor>& sorted) {
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
  for (const Rub& rub : rubs_) {
    if (rub.holds) anchors.push_back(rub.warm_start);
  }
  std::sort(anchors.begin(), anchors.end(),
            [](const PairAnchor& a, const PairAnchor& b) { return key(a) < key(b); });
  return anchors;
}

void PairFriction::activate(const std::vector<ContactPair>& pairs) {
  const std::vector<PairAnchor> held = carried_.empty() ? anchors() : std::move(carried_);
  carried_.clear();
  rubs_.clear();
  if (coefficients_.empty()) return;
  rubs_.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Rub& rub = rubs_[i];
    rub.friction = coefficient(pairs[i]);
    rub.warm_start = {pairs[i].vertices, pairs[i].edges, {}, Vec3::Zero()};
    const PairAnchor* warm_start = grip_of(pairs[i], held);
    rub.holds = warm_start != nullptr;
    if (rub.holds) rub.warm_start = *warm_start;
  }
}

void PairFriction::rub(std::size_t i, const NearestPoints& nearest, double push, const Vec4s& x,
                       Vec4* on_vertices) {
  Rub& rub = rubs_[i];
  const double distance = nearest.apart.norm();
  if (push <= 0 || distance <= 0 || rub.friction <= 0) {
    rub.holds = false;
    return;
  }
  PairAnchor& warm_start = rub.warm_start;
  if (!rub.holds) {
    rub.holds = true;
    warm_start.weights = nearest.weights;
    warm_start.anchor = Vec3::Zero();
  }
  Vec3 slip = -warm_start.anchor;
  for (int j = 0; j < 4; ++j) slip += warm_start.weights[j] * as_vec3(x[warm_start.vertices[j]]);
  const Vec3 normal = nearest.apart / distance;
  slip -= normal.dot(slip) * normal;
  const double most = rub.friction * push / rub_stiffness;
  const double squared = slip.squaredNorm();
  if (squared > most * most) {
    slip *= most / std::sqrt(squared);
    warm_start.weights = nearest.weights;
    warm_start.anchor = -slip;
  }
  for (int j = 0; j < 4; ++j) {
    Vec4 force = as_vec4(-rub_stiffness * warm_start.weights[j] * slip);
    force[3] = 2 * rub_stiffness * std::abs(warm_start.weights[j]);
    on_vertices[j] += force;
  }
}

}  // namespace toile
