#include "cloth/springs/subject_collisions.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <Eigen/Geometry>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "geometry/error.h"
#include "geometry/intersections.h"
#include "geometry/surface_distance.h"
#include "tests/cloth/springs/collision_scene.h"
#include "tests/support/shapes.h"

namespace toile {
namespace subject_collisions_test {

using test::level_sheet;
using test::LooseCloth;

const Vec3 down(0, -9.81, 0);
const Vec3 nothing(0, 0, 0);
constexpr double dt = 1e-4;

TriangleMesh table(double half = 0.5) { return test::box({-half, -0.1, -half}, {half, 0, half}); }

/// A cone with its point at the origin, standing on y = -height.
TriangleMesh needle(double radius, double height) {
  TriangleMesh mesh;
  mesh.points = {Vec3::Zero(), Vec3(0, -height, 0)};
  const int around = 12;
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.3) / around;
    mesh.points.emplace_back(radius * std::sin(angle), -height, radius * std::cos(angle));
  }
  for (int i = 0; i < around; ++i) {
    const int j = 2 + (i + 1) % around;
    mesh.triangles.push_back({0, 2 + i, j});
    mesh.triangles.push_back({1, j, 2 + i});
  }
  return mesh;
}

/// A roof whose ridge, y = 0, runs along z.
TriangleMesh knife(double half_length) {
  TriangleMesh mesh;
  mesh.points = {{0, 0, -half_length},        {0, 0, half_length},
                 {-0.02, -0.2, -half_length}, {-0.02, -0.2, half_length},
                 {0.02, -0.2, -half_length},  {0.02, -0.2, half_length}};
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4},
                    {0, 4, 2}, {1, 3, 5}, {2, 4, 5}, {2, 5, 3}};
  return mesh;
}

TriangleMesh one_triangle(double size, double height, const Vec3& shift) {
  TriangleMesh mesh;
  mesh.points = {Vec3(-size, height, size) + shift, Vec3(size, height, size) + shift,
                 Vec3(0, height, -size) + shift};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

Vec3 momentum(const LooseCloth& cloth) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& v : cloth.v) sum += v;
  return sum / static_cast<double>(cloth.v.size());
}

double lowest(const std::vector<Vec3>& x) {
  double low = x[0].y();
  for (const Vec3& p : x) low = std::min(low, p.y());
  return low;
}

TEST(SubjectCollisions, ParticlesReboundAsTheCoefficientSays) {
  for (const double restitution : {0.0, 0.3, 1.0}) {
    LooseCloth cloth(table(), level_sheet(4, 4, 0.01, 0.00205), Vec3(0.7, -2, 0.3));
    cloth.options.restitution = restitution;
    cloth.step(dt, nothing);
    double error = 0;
    for (const Vec3& v : cloth.v) {
      // Without restitution, the rest of the way down to the gap is allowed.
      const double expected = restitution > 0 ? 2 * restitution : -5e-5 / dt;
      error = std::max(error, (v - Vec3(0.7, expected, 0.3)).norm());
    }
    EXPECT_LT(error, 1e-11);
    EXPECT_EQ(cloth.counts.particle_facet, 25);
    cloth.step(dt, nothing);
    EXPECT_NEAR(momentum(cloth).y(), 2 * restitution, 1e-11);
    std::cout << "restitution " << restitution << ": error " << error << " m/s\n";
  }
}

TEST(SubjectCollisions, AVertexStopsATriangleByTheShares) {
  for (const double restitution : {0.0, 0.5}) {
    LooseCloth cloth(needle(0.01, 0.1), one_triangle(0.05, 0.0008, {0.006, 0, 0.004}),
                     Vec3(0, -1, 0));
    cloth.inverse_mass = {1 / 2e-5, 1 / 3e-5, 1 / 5e-5};
    cloth.options.restitution = restitution;
    cloth.options.let_out_speed = 0;  // it starts nearer than the gap
    const std::vector<Vec3> before = cloth.v;
    cloth.step(dt, nothing);
    EXPECT_EQ(cloth.counts.vertex_triangle, 1);
    // Weights of the origin, seen along y.
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) {
      corners.col(i) = cloth.x[i] - dt * cloth.v[i];
      corners(1, i) = 1;
    }
    const Vec3 w = corners.inverse() * Vec3(0, 1, 0);
    Vec3 at_point = Vec3::Zero();
    Vec3 impulse = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
      at_point += w[i] * cloth.v[i];
      const Vec3 change = (cloth.v[i] - before[i]) / cloth.inverse_mass[i];
      impulse += change;
      torque += (corners.col(i) - Vec3(0, 1, 0)).cross(change);
    }
    // The sheet is level and the tip is square to it, so that the normal is up.
    EXPECT_NEAR(at_point.y(), restitution, 1e-12);
    EXPECT_NEAR(impulse.x(), 0, 1e-17);
    EXPECT_NEAR(impulse.z(), 0, 1e-17);
    EXPECT_LT(torque.norm(), 1e-18);  // one impulse, at the tip
    std::cout << "point's velocity " << at_point.y() << ", torque about the tip " << torque.norm()
              << " N m s\n";
  }
}

