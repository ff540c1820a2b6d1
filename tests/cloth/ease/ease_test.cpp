#include "cloth/ease/ease.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <numbers>

#include "tests/support/shapes.h"
#include "tests/support/tubes.h"

namespace toile {
namespace ease_test {

constexpr double micrometre = 1e-6;

TEST(Ease, FacetsOfABodyAreMeasuredAsTheyAre) {
  // Over the middle of a side the gap is larger by R (1 - cos(pi / n)) (references, case 15).
  const double bias = 0.15 * (1 - std::cos(std::numbers::pi / 24));
  const SurfaceDistance body(test::closed_tube(0.15, 0.15, 1.0, 24));
  const EaseMap map = measure_ease(test::cloth_tube(0.16, 0.16, 0.4, 0.6, 240, 4), body);
  EXPECT_NEAR(map.garment.min, 0.010, micrometre);
  EXPECT_NEAR(map.garment.max, 0.010 + bias, micrometre);
}

TEST(Ease, InsideIsNegative) {
  const SurfaceDistance body(test::sphere(0.1, 6));
  const EaseMap map = measure_ease(test::sphere_garment(0.09, 4), body);
  EXPECT_NEAR(map.garment.mean, -0.010, 50 * micrometre);
  EXPECT_DOUBLE_EQ(map.garment.inside, 1);
  EXPECT_DOUBLE_EQ(map.garment.contact, 1);
}

TEST(Ease, PanelsHaveTheirOwnStatistics) {
  // Moved forward by 4 mm, the front stands off by 14 mm and the back by 6 mm at the most.
  const SurfaceDistance body(test::closed_tube(0.15, 0.15, 1.0, 600));
  DressedGarment garment = test::cloth_tube(0.16, 0.16, 0.3, 0.7, 240, 10);
  for (Vec3& point : garment.points) point.z() += 0.004;
  garment.panels.push_back("unused");
  const EaseMap map = measure_ease(garment, body);
  ASSERT_EQ(map.panels.size(), 3U);
  EXPECT_NEAR(map.panels[0].max, 0.014, 5 * micrometre);
  EXPECT_NEAR(map.panels[1].min, 0.006, 5 * micrometre);
  // Over a half circle the mean of 4 mm cos(angle) is 4 mm * 2 / pi.
  EXPECT_NEAR(map.panels[0].mean, 0.010 + 0.004 * 2 / std::numbers::pi, 50 * micrometre);
  EXPECT_NEAR(map.panels[1].mean, 0.010 - 0.004 * 2 / std::numbers::pi, 50 * micrometre);
  EXPECT_EQ(map.panels[0].points, 121 * 11);
  EXPECT_EQ(map.panels[2].points, 0);
  EXPECT_EQ(map.garment.points, 2 * 121 * 11);  // sewn sides count in both panels
  EXPECT_NEAR(map.panels[0].area + map.panels[1].area, map.garment.area, 1e-12);
  EXPECT_NEAR(map.garment.area, 2 * std::numbers::pi * 0.16 * 0.4, 1e-4);
}

TEST(Ease, PercentilesWeighByArea) {
  // A funnel: radius 0.15 + t gap and rows crowded where it is narrow. Its area grows almost evenly
  // with height, so the gap's median is near its value at half height, wherever the points are.
  const SurfaceDistance body(test::closed_tube(0.15, 0.15, 1.0, 600));
  DressedGarment garment = test::cloth_tube(1, 1, 0, 1, 60, 100);
  for (Vec3& point : garment.points) {
    const double t = point.y() * point.y() * point.y();
    const double radius = 0.15 + 0.020 * t;
    point = {point.x() * radius, 0.3 + 0.4 * t, point.z() * radius};
  }
  const EaseMap map = measure_ease(garment, body);
  // Area below t: (0.15 t + 0.01 t^2) / 0.16; half of it lies below t = 0.5161.
  EXPECT_NEAR(map.garment.p50, 0.020 * 0.5161, 0.0001);
  EXPECT_NEAR(map.garment.p5, 0.020 * 0.0532, 0.0001);
  // Contact below 3 mm: t < 0.15.
  EXPECT_NEAR(map.garment.contact, (0.15 * 0.15 + 0.01 * 0.15 * 0.15) / 0.16, 0.01);
}

TEST(Ease, PointsAreOrderedByPanelAndFlatPoint) {
  const SurfaceDistance body(test::closed_tube(0.15, 0.15, 1.0, 60));
  const DressedGarment garment = test::cloth_tube(0.16, 0.16, 0.3, 0.7, 20, 3);
  const EaseMap map = measure_ease(garment, body);
  ASSERT_EQ(map.points.size(), garment.flat.size());
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    EXPECT_EQ(map.points[i].flat, static_cast<int>(i));
    EXPECT_EQ(map.points[i].panel, i < garment.flat.size() / 2 ? 0 : 1);
    EXPECT_EQ(map.points[i].gap, map.node_gaps[static_cast<std::size_t>(map.points[i].node)]);
  }
}

TEST(Ease, SameBitsForAnyNumberOfThreads) {
  const SurfaceDistance body(test::closed_tube(0.15, 0.12, 1.0, 100));
  const DressedGarment garment = test::cloth_tube(0.16, 0.16, 0.3, 0.7, 60, 10);
  const EaseMap all = measure_ease(garment, body);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const EaseMap single = measure_ease(garment, body);
  EXPECT_EQ(single.node_gaps, all.node_gaps);
  EXPECT_EQ(single.garment.mean, all.garment.mean);
}

}  // namespace ease_test
}  // namespace toile
