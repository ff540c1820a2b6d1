// A strip that hangs under its own weight, and one that hangs between its ends [reference cases 2
// and 3].
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "cloth/model/compile.h"
#include "tests/cloth/panels.h"
#include "tests/validation/reference_table.h"
#include "tests/validation/report.h"
#include "tests/validation/scenes.h"

namespace toile {
namespace strip_test {

constexpr double areal_density = 0.2;  // kg/m²
constexpr double width = 0.05;         // metres

Scene scene_of(double stretch) {
  Scene scene;
  scene.self_contact = false;
  scene.fabric.areal_density = areal_density;
  scene.fabric.stretch_warp = scene.fabric.stretch_weft = stretch;
  scene.fabric.shear = 0.3 * stretch;
  scene.fabric.bending_warp = scene.fabric.bending_weft = 0;
  return scene;
}

/// One metre, held at its top.
class Hanging : public testing::Test {
 protected:
  void hang(double stretch, int rows, std::optional<double> limit = std::nullopt) {
    garment = {};
    const int columns = std::max(2, rows / 20);
    test::add_panel(garment, "strip", test::grid(width, 1, columns, rows),
                    [](const Vec2& p) { return Vec3(p.x(), p.y() - 1, 0); });
    Scene scene = scene_of(stretch);
    scene.strain_limit = limit;
    model = compile(garment, scene, garment.placed);
    test::hold(model, [](const Vec3& p) { return p.y() == 0; });
  }

  /// How far points at `s` from the top came down, mean over the width.
  double sunk(const std::vector<Vec3>& x, double s) const {
    double sum = 0;
    int count = 0;
    for (std::size_t p = 0; p < x.size(); ++p) {
      if (std::abs(garment.flat[p].y() - (1 - s)) > 1e-9) continue;
      sum += model.start[p].y() - x[p].y();
      ++count;
    }
    return sum / count;
  }

  /// Largest error of the profile where the mesh has a row, over the whole elongation.
  double profile_error(const std::vector<Vec3>& x, double stretch,
                       const std::string& column) const {
    double worst = 0, whole = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (table.at(row, "Y_N_m") != stretch) continue;
      const double s = table.at(row, "s_m"), u = table.at(row, column);
      worst = std::max(worst, std::abs(sunk(x, s) - u));
      whole = std::max(whole, u);
    }
    return worst / whole;
  }

