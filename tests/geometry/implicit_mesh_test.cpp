#include "geometry/implicit_mesh.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "geometry/error.h"

namespace toile {
namespace implicit_mesh_test {

ImplicitMeshOptions box(double half, double spacing) {
  ImplicitMeshOptions options;
  options.low = Vec3::Constant(-half);
  options.high = Vec3::Constant(half);
  options.spacing = spacing;
  return options;
}

double ball(const Vec3& p) { return p.norm() - 0.1; }

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])) / 6;
  }
  return sum;
}

/// V - E + F. It checks that every edge has two triangles that run along it in opposite directions.
int euler(const TriangleMesh& mesh) {
  std::map<std::array<int, 2>, int> blocks;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) ++blocks[{t[i], t[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : blocks) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(blocks.contains({edge[1], edge[0]}));
  }
  return static_cast<int>(mesh.points.size()) - static_cast<int>(blocks.size() / 2) +
         static_cast<int>(mesh.triangles.size());
}

TEST(ImplicitMesh, BallIsRoundClosedAndOutward) {
  const TriangleMesh mesh = mesh_implicit(ball, box(0.15, 0.008));
  for (const Vec3& p : mesh.points) ASSERT_NEAR(p.norm(), 0.1, 1e-8);
  EXPECT_EQ(euler(mesh), 2);
  const double exact = 4.0 / 3 * std::numbers::pi * 1e-3;
  EXPECT_NEAR(volume(mesh) / exact, 1, 0.005);
}

TEST(ImplicitMesh, VolumeConvergesWithTheSquareOfTheSpacing) {
  const double exact = 4.0 / 3 * std::numbers::pi * 1e-3;
  const double coarse = exact - volume(mesh_implicit(ball, box(0.15, 0.016)));
  const double fine = exact - volume(mesh_implicit(ball, box(0.15, 0.008)));
  EXPECT_NEAR(coarse / fine, 4, 1);
}

TEST(ImplicitMesh, TrianglesAreWellShaped) {
  const TriangleMesh mesh = mesh_implicit(ball, box(0.15, 0.008));
  double smallest = 180;
  double edges = 0;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 ahead = mesh.points[t[(i + 1) % 3]] - mesh.points[t[i]];
      const Vec3 behind = mesh.points[t[(i + 2) % 3]] - mesh.points[t[i]];
      smallest = std::min(smallest, std::acos(ahead.normalized().dot(behind.normalized())));
      edges += ahead.norm();
    }
  }
  EXPECT_GT(smallest * 180 / std::numbers::pi, 15);
  EXPECT_NEAR(edges / (3.0 * mesh.triangles.size()), 0.9 * 0.008, 0.1 * 0.008);
}

TEST(ImplicitMesh, RingHasOneHandle) {
  const auto ring = [](const Vec3& p) {
    return std::hypot(std::hypot(p.x(), p.z()) - 0.08, p.y()) - 0.03;
  };
  EXPECT_EQ(euler(mesh_implicit(ring, box(0.15, 0.008))), 0);
}

// The spheres are half a cell apart and meet the same cells. One point for both would join them.
TEST(ImplicitMesh, NearBallsStayApartAtAnyOffset) {
  for (int i = 0; i < 20; ++i) {
    const Vec3 centre = (0.053 + 0.0002 * i) * Vec3(1, 1, 0.1 * i).normalized();
    const auto balls = [&centre](const Vec3& p) {
      return std::min((p - centre).norm(), (p + centre).norm()) - 0.05;
    };
    EXPECT_EQ(euler(mesh_implicit(balls, box(0.15, 0.012))), 4) << i;
  }
}

TEST(ImplicitMesh, SurfaceThatLeavesTheBoxIsAnError) {
  const auto plane = [](const Vec3& p) { return p.y(); };
  EXPECT_THROW(mesh_implicit(plane, box(0.1, 0.02)), Error);
  const auto nothing = [](const Vec3&) { return 1.0; };
  EXPECT_THROW(mesh_implicit(nothing, box(0.1, 0.02)), Error);
}

TEST(ImplicitMesh, IsTheSameForAnyNumberOfThreads) {
  const TriangleMesh many = mesh_implicit(ball, box(0.15, 0.01));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const TriangleMesh alone = mesh_implicit(ball, box(0.15, 0.01));
  EXPECT_TRUE(many.points == alone.points);
  EXPECT_TRUE(many.triangles == alone.triangles);
}

}  // namespace implicit_mesh_test
}  // namespace toile
