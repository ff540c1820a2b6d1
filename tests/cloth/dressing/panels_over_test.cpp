#include "cloth/dressing/panels_over.h"

#include <gtest/gtest.h>

#include <iostream>

#include "cloth/scene/collider.h"
#include "geometry/intersections.h"
#include "tests/cloth/panels.h"
#include "tests/pattern/samples.h"
#include "tests/support/tubes.h"

namespace toile {
namespace panels_over_test {

/// A tube of two panels, front and back, around an upright cylinder.
struct Tail {
  PanelMesh garment;
  DressedGarment dressed;
};

constexpr double body_radius = 0.1;

/// From `low` to `high`, `around` columns, its panels named after `name`.
Tail tube(double low, double high, double radius, int around, int rows, const std::string& name) {
  Tail tail;
  tail.dressed = test::cloth_tube(radius, radius, low, high, around, rows);
  const int half = static_cast<int>(tail.dressed.triangles.size()) / 2;
  for (int i = 0; i < 2; ++i) {
    MeshedPanel panel;
    panel.name = name + (i == 0 ? "_front" : "_back");
    panel.first_triangle = i * half;
    panel.triangles = half;
    tail.garment.panels.push_back(panel);
  }
  tail.garment.triangles = tail.dressed.flat_triangles;
  tail.garment.flat = tail.dressed.flat;
  return tail;
}

double radius_of(const Vec3& p) { return std::hypot(p.x(), p.z()); }

TEST(TurnOut, WhatLayBelowLiesOver) {
  const TriangleMesh body = test::closed_tube(body_radius, body_radius, 0.5, 200);
  Tail tail = tube(0.1, 0.4, 0.104, 120, 30, "tail");
  // A pleat: every third column lies 3 mm farther out.
  for (std::size_t n = 0; n < tail.dressed.points.size(); ++n) {
    if (n % 120 % 3 != 0) continue;
    Vec3& p = tail.dressed.points[n];
    p.x() *= 0.107 / 0.104;
    p.z() *= 0.107 / 0.104;
  }
  // The band goes around the lower half only, through the pleats.
  const DressedGarment band = test::cloth_tube(0.106, 0.106, 0.05, 0.25, 150, 20);
  const TriangleMesh outer{band.points, band.triangles};
  const auto& triangles = tail.dressed.triangles;
  EXPECT_GT(intersections({tail.dressed.points, triangles}, outer).size(), 100U);

  const Collider below(body);
  Collider above(body);
  above.add_layer(outer);
  std::vector<Vec3> nodes = tail.dressed.points;
  const std::vector<char> moved =
      flip_over(tail.garment, {0, 1}, below.grid(), above.grid(), triangles, nodes);
  EXPECT_TRUE(intersections({nodes, triangles}, outer).empty());
  EXPECT_TRUE(intersections({nodes, triangles}, body).empty());
  EXPECT_TRUE(self_intersections({nodes, triangles}).empty());
  double worst = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Vec3& was = tail.dressed.points[n];
    EXPECT_NEAR(nodes[n].y(), was.y(), 1e-3);
    if (was.y() < 0.23) {
      // As far from the band as it was from the skin.
      const double expected = 0.106 + radius_of(was) - body_radius;
      worst = std::max(worst, std::abs(radius_of(nodes[n]) - expected));
      EXPECT_EQ(moved[n], 1);
    } else if (was.y() > 0.27) {
      EXPECT_EQ(nodes[n], was);
      EXPECT_EQ(moved[n], 0);
    }
  }
  std::cout << "farthest from where it should lie: " << 1000 * worst << " mm\n";
  EXPECT_LT(worst, 5e-4);
}

TEST(TurnOut, OnlyThePanelsNamed) {
  const Tail tail = tube(0.1, 0.4, 0.104, 120, 30, "tail");
  const TriangleMesh body = test::closed_tube(body_radius, body_radius, 0.5, 200);
  const DressedGarment band = test::cloth_tube(0.106, 0.106, 0.05, 0.45, 150, 20);
  const Collider below(body);
  Collider above(body);
  above.add_layer({band.points, band.triangles});
  EXPECT_EQ(panels_named(tail.garment, {"tail_f*"}), std::vector<int>{0});
  EXPECT_EQ(panels_named(tail.garment, {"tail_*"}), (std::vector<int>{0, 1}));
  EXPECT_HOLDS(samples::error_of([&] { panels_named(tail.garment, {"collar"}); }), "collar");
  std::vector<Vec3> nodes = tail.dressed.points;
  flip_over(tail.garment, {0}, below.grid(), above.grid(), tail.dressed.triangles, nodes);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const bool is_front = tail.dressed.points[n].z() > -1e-9;
    EXPECT_EQ(radius_of(nodes[n]) > 0.106, is_front) << n;
  }
  std::vector<Triangle> left = tail.dressed.triangles;
  leave_out(tail.garment, {0}, left);
  EXPECT_EQ(left.size(), tail.dressed.triangles.size() / 2);
  EXPECT_EQ(left.front(), tail.dressed.triangles[left.size()]);
}

}  // namespace panels_over_test
}  // namespace toile
