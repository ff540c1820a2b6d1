#include "cloth/relaxation/isotropic_shares.h"

#include <gtest/gtest.h>

namespace toile {
namespace isotropic_shares_test {

constexpr double edge = 0.01;  // metres

/// Six nodes: one group of four, and one that is not full.
struct Six {
  Six() {
    model.nodes = 6;
    model.shortest_edge.assign(6, edge);
  }
  /// Moves node n by `glides[n % 4]` times.
  void adapt(IsotropicShares& shares, const Vec4 (&glides)[4], const Vec4& stops) const {
    shares.adapt(0, 4, glides, stops);
    shares.adapt(4, 6, glides, stops);
  }
  GarmentModel model;
};

TEST(IsotropicShares, FollowTheMotionOfEachNode) {
  const Six six;
  IsotropicShares shares(six.model);
  const Vec4 none = {0, 0, 0, 0};
  const Vec4 fast = {2 * turning_glide * edge, 0, 0, 0};
  const Vec4 half = {0, 0.5 * turning_glide * edge, 0, 0};
  for (int i = 0; i < 1000; ++i) six.adapt(shares, {none, fast, half, none}, Vec4{0, 0, 0, 0});
  for (const int n : {0, 3, 4}) EXPECT_EQ(shares.of_nodes()[n], min_isotropic_share);
  for (const int n : {1, 5}) EXPECT_EQ(shares.of_nodes()[n], max_isotropic_share);
  EXPECT_NEAR(shares.of_nodes()[2], 0.5 * max_isotropic_share, 1e-15);
}

TEST(IsotropicShares, StayLargeWhereANodeTremblesOrIsStopped) {
  const Six six;
  IsotropicShares shares(six.model);
  const double little = 1e-3 * turning_glide * edge;
  for (int i = 0; i < 1000; ++i) {
    const Vec4 there_and_back = {i % 2 == 0 ? little : -little, 0, 0, 0};
    const Vec4 onward = {little, 0, 0, 0};
    six.adapt(shares, {there_and_back, onward, onward, onward}, Vec4{0, 0, 1, 0});
  }
  for (const int n : {0, 2, 4}) EXPECT_EQ(shares.of_nodes()[n], max_isotropic_share);
  for (const int n : {1, 3, 5}) EXPECT_EQ(shares.of_nodes()[n], min_isotropic_share);
}

}  // namespace isotropic_shares_test
}  // namespace toile
