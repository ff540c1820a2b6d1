// Gaps and girths of bodies and garments of known shape [reference case 15].
#include "cloth/ease/ease.h"

#include <gtest/gtest.h>

#include "cloth/ease/girths.h"
#include "geometry/body/skeleton.h"
#include "tests/support/tubes.h"
#include "tests/validation/reference_table.h"
#include "tests/validation/report.h"

namespace toile {
namespace ease_test {

constexpr double gap_bound = 0.05;   // mm
constexpr double girth_bound = 0.1;  // mm

/// Largest error of the gaps, mm.
double gap_error(const DressedGarment& garment, const SurfaceDistance& body, double gap) {
  double worst = 0;
  for (const double measured : measure_ease(garment, body).node_gaps) {
    worst = std::max(worst, 1000 * std::abs(measured - gap));
  }
  return worst;
}

/// Largest error of the girths' ease, mm.
double girth_error(const DressedGarment& garment, const TriangleMesh& body, double ease) {
  Skeleton skeleton;
  skeleton.joints = {{"pelvis", {0, 0.75, 0}}, {"waist", {0, 1.08, 0}}, {"chest", {0, 1.40, 0}}};
  const auto girths = measure_girths(garment, body, skeleton, {}, {.step = 0.1}).rows;
  EXPECT_FALSE(girths.empty());
  double worst = 0;
  for (const Girth& girth : girths) {
    worst = std::max(worst, 1000 * std::abs(girth.ease() - ease));
  }
  return worst;
}

TEST(EaseMapOf, CoaxialCylindersAndSpheres) {
  const test::ReferenceTable table("case15_coaxial.csv");
  for (const double radius : {0.05, 0.15}) {
    const TriangleMesh body = test::closed_tube(radius, radius, 1.6, 800);
    const SurfaceDistance cylinder(body), ball(test::sphere(radius, 6));
    double of_cylinder = 0, of_ball = 0, of_girth = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (table.at(row, "body_radius_m") != radius) continue;
      const double gap = table.at(row, "radial_gap_m");
      const double out = radius + gap;
      const DressedGarment garment = test::cloth_tube(out, out, 0.2, 0.8, 800, 10);
      of_cylinder = std::max(of_cylinder, gap_error(garment, cylinder, gap));
      of_ball = std::max(of_ball, gap_error(test::sphere_garment(out, 4), ball, gap));
      of_girth = std::max(of_girth, girth_error(garment, body, table.at(row, "girth_ease_m")));
    }
    const std::string of = " of " + test::number(100 * radius) + " cm: largest error of the ";
    test::expect_near({"coaxial cylinders" + of + "gap", "ease map", "800 sides", "mm"},
                      of_cylinder, 0, gap_bound);
    test::expect_near({"coaxial cylinders" + of + "girth ease", "ease map", "800 sides", "mm"},
                      of_girth, 0, girth_bound);
    test::expect_near({"concentric spheres" + of + "gap", "ease map", "32768 facets", "mm"},
                      of_ball, 0, gap_bound);
  }
}

TEST(EaseMapOf, AnEllipseAndItsOffset) {
  const test::ReferenceTable table("case15_ellipse.csv");
  double of_gap = 0, of_girth = 0, of_least = 0, of_most = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double a = table.at(row, "a_m"), b = table.at(row, "b_m"), d = table.at(row, "offset_m");
    const TriangleMesh mesh = test::closed_tube(a, b, 1.6, 1200);
    const SurfaceDistance body(mesh);
    DressedGarment garment = test::cloth_tube(a, b, 0.2, 0.8, 1200, 6);
    for (Vec3& p : garment.points) {
      p += d * Vec3(p.x() / (a * a), 0, p.z() / (b * b)).normalized();
    }
    of_gap = std::max(of_gap, gap_error(garment, body, d));
    const double ease = table.at(row, "offset_girth_ease_m");
    of_girth = std::max(of_girth, girth_error(garment, mesh, ease));
    // Both half axes longer by the offset: that is no offset, and nearer in between.
    const EaseStatistics wide =
        measure_ease(test::cloth_tube(a + d, b + d, 0.3, 0.7, 400, 4), body).garment;
    of_least =
        std::max(of_least, 1000 * std::abs(wide.min - table.at(row, "enlarged_ellipse_min_gap_m")));
    of_most =
        std::max(of_most, 1000 * std::abs(wide.max - table.at(row, "enlarged_ellipse_max_gap_m")));
  }
  const std::string shapes = std::to_string(table.rows()) + " ellipses of 1200 sides";
  test::expect_near({"ellipse offset: largest error of the gap", "ease map", shapes, "mm"}, of_gap,
                    0, gap_bound);
  test::expect_near({"ellipse offset: largest error of the girth ease", "ease map", shapes, "mm"},
                    of_girth, 0, girth_bound);
  test::expect_near({"ellipse enlarged: error of the least gap", "ease map", shapes, "mm"},
                    of_least, 0, gap_bound);
  test::expect_near({"ellipse enlarged: error of the largest gap", "ease map", shapes, "mm"},
                    of_most, 0, gap_bound);
}

}  // namespace ease_test
}  // namespace toile
