#include "cloth/ease/mean_curvature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace toile {
namespace mean_curvature_test {

/// A tube of radius r along y, open at both ends, whose triangles face outwards.
TriangleMesh tube(double r, int around, int rows) {
  TriangleMesh mesh;
  const double step = 2 * std::numbers::pi * r / around;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5 * (j % 2)) / around;
      mesh.points.emplace_back(r * std::sin(angle), 0.866 * step * j, r * std::cos(angle));
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < around; ++i) {
      const int l = (i + 1) % around;
      const int a = j * around + i;
      const int b = j * around + l;
      const int c = a + around;
      const int d = b + around;
      if (j % 2 == 0) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({b, d, c});
      } else {
        mesh.triangles.push_back({a, d, c});
        mesh.triangles.push_back({a, b, d});
      }
    }
  }
  return mesh;
}

TEST(MeanCurvature, OfATubeIsHalfOfOneOverItsRadius) {
  for (const double r : {0.05, 0.2}) {
    TriangleMesh mesh = tube(r, 48, 8);
    const std::vector<double> outwards = mean_curvatures(mesh);
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    const std::vector<double> inwards = mean_curvatures(mesh);
    for (int i = 48; i < 8 * 48; ++i) {
      EXPECT_NEAR(outwards[i], 0.5 / r, 0.02 / r);
      EXPECT_NEAR(inwards[i], -0.5 / r, 0.02 / r);
    }
    for (int i = 0; i < 48; ++i) EXPECT_EQ(outwards[i], 0) << "of the border";
  }
}

TEST(MeanCurvature, OfAFlatSheetIsZero) {
  TriangleMesh mesh;
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 5; ++i) mesh.points.emplace_back(i + 0.3 * (j % 2), 1.2 * j, 0.5 * j);
  }
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const int a = 5 * j + i;
      mesh.triangles.push_back({a, a + 1, a + 6});
      mesh.triangles.push_back({a, a + 6, a + 5});
    }
  }
  mesh.triangles.push_back({0, 0, 1});  // of no area
  for (const double curvature : mean_curvatures(mesh)) EXPECT_NEAR(curvature, 0, 1e-9);
}

}  // namespace mean_curvature_test
}  // namespace toile