TEST(SubjectCollisions, AnEdgeStopsAnEdge) {
  for (const double restitution : {0.0, 0.5}) {
    // The side from corner 0 to 1 crosses the ridge 4 mm off its middle.
    LooseCloth cloth(knife(0.2), one_triangle(0.05, 0.0008, {0.004, 0, -0.01}), Vec3(0.2, -1, 0.1));
    cloth.inverse_mass = {1 / 2e-5, 1 / 3e-5, 1e9};
    cloth.x[2] += Vec3(0, 0.03, 0);  // only the side comes near
    cloth.options.restitution = restitution;
    cloth.options.let_out_speed = 0;  // it starts nearer than the gap
    const std::vector<Vec3> before = cloth.v;
    const double w1 = (0 - cloth.x[0].x()) / (cloth.x[1].x() - cloth.x[0].x());
    // Where the swept edge meets the ridge, that point of the edge is not the nearest one.
    const double swept = w1 - 0.2 * 0.0008 / (cloth.x[1].x() - cloth.x[0].x());
    cloth.step(dt, nothing);
    EXPECT_EQ(cloth.counts.edge_edge, 1);
    EXPECT_EQ(cloth.counts.vertex_triangle + cloth.counts.particle_facet, 0);
    const Vec3 at_point = (1 - swept) * cloth.v[0] + swept * cloth.v[1];
    EXPECT_NEAR(at_point.y(), restitution, 1e-12);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(cloth.v[i].x(), before[i].x(), 1e-14);
      EXPECT_NEAR(cloth.v[i].z(), before[i].z(), 1e-14);
    }
    std::cout << "point's velocity " << at_point.transpose() << '\n';
  }
}

TEST(SubjectCollisions, ASheetStaysAboveANeedleAndAKnifeEdge) {
  for (const bool on_needle : {true, false}) {
    const TriangleMesh subject = on_needle ? needle(0.004, 0.2) : knife(0.1);
    // No node is over the tip or the ridge.
    TriangleMesh sheet = level_sheet(5, 5, 0.02, 0.01);
    for (Vec3& p : sheet.points) p += Vec3(0.0037, 0, 0.0011);
    LooseCloth cloth(subject, sheet, Vec3(0, -1, 0));
    double least = 1;
    for (int i = 0; i < 400; ++i) {
      cloth.step(dt, down);
      // The sheet bends freely: seen from the tip, the part over it.
      for (const Triangle& t : sheet.triangles) {
        for (const double z : {-0.04, 0.0, 0.04}) {
          if (on_needle && z != 0) continue;
          Eigen::Matrix3d corners;
          for (int k = 0; k < 3; ++k) {
            corners.col(k) = cloth.x[t[k]];
            corners(1, k) = 1;
          }
          if (std::abs(corners.determinant()) < 1e-7) continue;
          const Vec3 w = corners.inverse() * Vec3(0, 1, z);
          if (w.minCoeff() < 0) continue;
          least = std::min(least, w[0] * cloth.x[t[0]].y() + w[1] * cloth.x[t[1]].y() +
                                      w[2] * cloth.x[t[2]].y());
        }
      }
    }
    EXPECT_GT(least, 0.00099);
    EXPECT_LT(least, 0.01);
    EXPECT_TRUE(intersections(subject, {cloth.x, sheet.triangles}).empty());
    std::cout << "least height over the " << (on_needle ? "tip " : "ridge ") << least << " m\n";
  }
}

