#include "cloth/model/elastics.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "cloth/model/compile.h"
#include "cloth/model/gathers.h"
#include "cloth/relaxation/elastic_forces.h"
#include "cloth/relaxation/elastic_kernel.h"
#include "cloth/relaxation/relax.h"
#include "cloth/scene/collider.h"
#include "geometry/distance_grid.h"
#include "tests/cloth/panels.h"
#include "tests/support/slope.h"
#include "tests/support/tubes.h"

namespace toile {
namespace elastics_test {

constexpr double pi = std::numbers::pi;

/// Points of a row of a grid() panel.
std::vector<int> row_of(int columns, int row) {
  std::vector<int> points(columns + 1);
  std::iota(points.begin(), points.end(), row * (columns + 1));
  return points;
}

TEST(Bands, PullAsTheGradientOfTheirEnergy) {
  constexpr int columns = 5;
  PanelMesh garment = test::flat_panel(test::grid(0.05, 0.02, columns, 2));
  garment.elastics = {{"panel.2", row_of(columns, 2), 0.6, 15}};
  const GarmentModel model = compile(garment, {}, garment.placed);
  ASSERT_EQ(model.elastics.size(), 5u);
  for (const ElasticSegment& s : model.elastics) {
    EXPECT_NEAR(s.flat, 0.01, 1e-15);
    EXPECT_NEAR(s.rest, 0.006, 1e-15);
    // The row of triangles on it is 1 cm deep.
    EXPECT_NEAR(s.cloth, 1000 * 0.01, 1e-9);
  }
  const auto energy = [&](const Vec4s& x) {
    double sum = 0;
    for (const ElasticSegment& s : model.elastics) {
      const double length = std::sqrt(squared_length(x[s.points[0]] - x[s.points[1]]));
      const double elastic = std::max(length / s.rest - 1, 0.0);
      const double cloth = std::max(length / s.flat - 1, 0.0);
      sum += 0.5 * (s.rest * s.stiffness * elastic * elastic + s.flat * s.cloth * cloth * cloth);
    }
    return sum;
  };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const ElasticForces elastics(model, false);
  int slack = 0, stretched = 0, beyond = 0;
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<Vec3> places = garment.placed;
    for (Vec3& p : places) p += 0.004 * Vec3(unit(random), unit(random), unit(random));
    const Vec4s x = as_vec4(places);
    for (const ElasticSegment& s : model.elastics) {
      const double length = (places[s.points[0]] - places[s.points[1]]).norm();
      ++(length < s.rest ? slack : length < s.flat ? stretched : beyond);
    }
    Vec4s force(x.size(), Vec4{});
    elastics.add(0, x.size(), x, force);
    const std::vector<Vec3> slope = test::slope(energy, x, 1e-8);
    for (std::size_t v = 0; v < x.size(); ++v) {
      ASSERT_LT((as_vec3(force[v]) + slope[v]).cwiseAbs().maxCoeff(), 1e-5) << v;
    }
  }
  EXPECT_GT(slack, 2);
  EXPECT_GT(stretched, 20);
  EXPECT_GT(beyond, 20);
}

TEST(Bands, WithoutElasticsThereIsNoTerm) {
  const PanelMesh garment = test::flat_panel(test::grid(0.05, 0.02, 5, 2));
  const GarmentModel model = compile(garment, {}, garment.placed);
  EXPECT_TRUE(model.elastics.empty());
  EXPECT_TRUE(ElasticForces(model, false).empty());
}

constexpr int columns = 5, rows = 4;

/// Two panels that are sewn to each other, with an elastic along the seam.
PanelMesh drawn_up_at_a_seam() {
  PanelMesh garment;
  for (const double y : {0.0, 0.1}) {
    test::add_panel(garment, "panel", test::grid(0.05, 0.04, columns, rows),
                    [&](const Vec2& p) { return Vec3(p.x(), p.y() + y, 0); });
  }
  std::vector<int> top = row_of(columns, rows);
  std::vector<int> bottom = row_of(columns, 0);
  for (int& p : bottom) p += garment.panels[1].first_point;
  garment.seams = {test::seam("waist", top, bottom)};
  garment.elastics = {{"panel.2", top, 0.5, 20}};
  return garment;
}

TEST(Bands, AlongASeamLeftOpenTheyDrawUpTheirOwnSideOnly) {
  PanelMesh garment = drawn_up_at_a_seam();
  const MeshedSeam& seam = garment.seams.front();
  garment.unsewn.assign(garment.flat.size(), 0);
  garment.unsewn[seam.a[0]] = garment.unsewn[seam.b[0]] = 1;
  EXPECT_EQ(elastic_edges(garment).size(), 2u * columns - 1);
  const GarmentModel model = compile(garment, {}, garment.placed);
  EXPECT_EQ(model.nodes, 2 * (columns + 1) * (rows + 1) - columns);
  EXPECT_NEAR(model.elastics[0].cloth, 1000 * 0.01, 1e-9);
  EXPECT_NEAR(model.elastics[1].cloth, 2 * 1000 * 0.01, 1e-9);
}

TEST(Bands, ClothAlongThemIsFreeOnBothSidesOfASeam) {
  const PanelMesh garment = drawn_up_at_a_seam();
  EXPECT_EQ(elastic_edges(garment).size(), 2u * columns);
  const GarmentModel model = compile(garment, {}, garment.placed);
  int free = 0;
  for (const StretchTriangle& s : model.stretch) {
    free += s.weft_stiffness < 0.5 * 1000 * s.area;
    EXPECT_NEAR(s.warp_stiffness, 1000 * s.area, 1e-12);
  }
  // A row on either side, less the two triangles that only touch its ends.
  EXPECT_EQ(free, 2 * 2 * columns - 2);
  EXPECT_NEAR(model.elastics[0].cloth, 2 * 1000 * 0.01, 1e-9);
}

/// A tube of cloth of `girth` around a cylinder, drawn up at its upper edge by an elastic.
/// Reference case 8 on a line: T = k (2π(R + δ)/rest - 1), and the body feels T/R per length.
class ElasticTube : public testing::Test {
 protected:
  static constexpr double radius = 0.1, offset = 0.002, stiffness = 20;
  static constexpr int columns = 96, rows = 12;

