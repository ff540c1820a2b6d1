#include "cloth/springs/self_collisions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <numeric>

#include "cloth/model/compile.h"
#include "geometry/closest_points.h"
#include "geometry/intersections.h"
#include "tests/cloth/panels.h"

namespace toile {
namespace self_collisions_test {

/// Two squares of 10 cm, one 8 mm above the other and turned against its mesh, moving together.
struct Sheets {
  PanelMesh garment;
  GarmentModel model;
  std::vector<Vec3> x;
  std::vector<Vec3> v;
  std::vector<int> node;
  std::vector<double> inverse_mass;

  explicit Sheets(double speed) {
    const PlanarMesh square = test::grid(0.1, 0.1, 10, 10);
    test::add_panel(garment, "below", square, [](const Vec2& p) { return Vec3(p.x(), 0, -p.y()); });
    test::add_panel(garment, "above", square, [](const Vec2& p) {
      return Vec3(0.013 + 0.9 * p.x() - 0.3 * p.y(), 0.008, -0.9 * p.y() - 0.3 * p.x());
    });
    model = compile(garment, Scene{}, garment.placed);
    x = garment.placed;
    node.resize(x.size());
    std::iota(node.begin(), node.end(), 0);
    for (std::size_t p = 0; p < x.size(); ++p) {
      inverse_mass.push_back(1 / model.mass[p]);
      v.push_back(Vec3(0, p < x.size() / 2 ? speed / 2 : -speed / 2, 0));
    }
  }

  Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t p = 0; p < x.size(); ++p) sum += v[p] / inverse_mass[p];
    return sum;
  }

  /// Distance from the upper sheet's points to the lower sheet.
  double gap() const {
    double least = 1;
    for (std::size_t p = x.size() / 2; p < x.size(); ++p) {
      for (int t = 0; t < garment.panels[0].triangles; ++t) {
        const auto& [a, b, c] = garment.triangles[t];
        const Vec3 w = closest_on_triangle(x[p], x[a], x[b], x[c]);
        least = std::min(least, (w[0] * x[a] + w[1] * x[b] + w[2] * x[c] - x[p]).norm());
      }
    }
    return least;
  }

  void run(double seconds, double dt) {
    SelfCollisions collisions(model, 0.002);
    collisions.leave_out_neighbours(false);
    for (double t = 0; t < seconds; t += dt) {
      collisions.respond(x, node, inverse_mass, dt, v);
      collisions.bound(x, node, dt, v);
      for (std::size_t p = 0; p < x.size(); ++p) x[p] += dt * v[p];
    }
  }
};

TEST(SelfCollisions, TwoSheetsStopAtTheGapAndKeepTheirMomentum) {
  Sheets sheets(1);
  const Vec3 before = sheets.momentum();
  sheets.run(0.03, 1e-4);
  std::cout << "gap left " << 1000 * sheets.gap() << " mm, momentum gained "
            << (sheets.momentum() - before).norm() << " N s\n";
  EXPECT_GT(sheets.gap(), 0.0015);
  EXPECT_LT((sheets.momentum() - before).norm(), 1e-12);
  EXPECT_TRUE(self_intersections({sheets.x, sheets.garment.triangles}).empty());
}

// In one step of 1 ms the sheets would pass each other: the bounds hold them.
TEST(SelfCollisions, NothingPassesWhateverTheSpeed) {
  Sheets sheets(50);
  sheets.run(0.02, 1e-3);
  EXPECT_TRUE(self_intersections({sheets.x, sheets.garment.triangles}).empty());
  EXPECT_GT(sheets.gap(), 0);
}

}  // namespace self_collisions_test
}  // namespace toile
