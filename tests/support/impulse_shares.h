// Shares of a collision's impulse among nodes, as derived and as the paper prints them.
#pragma once

#include <array>
#include <cstddef>

#include "cloth/springs/contact.h"

namespace toile {

/// Velocity change of each node, as a share of the change that the point at `weights` shall make
/// against something motionless: (w_i/m_i) / (sum of w_j^2/m_j). The weighted sum of the shares is
/// 1, and the impulses m_i·share_i are those of one impulse at the point. All 0 when nothing can
/// move.
template <std::size_t N>
std::array<double, N> motionless_shares(const std::array<double, N>& weights,
                                        const std::array<double, N>& inverse_mass) {
  const double at_point = inverse_mass_at(weights, inverse_mass);
  std::array<double, N> shares{};
  if (at_point <= 0) return shares;
  for (std::size_t i = 0; i < N; ++i) shares[i] = weights[i] * inverse_mass[i] / at_point;
  return shares;
}

/// The shares of the change of the relative velocity where the other side moves too. Three nodes
/// and a point of inverse mass `other` take them, the point's last and negative. [Bridson, Fedkiw &
/// Anderson 2002] for equal masses and half the relative velocity.
inline std::array<double, 4> movable_shares(const std::array<double, 3>& weights,
                                            const std::array<double, 3>& inverse_mass,
                                            double other) {
  const double both = inverse_mass_at(weights, inverse_mass) + other;
  std::array<double, 4> shares{};
  if (both <= 0) return shares;
  for (std::size_t i = 0; i < 3; ++i) shares[i] = weights[i] * inverse_mass[i] / both;
  shares[3] = -other / both;
  return shares;
}

/// As [Zhong & Xu 2009] print it for a point in a garment triangle: 2 w_i / (1 + sum of w_j^2).
/// Right for four equal movable masses and half the relative velocity. Against the motionless
/// body it leaves the share 1 - 2S/(1 + S) of the approach, S = sum of w_j^2: a half at the
/// centroid.
inline std::array<double, 3> printed_triangle_shares(const std::array<double, 3>& weights) {
  const double squares = inverse_mass_at(weights, {1, 1, 1});
  std::array<double, 3> shares{};
  for (std::size_t i = 0; i < 3; ++i) shares[i] = 2 * weights[i] / (1 + squares);
  return shares;
}

/// As [Zhong & Xu 2009] print it for an edge: (1 - w1, w1) / (w1^2 + (1 - w1^2) + w2^2 + (1 -
/// w2^2)). The denominator is 2 whatever the weights. So a half of the approach is left at an end,
/// three quarters in the middle. w1 is the weight of the second node of the garment's edge, w2 of
/// the body's.
inline std::array<double, 2> printed_edge_shares(double w1, double w2) {
  const double printed = w1 * w1 + (1 - w1 * w1) + w2 * w2 + (1 - w2 * w2);
  return {(1 - w1) / printed, w1 / printed};
}

}  // namespace toile