  PanelMesh garment;
  GarmentModel model;
  const test::ReferenceTable table{"case03_hanging_strip.csv"};
  const test::ReferenceTable totals{"case03_totals.csv"};
};

TEST_F(Hanging, StretchesWithTheWeightBelow) {
  for (const double stretch : {65.4, 500.0, 2000.0}) {
    hang(stretch, 40);
    const std::vector<Vec3> x = test::relaxed(model);
    const std::string strip = "strip of " + test::number(stretch) + " N/m hung up: ";
    test::expect_relative({strip + "elongation", "relaxation", "40 rows", "mm"}, 1000 * sunk(x, 1),
                          1000 * totals.find("Y_N_m", stretch, "total_u_linear_m"), 0.005);
    test::expect_near({strip + "profile, of the elongation", "relaxation", "40 rows", "%"},
                      100 * profile_error(x, stretch, "u_linear_m"), 0, 0.5);
  }
}

TEST_F(Hanging, IsHeldToItsLimit) {
  hang(65.4, 40, 0.01);
  const std::vector<Vec3> x = test::relaxed(model);
  const std::string strip = "strip of 65.4 N/m hung up, limited to 1 %: ";
  test::expect_relative({strip + "elongation", "relaxation", "40 rows", "mm"}, 1000 * sunk(x, 1),
                        1000 * totals.find("Y_N_m", 65.4, "total_u_limited_1pct_m"), 0.005);
  test::expect_near({strip + "profile, of the elongation", "relaxation", "40 rows", "%"},
                    100 * profile_error(x, 65.4, "u_limited_1pct_m"), 0, 0.5);
  double most = 0;
  for (int row = 0; row < 40; ++row) {
    most = std::max(most, 40 * (sunk(x, (row + 1) / 40.0) - sunk(x, row / 40.0)));
  }
  test::expect_near({strip + "largest strain", "relaxation", "40 rows", "%"}, 100 * most, 1, 0.01);
}

// Edges of triangles as springs [Van Gelder 1998]. Those along the strip have its modulus. The
// diagonals give way by narrowing it, but the less, the more the strip is stretched.
TEST_F(Hanging, ClothOfSpringsStretchesLikewise) {
  for (const double stretch : {65.4, 500.0}) {
    hang(stretch, 40);
    const std::vector<Vec3> x = test::sprung(garment, model);
    const double whole = totals.find("Y_N_m", stretch, "total_u_linear_m");
    const std::string strip = "strip of " + test::number(stretch) + " N/m hung up: ";
    test::Figure figure{strip + "elongation", "springs", "40 rows", "mm"};
    if (stretch < 100) figure.asked = 0.005, figure.reason = "model: the diagonals pull along";
    test::expect_relative(figure, 1000 * sunk(x, 1), 1000 * whole, stretch < 100 ? 0.008 : 0.005);
    // But it is linear: the profile is that of its own elongation.
    double worst = 0;
    for (int row = 0; row <= 40; ++row) {
      const double s = row / 40.0;
      worst = std::max(worst, std::abs(sunk(x, s) / sunk(x, 1) - (2 * s - s * s)));
    }
    test::expect_near({strip + "profile, of its own elongation", "springs", "40 rows", "%"},
                      100 * worst, 0, 0.5);
  }
}

/// Between two ends at the heights and the span of a row of case02_catenary.csv.
class Catenary : public testing::Test {
 protected:
  void hang(const std::string& set, int columns) {
    const test::ReferenceTable table("case02_catenary.csv");
    std::size_t row = 0;
    while (table.text(row, "set") != set) ++row;
    const double length = table.at(row, "rest_length_m");
    span = table.at(row, "span_m");
    const double rise = table.at(row, "right_minus_left_height_m");
    garment = {};
    const int rows = 2;
    // Begins as a tent, of its length.
    const double half = 0.5 * length;
    const double peak = std::sqrt(std::max(half * half - 0.25 * span * span, 1e-4));
    test::add_panel(garment, "strip", test::grid(length, width, columns, rows), [&](const Vec2& p) {
      const double s = p.x() / length;
      return Vec3(span * s, rise * s - 2 * peak * std::min(s, 1 - s), -p.y());
    });
    model = compile(garment, scene_of(table.at(row, "EA_N") / width), garment.placed);
    test::hold(model, [&](const Vec3& p) { return p.x() == 0 || p.x() == span; });
  }

  /// Largest distance of points from their places on the catenary, over the span.
  double shape_error(const std::vector<Vec3>& x, const std::string& set) const {
    const test::ReferenceTable table("case02_profiles.csv");
    const double length = garment.flat.back().x();
    double worst = 0;
    int seen = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (table.text(row, "set") != set) continue;
      for (std::size_t p = 0; p < x.size(); ++p) {
        if (std::abs(garment.flat[p].x() / length - table.at(row, "s_over_L")) > 1e-9) continue;
        ++seen;
        worst = std::max(
            worst, std::hypot(x[p].x() - table.at(row, "x_m"), x[p].y() - table.at(row, "y_m")));
      }
    }
    EXPECT_GE(seen, 3 * 41);
    return worst / span;
  }

  PanelMesh garment;
  GarmentModel model;
  double span = 0;
};

TEST_F(Catenary, ShapeOfAStripBetweenTwoEnds) {
  for (const std::string set :
       {"elastic_Y2000_equal", "elastic_Y200_equal", "elastic_Y200_unequal", "elastic_Y20_taut"}) {
    hang(set, 80);
    test::expect_near({"catenary " + set + ": shape, of the span", "relaxation", "80 columns", "%"},
                      100 * shape_error(test::relaxed(model), set), 0, 0.2);
  }
}

TEST_F(Catenary, ShapeOfAStripOfSprings) {
  for (const std::string set : {"elastic_Y200_equal", "elastic_Y200_unequal"}) {
    hang(set, 40);
    test::expect_near({"catenary " + set + ": shape, of the span", "springs", "40 columns", "%"},
                      100 * shape_error(test::sprung(garment, model, {.seconds = 6}), set), 0, 0.2);
  }
}

}  // namespace strip_test
}  // namespace toile
