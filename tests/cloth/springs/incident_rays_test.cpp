#include "cloth/springs/incident_rays.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <iostream>
#include <random>

namespace toile {
namespace incident_rays_test {

/// Random points, weights and speeds, the same each time.
class Draw {
 public:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec3 point() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }
  Vec3 weights() {
    const double a = number(0.05, 1);
    const double b = number(0.05, 1);
    const double c = number(0.05, 1);
    return Vec3(a, b, c) / (a + b + c);
  }

 private:
  std::mt19937 random_{7};
};

TEST(IncidentRays, AParticleMeetsTheTriangleAheadOfIt) {
  Draw draw;
  double error = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 a = draw.point(), b = draw.point(), c = draw.point();
    const Vec3 w = draw.weights();
    const Vec3 target = w[0] * a + w[1] * b + w[2] * c;
    const Vec3 x = draw.point();
    if (std::abs((b - a).cross(c - a).normalized().dot((target - x).normalized())) < 0.01) continue;
    const Vec3 v = draw.number(0.1, 5) * (target - x);
    const auto hit = particle_ray(x, v, a, b, c);
    ASSERT_TRUE(hit);
    error = std::max(error, std::abs(*hit - (target - x).norm()));
    EXPECT_FALSE(particle_ray(x, -v, a, b, c));
    EXPECT_FALSE(particle_ray(x, Vec3::Zero(), a, b, c));
  }
  EXPECT_LT(error, 1e-12);
  std::cout << "distance along the ray within " << error << " m\n";
}

TEST(IncidentRays, ATriangleThatMovesMeetsTheVertex) {
  Draw draw;
  double error = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::array<Vec3, 3> p = {draw.point(), draw.point(), draw.point()};
    const Vec3 w = draw.weights();
    const Vec3 q = draw.point();
    const Vec3 way = q - w[0] * p[0] - w[1] * p[1] - w[2] * p[2];  // the triangle moves to Q
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    if (std::abs(normal.dot(way.normalized())) < 0.01) continue;
    const auto hit = vertex_ray(q, 3 * way, p[0], p[1], p[2]);
    ASSERT_TRUE(hit);
    for (int k = 0; k < 3; ++k) error = std::max(error, std::abs(hit->weights[k] - w[k]));
    error = std::max(error, std::abs(hit->distance - way.norm()));
    EXPECT_FALSE(vertex_ray(q, -way, p[0], p[1], p[2]));  // it moves away
  }
  EXPECT_LT(error, 1e-11);
  std::cout << "weights and distance within " << error << '\n';
}

TEST(IncidentRays, AnEdgeThatMovesMeetsTheEdge) {
  Draw draw;
  double error = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p1 = draw.point(), p2 = draw.point(), q1 = draw.point(), q2 = draw.point();
    const double w1 = draw.number(0.05, 0.95);
    const double w2 = draw.number(0.05, 0.95);
    const Vec3 way = q1 + w2 * (q2 - q1) - p1 - w1 * (p2 - p1);
    const Vec3 plane = (p2 - p1).cross(way).normalized();
    if (std::abs(plane.dot((q2 - q1).normalized())) < 0.01) continue;
    if ((p2 - p1).normalized().cross(way.normalized()).norm() < 0.01) continue;
    const auto hit = edge_sweep(p1, p2, 0.7 * way, q1, q2);
    ASSERT_TRUE(hit);
    error = std::max({error, std::abs(hit->w1 - w1), std::abs(hit->w2 - w2),
                      std::abs(hit->distance - way.norm())});
    EXPECT_FALSE(edge_sweep(p1, p2, -way, q1, q2));
    EXPECT_FALSE(edge_sweep(p1, p2, Vec3::Zero(), q1, q2));
    EXPECT_FALSE(edge_sweep(p1, p2, p2 - p1, q1, q2));  // it moves along itself
  }
  EXPECT_LT(error, 1e-11);
  std::cout << "weights and distance within " << error << '\n';
}

}  // namespace incident_rays_test
}  // namespace toile
