// A tube that is too small for what it is drawn over: Laplace's pressure [reference case 8].
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "cloth/model/compile.h"
#include "cloth/model/stretch.h"
#include "cloth/relaxation/relax.h"
#include "cloth/scene/collider.h"
#include "geometry/distance_grid.h"
#include "tests/cloth/panels.h"
#include "tests/support/tubes.h"
#include "tests/validation/reference_table.h"
#include "tests/validation/report.h"

namespace toile {
namespace tube_test {

constexpr double pi = std::numbers::pi;
constexpr double offset = 0.002;  // metres that the body keeps off
constexpr int rows = 8;
constexpr double height = 0.04;

/// On the ellipse of half axes a (x) and b (z), where cloth is to lie, drawn over a body inside it.
class Tube : public testing::Test {
 protected:
  void draw_over(double a, double b, double rest_girth, const Fabric& fabric, int columns,
                 double grain = 0, double cell = DistanceGridOptions().cell) {
    TriangleMesh mesh = test::closed_tube(a, b, 0.3, 720);
    for (Vec3& p : mesh.points) {
      const Vec3 normal(p.x() / (a * a), 0, p.z() / (b * b));
      if (normal.norm() > 0) p -= offset * normal.normalized();
    }
    const Collider body(mesh, {}, {.cell = cell});
    garment = {};
    girth = rest_girth;
    sides = columns;
    test::add_panel(garment, "tube", test::grid(girth, height, columns, rows), [&](const Vec2& p) {
      const double angle = 2 * pi * p.x() / girth;
      return Vec3(1.01 * a * std::sin(angle), 0.13 + p.y(), 1.01 * b * std::cos(angle));
    });
    garment.panels[0].grain = grain;
    garment.seams = {test::seam("", test::side(garment.panels[0], columns, rows, false),
                                test::side(garment.panels[0], columns, rows, true))};
    Scene scene;
    scene.collider = &body;
    scene.body_contact = BodyContactTerm::nodes;
    scene.body_offset = offset;
    scene.self_contact = false;
    scene.fabric = fabric;
    model = compile(garment, scene, garment.placed);
    // The residual is counted in weights, so there is gravity; it does not act.
    RelaxOptions options;
    options.gravity = 0;
    options.friction = false;
    options.max_iterations = 40000;
    options.stop_median = options.stop_rms = 1e-3;
    x = model.start;
    EXPECT_TRUE(relax(model, options, x).converged);
    push = std::vector<Vec3>(x.size(), Vec3::Zero());
    for (std::size_t t = 0; t < model.stretch.size(); ++t) {
      const Triangle& n = model.node_triangles[t];
      const auto pull = stretch_forces(model.stretch[t], {}, x[n[0]], x[n[1]], x[n[2]]);
      for (int i = 0; i < 3; ++i) push[n[i]] -= pull[i];
    }
  }

  Vec3 at(int column, int row) const { return x[node(column, row)]; }
  int node(int column, int row) const {
    return model.node_of_point[row * (sides + 1) + column % sides];
  }
  double strain(int row) const {
    double length = 0;
    for (int i = 0; i < sides; ++i) length += (at(i + 1, row) - at(i, row)).norm();
    return length / girth - 1;
  }
  /// What the body pushes outward with at a column, away from the borders: Pa.
  double pressure(int column) const {
    const int row = rows / 2;
    const Vec3 along = at(column + 1, row) - at(column + sides - 1, row);
    const Vec3 outward = Vec3(along.z(), 0, -along.x()).normalized();
    const double area = 0.25 * along.norm() * (at(column, row + 1) - at(column, row - 1)).norm();
    return std::abs(push[node(column, row)].dot(outward)) / area;
  }

  PanelMesh garment;
  GarmentModel model;
  std::vector<Vec3> x;
  std::vector<Vec3> push;  // N, of the body on each node: the cloth's pull, turned around
  double girth = 0;
  int sides = 0;
};

TEST_F(Tube, HasTheStrainAndThePressureOfLaplace) {
  const test::ReferenceTable table("case08_tube_on_cylinder.csv");
  int seen = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double radius = table.at(row, "R_m"), strain_there = table.at(row, "hoop_strain");
    if (radius < 0.1 || table.at(row, "nu") != 0 || table.at(row, "Y_N_m") != 500) continue;
    ++seen;
    for (const auto& [turned, columns] : {std::pair(false, 144), {true, 144}, {false, 288}}) {
      const double cell = 0.005 * 144 / columns;
      // The threads that go along the tube don't count.
      Fabric fabric;
      fabric.stretch_weft = turned ? 900 : 500;
      fabric.stretch_warp = turned ? 500 : 900;
      draw_over(radius, radius, table.at(row, "rest_girth_m"), fabric, columns, turned ? pi / 2 : 0,
                cell);
      double mean = 0;
      for (int r = 0; r <= rows; ++r) mean += strain(r) / (rows + 1);
      double pressed = 0;
      for (int c = 0; c < sides; ++c) pressed += pressure(c) / sides;
      const std::string tube = "too small tube, " + test::number(100 * strain_there, 2) +
                               " % on a cylinder of " + test::number(100 * radius) + " cm, " +
                               (turned ? "warp" : "weft") + " around: ";
      const std::string at =
          std::to_string(columns) + " x 8, cells of " + test::number(1000 * cell, 2) + " mm";
      test::Figure of_strain{tube + "hoop strain", "relaxation", at, "%"};
      test::Figure of_pressure{tube + "pressure", "relaxation", at, "Pa"};
      // At such a small strain two errors count. The grid cuts 21 micrometres off 15 cm and the
      // chords cut off 12; both shrink with the square of the mesh.
      const bool is_slight = strain_there < 0.02 && columns == 144;
      if (is_slight) {
        of_strain.asked = of_pressure.asked = 0.01;
        of_strain.reason = of_pressure.reason = "grid and chords cut off 0.03 mm of a 15 cm curve";
      }
      const double bound = is_slight ? 0.025 : 0.01;
      test::expect_relative(of_strain, 100 * mean, 100 * strain_there, bound);
      test::expect_relative(of_pressure, pressed, table.at(row, "pressure_Pa_rest_area"), bound);
    }
  }
  EXPECT_GE(seen, 2);
}

TEST_F(Tube, PressesOnAnEllipseByItsCurvature) {
  const test::ReferenceTable table("case08_tube_on_ellipse.csv");
  Fabric fabric;
  fabric.stretch_weft = 500;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double a = table.at(row, "a_m"), b = table.at(row, "b_m");
    if (a == b || table.at(row, "hoop_strain") != 0.05) continue;
    draw_over(a, b, table.at(row, "rest_girth_m"), fabric, 240);
    double most = 0, least = 1e9;
    for (int c = 0; c < sides; ++c) {
      most = std::max(most, pressure(c));
      least = std::min(least, pressure(c));
    }
    const std::string tube = "too small tube on an ellipse of " + test::number(100 * a) + " x " +
                             test::number(100 * b) + " cm: ";
    test::expect_relative({tube + "hoop strain", "relaxation", "240 x 8", "%"},
                          100 * strain(rows / 2), 5, 0.01);
    test::expect_relative({tube + "pressure at the long ends", "relaxation", "240 x 8", "Pa"}, most,
                          table.at(row, "p_max_Pa_end_of_major_axis"), 0.02);
    test::expect_relative({tube + "pressure at the flat sides", "relaxation", "240 x 8", "Pa"},
                          least, table.at(row, "p_min_Pa_end_of_minor_axis"), 0.02);
  }
}

}  // namespace tube_test
}  // namespace toile