  void wear(double girth, double ratio) {
    static const Collider body{test::closed_tube(radius, radius, 0.5, 400)};
    garment_ = {};
    const double start = std::max(girth / (2 * pi), radius + 0.004);
    test::add_panel(garment_, "tube", test::grid(girth, 0.08, columns, rows), [&](const Vec2& p) {
      const double angle = 2 * pi * p.x() / girth;
      // A little uneven, so that it need not stand on a crest.
      const double r = start + 0.001 * std::sin(24 * angle);
      return Vec3(r * std::sin(angle), 0.2 + p.y(), r * std::cos(angle));
    });
    garment_.seams = {test::seam("", test::side(garment_.panels[0], columns, rows, false),
                                 test::side(garment_.panels[0], columns, rows, true))};
    garment_.elastics = {{"tube.2", row_of(columns, rows), ratio, stiffness}};
    Scene scene;
    scene.collider = &body;
    scene.body_contact = BodyContactTerm::nodes;
    model_ = compile(garment_, scene, garment_.placed);
    RelaxOptions options;
    options.gravity = 0;
    options.friction = false;
    options.max_iterations = 8000;
    options.stop_median = options.stop_rms = 0.02;
    x_ = model_.start;
    relax(model_, options, x_);
    band_ = measure_elastics(garment_, point_positions(model_, x_)).at(0);
  }

  /// N: with which cloth and elastic press on the cylinder, in all. Where the cloth presses on
  /// itself adds up to nothing.
  double pressing() const {
    Vec4s force(model_.nodes, Vec4{});
    const Vec4s x = as_vec4(x_);
    ElasticKernel cloth(model_, false);
    cloth.pull(0, cloth.groups(), {}, x);
    cloth.gather(0, force.size(), 1, 1, x, force);
    ElasticForces(model_, false).add(0, force.size(), x, force);
    double inward = 0;
    for (int n = 0; n < model_.nodes; ++n) {
      const Vec3 out = Vec3(x_[n].x(), 0, x_[n].z()).normalized();
      inward -= out.dot(as_vec3(force[n]));
    }
    return inward;
  }

  PanelMesh garment_;
  GarmentModel model_;
  std::vector<Vec3> x_;
  ElasticMeasurement band_;
};

TEST_F(ElasticTube, HoldsTheCylinderByItsTension) {
  const double around = 2 * pi * (radius + offset);
  constexpr double ratio = 0.5;
  const double girth = 1.6 * around;
  wear(girth, ratio);
  const double wanted = stiffness * (around / (ratio * girth) - 1);
  std::cout << "ratio " << ratio << ": " << 100 * band_.now << " cm (cylinder " << 100 * around
            << "), tension " << band_.tension << " N (" << wanted << "), presses with "
            << pressing() << " N (" << 2 * pi * wanted << ")\n";
  EXPECT_NEAR(band_.flat, girth, 1e-12);
  EXPECT_NEAR(band_.rest, ratio * girth, 1e-12);
  // The contact gives way by half a millimetre.
  EXPECT_NEAR(band_.now / around, 1, 0.008);
  EXPECT_NEAR(band_.tension / wanted, 1, 0.03);
  // What the cloth in its folds takes off the tension is less than 0.15 N.
  EXPECT_NEAR(pressing(), 2 * pi * band_.tension, 2 * pi * 0.15);
  // Drawn up, the cloth is not crushed: 4 cm below, its own girth is there.
  const std::vector<Vec3> points = point_positions(model_, x_);
  double girth_now = 0;
  for (int i = 0; i < columns; ++i) {
    const int a = (rows - 6) * (columns + 1) + i;
    girth_now += (points[a] - points[a + 1]).norm();
  }
  EXPECT_NEAR(girth_now / girth, 1, 0.02);
}

TEST_F(ElasticTube, DoesNotPullWhereItIsSlack) {
  const double around = 2 * pi * (radius + offset);
  wear(1.3 * around, 0.9);
  EXPECT_LT(band_.tension, 0.1);
  EXPECT_GT(band_.now, 1.05 * around);
}

TEST_F(ElasticTube, PulledOutToItsFlatLengthTheClothTakesPart) {
  // The cloth's girth is 5 % too small as well.
  const double around = 2 * pi * (radius + offset);
  wear(around / 1.05, 0.8);
  std::cout << "cloth " << 100 * (band_.now / band_.flat - 1) << " % longer, elastic's tension "
            << band_.tension << " N, presses with " << pressing() << " N\n";
  EXPECT_NEAR(band_.now / band_.flat - 1, 0.05, 0.006);
  EXPECT_NEAR(band_.tension, stiffness * (1.05 / 0.8 - 1), 0.15);
  // All of the cloth presses as if there were no elastic, and the elastic presses besides. The row
  // of triangles on it gives way along it, and the segment stands for that row.
  const double cloth = 2 * pi * 0.05 * 1000 * 0.08;
  EXPECT_NEAR(pressing(), cloth + 2 * pi * band_.tension, 0.05 * cloth);
}

}  // namespace elastics_test
}  // namespace toile
