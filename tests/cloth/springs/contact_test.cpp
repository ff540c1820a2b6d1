#include "cloth/springs/contact.h"

#include <gtest/gtest.h>

#include <numeric>

namespace toile {
namespace contact_test {

/// A contact of nodes 0 to N - 1 with a floor that does not move.
template <std::size_t N>
Contact<N> contact_with_floor(const std::array<double, N>& weights,
                              const std::array<double, N>& inverse_mass) {
  Contact<N> contact{
      .nodes = {}, .weights = weights, .inverse_mass = inverse_mass, .normal = Vec3::UnitY()};
  std::iota(contact.nodes.begin(), contact.nodes.end(), 0);
  return contact;
}

/// Speeds upward that a contact gives to nodes that fall by 1 m/s.
template <std::size_t N>
std::array<double, N> gained(const std::array<double, N>& weights,
                             const std::array<double, N>& inverse_mass) {
  std::vector<Vec3> v(N, -Vec3::UnitY());
  Contact<N> contact = contact_with_floor(weights, inverse_mass);
  contact.solve(0, v);
  EXPECT_NEAR(contact.approach(v), 0, 1e-14);
  std::array<double, N> gain;
  for (std::size_t i = 0; i < N; ++i) gain[i] = v[i].y() + 1;
  return gain;
}

// Reference case 12: shares of one impulse, w_i / (sum of w_j^2). The paper's printed shares leave
// a half of the approach in the first row, and three quarters of it in the middle of an edge.
TEST(Contact, OneImpulseStopsAPointOfATriangle) {
  struct Row {
    std::array<double, 3> weights;
    double coefficient;
  };
  for (const auto& [weights, coefficient] :
       {Row{{1.0 / 3, 1.0 / 3, 1.0 / 3}, 3}, Row{{0.5, 0.5, 0}, 2},
        Row{{0.5, 0.25, 0.25}, 2.66666666666667}, Row{{0.6, 0.3, 0.1}, 2.17391304347826},
        Row{{0.8, 0.1, 0.1}, 1.51515151515151}, Row{{1, 0, 0}, 1}}) {
    const auto gain = gained<3>(weights, {1, 1, 1});
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(gain[i], coefficient * weights[i], 1e-11);
  }
}

TEST(Contact, OneImpulseStopsAPointOfAnEdge) {
  struct Row {
    double weight, coefficient;
  };
  for (const auto& [weight, coefficient] :
       {Row{0, 1}, Row{0.1, 1.21951219512195}, Row{0.25, 1.6}, Row{0.5, 2}}) {
    const auto gain = gained<2>({1 - weight, weight}, {1, 1});
    EXPECT_NEAR(gain[0], coefficient * (1 - weight), 1e-11);
    EXPECT_NEAR(gain[1], coefficient * weight, 1e-11);
  }
}

// The same case for masses of 0.5, 1 and 2 kg.
TEST(Contact, SharesFollowTheMasses) {
  const auto centroid = gained<3>({1.0 / 3, 1.0 / 3, 1.0 / 3}, {2, 1, 0.5});
  EXPECT_NEAR(centroid[0], 1.71428571428571, 1e-11);
  EXPECT_NEAR(centroid[1], 0.857142857142857, 1e-11);
  EXPECT_NEAR(centroid[2], 0.428571428571429, 1e-11);
  const auto corner = gained<3>({0.6, 0.3, 0.1}, {2, 1, 0.5});
  EXPECT_NEAR(corner[0], 1.47239263803681, 1e-11);
  EXPECT_NEAR(corner[1], 0.368098159509202, 1e-11);
  EXPECT_NEAR(corner[2], 0.0613496932515337, 1e-11);
}

TEST(Contact, HeldNodesTakeNothing) {
  EXPECT_EQ((gained<3>({0.2, 0.3, 0.5}, {0, 1, 2})[0]), 0);
  std::vector<Vec3> v(2, -Vec3::UnitY());
  EXPECT_EQ(contact_with_floor<2>({0.5, 0.5}, {0, 0}).solve(0, v), 0);
  EXPECT_EQ(v[0].y(), -1);
}

}  // namespace contact_test
}  // namespace toile
