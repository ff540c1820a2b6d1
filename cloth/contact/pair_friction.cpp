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
const PairGrip* grip_of(const ContactPair& pair, const std::vector<PairGrip>& sorted) {
  const auto found =
      std::lower_bound(sorted.begin(), sorted.end(), pair,
                       [](const PairGrip& a, const ContactPair& b) { return key(a) < key(b); });
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

std::vector<PairGrip> PairFriction::grips() const {
  std::vector<PairGrip> grips;
  for (const Rub& rub : rubs_) {
    if (rub.holds) grips.push_back(rub.grip);
  }
  std::sort(grips.begin(), grips.end(),
            [](const PairGrip& a, const PairGrip& b) { return key(a) < key(b); });
  return grips;
}

void PairFriction::activate(const std::vector<ContactPair>& pairs) {
  const std::vector<PairGrip> held = carried_.empty() ? grips() : std::move(carried_);
  carried_.clear();
  rubs_.clear();
  if (coefficients_.empty()) return;
  rubs_.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Rub& rub = rubs_[i];
    rub.friction = coefficient(pairs[i]);
    rub.grip = {pairs[i].vertices, pairs[i].edges, {}, Vec3::Zero()};
    const PairGrip* grip = grip_of(pairs[i], held);
    rub.holds = grip != nullptr;
    if (rub.holds) rub.grip = *grip;
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
  PairGrip& grip = rub.grip;
  if (!rub.holds) {
    rub.holds = true;
    grip.weights = nearest.weights;
    grip.anchor = Vec3::Zero();
  }
  Vec3 slip = -grip.anchor;
  for (int j = 0; j < 4; ++j) slip += grip.weights[j] * as_vec3(x[grip.vertices[j]]);
  const Vec3 normal = nearest.apart / distance;
  slip -= normal.dot(slip) * normal;
  const double most = rub.friction * push / rub_stiffness;
  const double squared = slip.squaredNorm();
  if (squared > most * most) {
    slip *= most / std::sqrt(squared);
    grip.weights = nearest.weights;
    grip.anchor = -slip;
  }
  for (int j = 0; j < 4; ++j) {
    Vec4 force = as_vec4(-rub_stiffness * grip.weights[j] * slip);
    force[3] = 2 * rub_stiffness * std::abs(grip.weights[j]);
    on_vertices[j] += force;
  }
}

}  // namespace toile