TEST(SubjectCollisions, ASheetRestsOnATableAtTheGap) {
  LooseCloth cloth(table(), level_sheet(10, 10, 0.02, 0.01), nothing);
  for (int i = 0; i < 1000; ++i) cloth.step(dt, down);
  std::vector<double> low(cloth.x.size(), 1);
  std::vector<double> high(cloth.x.size(), 0);
  double speed = 0;
  for (int i = 0; i < 1000; ++i) {
    cloth.step(dt, down);
    for (std::size_t k = 0; k < cloth.x.size(); ++k) {
      low[k] = std::min(low[k], cloth.x[k].y());
      high[k] = std::max(high[k], cloth.x[k].y());
      speed = std::max(speed, cloth.v[k].norm());
    }
  }
  double jitter = 0;
  double off = 0;
  for (std::size_t k = 0; k < low.size(); ++k) {
    jitter = std::max(jitter, high[k] - low[k]);
    off = std::max(off, std::abs(low[k] - cloth.options.tolerance));
  }
  EXPECT_LT(jitter, 1e-9);
  EXPECT_LT(off, 1e-9);
  EXPECT_LT(speed, 1e-6);
  std::cout << "jitter " << jitter << " m, off the gap " << off << " m, speed " << speed
            << " m/s\n";
}

TEST(SubjectCollisions, WhatIsTooNearOrBehindIsLetOutWithoutABounce) {
  for (const double start : {0.0015, 0.0001, -0.004}) {
    LooseCloth cloth(table(), level_sheet(6, 6, 0.02, start), nothing);
    double highest = 0;
    double fastest = 0;
    for (int i = 0; i < 4000; ++i) {
      cloth.step(dt, down);
      highest = std::max(highest, lowest(cloth.x));
      fastest = std::max(fastest, cloth.v[0].norm());
    }
    EXPECT_LT(highest, cloth.options.tolerance + 2e-4);
    EXPECT_LE(fastest, cloth.options.let_out_speed * (1 + 1e-9));
    EXPECT_NEAR(lowest(cloth.x), cloth.options.tolerance, 1e-9);
    std::cout << "from " << start << " m: highest " << highest << " m, at last " << lowest(cloth.x)
              << " m\n";
  }
}

TEST(SubjectCollisions, AnOpenSheetIsASubjectToo) {
  // A sheet over the table's top, as a dressed layer lies; cloth is dropped on it, partly beyond
  // its border.
  const TriangleMesh layer = level_sheet(8, 8, 0.02, 0.004);
  const TriangleMesh subject = test::together(table(), layer);
  TriangleMesh sheet = level_sheet(8, 8, 0.021, 0.012);
  for (Vec3& p : sheet.points) p += Vec3(0.05, 0, 0.003);
  LooseCloth cloth(subject, sheet, nothing);
  for (int i = 0; i < 1500; ++i) cloth.step(dt, down);
  for (const Vec3& p : cloth.x) {
    const bool over = std::abs(p.x()) < 0.079 && std::abs(p.z()) < 0.079;
    EXPECT_GT(p.y(), over ? 0.0059 : 0.0018);
    EXPECT_LT(p.y(), 0.008);  // some are levered up over the layer's border
  }
  EXPECT_TRUE(intersections(subject, {cloth.x, sheet.triangles}).empty());
}

TEST(SubjectCollisions, FastSheetsDoNotPassThroughAThinPlate) {
  for (const double long_step : {1e-4, 1e-3, 5e-3}) {
    for (const double restitution : {0.0, 0.5}) {
      // A plate of 0.5 mm, smaller than the sheet, which comes tumbling at 10 m/s.
      const TriangleMesh plate = test::box({-0.03, -0.0005, -0.03}, {0.03, 0, 0.03});
      TriangleMesh sheet = level_sheet(9, 9, 0.013, 0);
      const Eigen::AngleAxisd turn(0.4, Vec3(1, 0.3, 0.2).normalized());
      for (Vec3& p : sheet.points) p = turn * p + Vec3(0.005, 0.05, 0.002);
      LooseCloth cloth(plate, sheet, Vec3(0, -10, 0));
      cloth.options.restitution = restitution;
      std::mt19937 random(5);
      std::uniform_real_distribution<double> some(-1, 1);
      for (Vec3& v : cloth.v) v += Vec3(some(random), some(random), some(random));
      const int steps = static_cast<int>(0.02 / long_step);
      for (int i = 0; i < steps; ++i) {
        cloth.step(long_step, nothing);
        ASSERT_TRUE(intersections(plate, {cloth.x, sheet.triangles}).empty())
            << "step " << i << " of " << long_step << " s";
      }
    }
  }
}

