#include "geometry/body/skin_weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/body/mannequin/mannequin.h"

namespace toile {
namespace skin_weights_test {

// Along a tube the harmonic weight rises evenly, so the result is known.
TEST(SkinWeights, RiseAlongATubeAsTheirFormulaSays) {
  constexpr int around = 24;
  constexpr int rows = 41;
  TriangleMesh tube;
  std::vector<int> cores;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      tube.points.emplace_back(0.05 * std::cos(angle), 0.01 * row, 0.05 * std::sin(angle));
      cores.push_back(row == 0 ? 0 : row == rows - 1 ? 1 : SkinCores::no_bone);
    }
  }
  for (int row = 0; row + 1 < rows; ++row) {
    for (int i = 0; i < around; ++i) {
      const int a = row * around + i;
      const int b = row * around + (i + 1) % around;
      tube.triangles.push_back({a, a + around, b});
      tube.triangles.push_back({b, a + around, b + around});
    }
  }
  const SkinWeights weights = skin_weights(tube, cores);
  for (int row = 0; row < rows; ++row) {
    const double h = row / (rows - 1.0);
    EXPECT_NEAR(weights(row * around + 5, 1), h * h * (3 - 2 * h), 2e-3) << row;
    EXPECT_NEAR(weights.row(row * around).sum(), 1, 1e-12);
  }
}

TEST(SkinWeights, OfABodyAreBoundedAndFollowItsCores) {
  const Mannequin made = make_mannequin({.edge_length = 0.014});
  const SkinCores cores = skin_cores(made.surface, made.skeleton, "mannequin");
  const SkinWeights weights = skin_weights(made.surface, cores.bone_of);
  EXPECT_GE(weights.minCoeff(), 0);
  EXPECT_LE(weights.maxCoeff(), 1);
  EXPECT_LT((weights.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-12);
  for (std::size_t i = 0; i < cores.bone_of.size(); ++i) {
    if (cores.bone_of[i] == SkinCores::no_bone) continue;
    EXPECT_EQ(weights(static_cast<Eigen::Index>(i), cores.bone_of[i]), 1);
  }
}

}  // namespace skin_weights_test
}  // namespace toile
