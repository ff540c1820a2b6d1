#include "cloth/springs/impulses.h"

namespace toile {

std::array<double, 4> movable_shares(const std::array<double, 3>& weights,
                                     const std::array<double, 3>& inverse_mass, double other) {
  const double both = inverse_mass_at(weights, inverse_mass) + other;
  std::array<double, 4> shares{};
  if (both <= 0) return shares;
  for (std::size_t i = 0; i < 3; ++i) shares[i] = weights[i] * inverse_mass[i] / both;
  shares[3] = -other / both;
  return shares;
}

std::array<double, 3> printed_triangle_shares(const std::array<double, 3>& weights) {
  const double squares = inverse_mass_at(weights, {1, 1, 1});
  std::array<double, 3> shares{};
  for (std::size_t i = 0; i < 3; ++i) shares[i] = 2 * weights[i] / (1 + squares);
  return shares;
}

std::array<double, 2> printed_edge_shares(double w1, double w2) {
  const double printed = w1 * w1 + (1 - w1 * w1) + w2 * w2 + (1 - w2 * w2);
  return {(1 - w1) / printed, w1 / printed};
}

}  // namespace toile
