#include "cloth/judge/measures.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/cloth/panels.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace measures_test {

/// 20 x 10 cm, squares of 1 cm.
PanelMesh panel() { return test::flat_panel(test::grid(0.2, 0.1, 20, 10)); }

std::vector<Vec3> scaled(const PanelMesh& garment, double x, double y) {
  std::vector<Vec3> points = garment.placed;
  for (Vec3& p : points) p = p.cwiseProduct(Vec3(x, y, 1));
  return points;
}

TEST(Measures, FlatPanel) {
  const PanelMesh garment = panel();
  EXPECT_NEAR(panel_areas(garment)[0], 0.02, 1e-15);
  EXPECT_NEAR(panel_perimeters(garment)[0], 0.6, 1e-14);
  EXPECT_NEAR(triangle_perimeters(garment)[0], 400 * (0.02 + 0.01 * std::numbers::sqrt2), 1e-11);
  const GarmentMeasurements measured =
      measure_garment(garment, test::as_dressed(garment, garment.placed));
  EXPECT_LT(measured.strain.max, 1e-12);
  EXPECT_LT(std::abs(measured.area_total), 1e-12);
  EXPECT_EQ(measured.borders, 1);
  EXPECT_EQ(measured.seams.sewn + measured.seams.open, 0);
}

TEST(Measures, StretchedInOneDirection) {
  const PanelMesh garment = panel();
  const double e = 0.03;
  const auto points = scaled(garment, 1, 1 + e);
  const GarmentMeasurements measured = measure_garment(garment, test::as_dressed(garment, points));
  const double diagonal = std::sqrt((1 + (1 + e) * (1 + e)) / 2) - 1;
  // 20·11 edges across, 21·10 along, 200 diagonals.
  EXPECT_NEAR(measured.strain.max, e, 1e-12);
  EXPECT_NEAR(measured.strain.p99, e, 1e-12);
  EXPECT_NEAR(measured.strain.rms, std::sqrt((210 * e * e + 200 * diagonal * diagonal) / 630),
              1e-12);
  EXPECT_NEAR(measured.area_total, e, 1e-12);
  EXPECT_NEAR(measured.area_max_panel, e, 1e-12);
  EXPECT_NEAR(measured.perimeter_max_panel, 2 * 0.1 * e / 0.6, 1e-12);
  EXPECT_NEAR(measured.triangle_perimeter_max_panel,
              (e + std::numbers::sqrt2 * diagonal) / (2 + std::numbers::sqrt2), 1e-12);
  EXPECT_NEAR(panel_areas(garment, points)[0], 0.02 * (1 + e), 1e-15);
}

TEST(Measures, ShrinkingCountsAsMuchAsGrowing) {
  const PanelMesh garment = panel();
  const GarmentMeasurements measured =
      measure_garment(garment, test::as_dressed(garment, scaled(garment, 0.95, 0.95)));
  EXPECT_NEAR(measured.strain.max, 0.05, 1e-12);
  EXPECT_NEAR(measured.area_total, 0.95 * 0.95 - 1, 1e-12);
  EXPECT_NEAR(measured.area_max_panel, 1 - 0.95 * 0.95, 1e-12);
  EXPECT_NEAR(measured.perimeter_max_panel, 0.05, 1e-12);
}

TEST(Measures, ThePercentileLeavesOneInAHundredOut) {
  // One of 630 edges, on a corner of the panel, is pulled to twice its length.
  const PanelMesh garment = panel();
  std::vector<Vec3> points = garment.placed;
  points[20] += Vec3(0.01, 0, 0);
  const GarmentMeasurements measured = measure_garment(garment, test::as_dressed(garment, points));
  EXPECT_NEAR(measured.strain.max, 1, 1e-12);
  EXPECT_LT(measured.strain.p99, 1e-12);
}

/// Two squares with a seam between; `gap` metres apart there.
PanelMesh pair() {
  PanelMesh garment;
  for (const double x : {0.0, 0.1}) {
    test::add_panel(garment, x == 0 ? "left" : "right", test::grid(0.1, 0.1, 10, 10),
                    [&](const Vec2& p) { return Vec3(p.x() + x, p.y(), 0); });
  }
  garment.seams = {test::seam("middle", test::side(garment.panels[0], 10, 10, true),
                              test::side(garment.panels[1], 10, 10, false))};
  return garment;
}

TEST(Measures, SeamsAreSewnWithinTenMicrometres) {
  const PanelMesh garment = pair();
  GarmentMeasurements measured =
      measure_garment(garment, test::as_dressed(garment, garment.placed));
  EXPECT_EQ(measured.seams.sewn, 1);
  EXPECT_EQ(measured.seams.open, 0);
  EXPECT_EQ(measured.seams.max_gap, 0);
  EXPECT_EQ(measured.borders, 1);

  std::vector<Vec3> apart = garment.placed;
  apart[garment.seams[0].b[4]].z() = 0.9e-5;
  measured = measure_garment(garment, test::as_dressed(garment, apart, false));
  EXPECT_EQ(measured.seams.sewn, 1);
  EXPECT_NEAR(measured.seams.max_gap, 0.9e-5, 1e-12);

  apart[garment.seams[0].b[4]].z() = 0.003;
  measured = measure_garment(garment, test::as_dressed(garment, apart, false));
  EXPECT_EQ(measured.seams.sewn, 0);
  EXPECT_EQ(measured.seams.open, 1);
  ASSERT_EQ(measured.seams.open_seams.size(), 1u);
  EXPECT_EQ(measured.seams.open_seams[0].name, "middle");
  EXPECT_NEAR(measured.seams.max_gap, 0.003, 1e-12);
  EXPECT_EQ(measured.borders, 2);
}

TEST(Measures, StrainOfSeamEdgesIsKeptApart) {
  // One point of the seam moves along it by a tenth of an edge. The edges on the seam are strained
  // by all of that, those into the panels by less.
  const PanelMesh garment = pair();
  std::vector<Vec3> points = garment.placed;
  points[garment.seams[0].a[5]].y() += 0.001;
  points[garment.seams[0].b[5]].y() += 0.001;
  const GarmentMeasurements measured = measure_garment(garment, test::as_dressed(garment, points));
  EXPECT_NEAR(measured.strain.max, 0.1, 1e-9);
  EXPECT_NEAR(measured.strain_off_seams.max,
              std::abs(std::hypot(0.01, 0.011) / std::hypot(0.01, 0.01) - 1), 1e-9);
}

TEST(Measures, ThePanelThatChangedMostIsReported) {
  const PanelMesh garment = pair();
  std::vector<Vec3> points = garment.placed;
  for (int p = 121; p < 242; ++p) points[p].x() = 0.1 + 1.04 * (points[p].x() - 0.1);
  const GarmentMeasurements measured = measure_garment(garment, test::as_dressed(garment, points));
  EXPECT_NEAR(measured.area_max_panel, 0.04, 1e-11);
  EXPECT_NEAR(measured.area_total, 0.02, 1e-11);
  EXPECT_NEAR(measured.perimeter_max_panel, 0.02, 1e-11);
}

TEST(Measures, AnotherGarmentIsRefused) {
  const PanelMesh garment = panel();
  DressedGarment other = test::as_dressed(garment, garment.placed);
  std::swap(other.flat_triangles[0], other.flat_triangles[1]);
  EXPECT_HOLDS(samples::error_of([&] { measure_garment(garment, other); }), "other faces");
}

}  // namespace measures_test
}  // namespace toile