TEST(SubjectCollisions, AfterTheResponseNothingApproaches) {
  // A sphere that pokes into a sheet: nodes, edges and vertices together.
  const TriangleMesh ball = test::sphere(0.1, 4);
  TriangleMesh sheet = level_sheet(24, 24, 0.008, 0);
  for (Vec3& p : sheet.points) {
    p.y() = std::sqrt(std::max(0.0, 0.1018 * 0.1018 - p.x() * p.x() - p.z() * p.z()));
  }
  LooseCloth cloth(ball, sheet, Vec3(0.3, -2, 0));
  cloth.options.edge_tolerance = cloth.options.tolerance;
  const CollisionCounts first =
      cloth.collisions.respond(cloth.x, cloth.inverse_mass, dt, cloth.options, cloth.v);
  std::vector<Vec3> again = cloth.v;
  cloth.collisions.respond(cloth.x, cloth.inverse_mass, dt, cloth.options, again);
  double left = 0;
  for (std::size_t i = 0; i < again.size(); ++i) {
    left = std::max(left, (again[i] - cloth.v[i]).norm());
  }
  EXPECT_GT(first.particle_facet, 20);
  EXPECT_GT(first.vertex_triangle, 20);
  EXPECT_GT(first.edge_edge, 20);
  EXPECT_LT(left, 0.05 * 2);
  std::cout << "contacts " << first.particle_facet << ' ' << first.vertex_triangle << ' '
            << first.edge_edge << ", a second response changes up to " << left
            << " m/s of an approach of 2\n";
}

TEST(SubjectCollisions, ASlidingSheetKeepsTheGapAndGainsNoEnergy) {
  const TriangleMesh ball = test::sphere(0.1, 4);
  const TriangleMesh sheet = level_sheet(20, 20, 0.008, 0.104);
  LooseCloth cloth(ball, sheet, Vec3(3, 0, 0.4));
  const auto energy = [&] {  // J/kg, mean
    double sum = 0;
    for (std::size_t i = 0; i < cloth.x.size(); ++i) {
      sum += cloth.v[i].squaredNorm() / 2 + 9.81 * cloth.x[i].y();
    }
    return sum / static_cast<double>(cloth.x.size());
  };
  const SurfaceDistance distance(ball);
  double before = energy();
  double gained = 0;
  double least = 1;
  for (int i = 0; i < 1000; ++i) {
    cloth.step(dt, down);
    const double now = energy();
    gained = std::max(gained, now - before);
    before = now;
    if (i % 10 == 0) {
      for (const Vec3& p : cloth.x) least = std::min(least, distance.closest_point(p).distance);
    }
    if (i % 50 == 0) {
      ASSERT_TRUE(intersections(ball, {cloth.x, sheet.triangles}).empty());
    }
  }
  EXPECT_LT(gained, 1e-6);
  EXPECT_GT(least, 0.0019);
  std::cout << "most energy gained in a step " << gained << " J/kg, least gap " << least << " m\n";
}

TEST(SubjectCollisions, SameBitsForAnyNumberOfThreads) {
  const auto run = [](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    LooseCloth cloth(test::sphere(0.1, 4), level_sheet(40, 40, 0.005, 0.104), Vec3(0.1, -1, 0));
    cloth.options.friction = 0.3;
    for (int i = 0; i < 100; ++i) cloth.step(dt, down);
    return cloth.x;
  };
  EXPECT_EQ(run(1), run(2));
}

TEST(SubjectCollisions, MergedNodesAreForgotten) {
  TriangleMesh sheet = level_sheet(4, 4, 0.02, 0.01);
  LooseCloth cloth(table(), sheet, nothing);
  for (int i = 0; i < 50; ++i) cloth.step(dt, down);
  for (Triangle& t : sheet.triangles) {
    for (int& node : t) node = node == 1 ? 0 : node;
  }
  cloth.collisions.set_cloth(sheet.triangles);
  for (int i = 0; i < 1000; ++i) cloth.step(dt, down);
  EXPECT_LT(cloth.x[1].y(), -0.01);  // falls through: it is of no triangle
  EXPECT_NEAR(cloth.x[0].y(), 0.002, 1e-9);
}

TEST(SubjectCollisions, RefusesASubjectWithoutArea) {
  TriangleMesh flat;
  flat.points = {Vec3::Zero(), Vec3(1, 0, 0), Vec3(2, 0, 0)};
  flat.triangles = {{0, 1, 2}};
  EXPECT_THROW(SubjectCollisions(flat, {}), Error);
  EXPECT_THROW(SubjectCollisions(TriangleMesh{}, {}), Error);
  flat.points[1].y() = std::nan("");
  EXPECT_THROW(SubjectCollisions(flat, {}), Error);
}

}  // namespace subject_collisions_test
}  // namespace toile
