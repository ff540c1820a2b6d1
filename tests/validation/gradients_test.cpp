// Every force is the gradient of an energy; moved as one, cloth feels nothing new; at rest nothing.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "cloth/model/compile.h"
#include "cloth/model/elastics.h"
#include "cloth/model/stretch.h"
#include "cloth/relaxation/cloth_forces.h"
#include "cloth/scene/collider.h"
#include "cloth/springs/spring_forces.h"
#include "cloth/springs/spring_sheet.h"
#include "geometry/distance_grid.h"
#include "tests/cloth/bend_energy.h"
#include "tests/cloth/panels.h"
#include "tests/support/shapes.h"
#include "tests/support/slope.h"
#include "tests/support/spring_energy.h"
#include "tests/support/stretch_energy.h"
#include "tests/support/tubes.h"
#include "tests/validation/report.h"
#include "tests/validation/scenes.h"

namespace toile {
namespace gradients_test {

using Places = std::vector<Vec3>;

/// Two unstructured panels sewn side by side, of a fabric with all terms, its grain turned, with an
/// elastic along an edge.
class Sewn : public testing::Test {
 protected:
  Sewn() {
    const PlanarMesh half = test::cut_rectangle(0.05, 0.04, 0.01, test::Cut::unstructured);
    const auto place = [](double shift) {
      return [shift](const Vec2& p) { return Vec3(p.x() + shift, p.y(), 0); };
    };
    test::add_panel(garment, "left", half, place(-0.05));
    test::add_panel(garment, "right", half, place(0));
    garment.panels[0].grain = 0.4;
    garment.seams = {test::seam("middle", along(0, 0.05), along(1, 0))};
    scene.self_contact = false;
    scene.fabric.stretch_warp = 1500;
    scene.fabric.stretch_weft = 700;
    scene.fabric.bending_warp = 3e-5;
  }

  /// Points of a panel where x is `x`, upward.
  std::vector<int> along(int panel, double x) const {
    std::vector<int> points;
    for (int p = 0; p < garment.panels[panel].points; ++p) {
      const int at = garment.panels[panel].first_point + p;
      if (std::abs(garment.flat[at].x() - x) < 1e-9) points.push_back(at);
    }
    std::sort(points.begin(), points.end(),
              [&](int a, int b) { return garment.flat[a].y() < garment.flat[b].y(); });
    return points;
  }

  void add_elastic() {
    garment.elastics = {{"left.side", along(0, 0), 0.7, 15}};
    ASSERT_GT(garment.elastics[0].points.size(), 3u);
  }

  Places crumpled(const GarmentModel& model, double by) {
    Places x = model.start;
    for (Vec3& p : x) p += by * Vec3(unit(random), unit(random), unit(random));
    return x;
  }

  PanelMesh garment;
  Scene scene;
  std::mt19937 random{11};
  std::uniform_real_distribution<double> unit{-1, 1};
};

/// What the relaxation and the release move by: one a node, N.
Places forces(const GarmentModel& model, const ForceOptions& options, const Places& x,
              std::vector<double>* bounds = nullptr) {
  ClothForces all(model, options, {0, 0}, x, false);
  Vec4s found(x.size());
  all.step_forces(1, [&](std::size_t begin, std::size_t end, const Vec4s& some) {
    std::copy(some.begin() + begin, some.begin() + end, found.begin() + begin);
  });
  Places forces(x.size());
  if (bounds != nullptr) bounds->resize(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) {
    forces[n] = as_vec3(found[n]);
    if (bounds != nullptr) (*bounds)[n] = found[n][3];
  }
  return forces;
}

/// Of stretch, shear, bending, elastics and weight, J.
double energy(const GarmentModel& model, const Places& x) {
  const auto at = [&](int point) { return x[model.node_of_point[point]]; };
  double sum = 0;
  for (std::size_t t = 0; t < model.stretch.size(); ++t) {
    const Triangle& c = model.triangles[t];
    sum += stretch_energy(model.stretch[t], -1, at(c[0]), at(c[1]), at(c[2]));
  }
  Places points(model.node_of_point.size());
  for (std::size_t p = 0; p < points.size(); ++p) points[p] = at(static_cast<int>(p));
  sum += test::bend_energy(model, points);
  for (const ElasticSegment& s : model.elastics) {
    const double length = (at(s.points[0]) - at(s.points[1])).norm();
    sum += 0.5 * s.rest * s.stiffness * std::pow(std::max(length / s.rest - 1, 0.0), 2) +
           0.5 * s.flat * s.cloth * std::pow(std::max(length / s.flat - 1, 0.0), 2);
  }
  for (std::size_t n = 0; n < x.size(); ++n) {
    sum -= model.mass[n] * model.scene.gravity.dot(x[n]);
  }
  return sum;
}

double largest(const Places& vectors) {
  double most = 0;
  for (const Vec3& v : vectors) most = std::max(most, v.norm());
  return most;
}

/// Largest difference of the forces from the energy's central differences, over the largest force.
template <typename Energy>
double gradient_error(const Energy& energy, const Places& force, const Places& x, double h) {
  const Places slope = test::slope(energy, x, h);
  double worst = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    worst = std::max(worst, (force[n] + slope[n]).cwiseAbs().maxCoeff());
  }
  return worst / largest(force);
}

/// Derivatives of the forces, minus: the stiffness, by central differences.
Eigen::MatrixXd stiffness_of(const GarmentModel& model, const ForceOptions& options, Places x,
                             double h) {
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index column = 0; column < size; ++column) {
    double& moved = x[column / 3][column % 3];
    const double place = moved;
    moved = place + h;
    const Places above = forces(model, options, x);
    moved = place - h;
    const Places below = forces(model, options, x);
    moved = place;
    for (Eigen::Index row = 0; row < size; ++row) {
      matrix(row, column) = (below[row / 3][row % 3] - above[row / 3][row % 3]) / (2 * h);
    }
  }
  return matrix;
}

/// A matrix of second derivatives is symmetric: how far this is from one.
double asymmetry(const Eigen::MatrixXd& matrix) {
  return (matrix - matrix.transpose()).cwiseAbs().maxCoeff() / matrix.cwiseAbs().maxCoeff();
}

TEST_F(Sewn, ElasticForcesAreMinusTheGradientOfTheEnergy) {
  add_elastic();
  const GarmentModel model = compile(garment, scene, garment.placed);
  ASSERT_FALSE(model.elastics.empty());
  ASSERT_TRUE(std::any_of(model.bend.begin(), model.bend.end(),
                          [](const BendHinge& hinge) { return hinge.across_seam; }));
  double worst = 0;
  for (int trial = 0; trial < 5; ++trial) {
    const Places x = crumpled(model, 0.004);
    worst = std::max(worst, gradient_error([&](const Places& at) { return energy(model, at); },
                                           forces(model, {}, x), x, 1e-7));
  }
  test::expect_near({"forces are the energy's gradient: stretch, shear, bending, elastic, weight",
                     "relaxation", "two sewn panels, crumpled", "of the largest force"},
                    worst, 0, 1e-7);
}

TEST_F(Sewn, ClothOfSpringsPullsByTheGradientOfItsEnergy) {
  const GarmentModel model = compile(garment, scene, garment.placed);
  SpringSheet sheet(garment, model);
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) sheet.merge(seam.a[i], seam.b[i]);
  }
  sheet.refresh();
  std::vector<Spring> springs = sheet.edges();
  springs.insert(springs.end(), sheet.bending().begin(), sheet.bending().end());
  Places x = garment.placed;
  for (Vec3& p : x) p += 0.004 * Vec3(unit(random), unit(random), unit(random));
  Places force(x.size(), Vec3::Zero());
  SpringForces(springs, sheet.points()).add(x, Places(x.size(), Vec3::Zero()), force);
  const double worst =
      gradient_error([&](const Places& at) { return spring_energy(springs, at); }, force, x, 1e-7);
  test::expect_near({"forces are the energy's gradient: edges, bending", "springs",
                     "two sewn panels, crumpled", "of the largest force"},
                    worst, 0, 1e-7);
}

/// A small sheet that lies `depth` deep in what the body keeps clear, uneven.
struct Pressed {
  explicit Pressed(const Collider& body, double height) {
    test::add_panel(
        garment, "sheet", test::cut_rectangle(0.03, 0.03, 0.01, test::Cut::unstructured),
        [&](const Vec2& p) {
          return Vec3(p.x() - 0.015, height + 0.01 * p.x() * (1 - 20 * p.y()), p.y() - 0.015);
        });
    scene.collider = &body;
    scene.body_contact = BodyContactTerm::nodes;
    scene.self_contact = false;
  }
  double asymmetry_of(const ForceOptions& options) const {
    const GarmentModel model = compile(garment, scene, garment.placed);
    GarmentModel rigid = model;  // what touches alone
    for (StretchTriangle& s : rigid.stretch) {
      s.weft_stiffness = s.warp_stiffness = s.shear_stiffness = 0;
    }
    rigid.bend.clear();
    EXPECT_GT(largest(forces(rigid, options, model.start)), 10 * model.mean_weight);
    return asymmetry(stiffness_of(rigid, options, model.start, 1e-7));
  }
  PanelMesh garment;
  Scene scene;
};

TEST(ContactForces, TheBodysPushIsAGradient) {
  const Collider plane{test::box({-0.1, -0.1, -0.1}, {0.1, 0, 0.1})};
  TriangleMesh tube = test::closed_tube(0.05, 0.05, 0.2, 200);
  for (Vec3& p : tube.points) p = Vec3(p.y() - 0.1, -p.x(), p.z());
  const Collider round{tube};
  ForceOptions options;
  options.friction = false;
  test::expect_near({"the body's push: asymmetry of its stiffness", "relaxation", "plane", ""},
                    Pressed(plane, 0.0015).asymmetry_of(options), 0, 1e-6);
  test::expect_near(
      {"the body's push: asymmetry of its stiffness", "relaxation", "cylinder of 5 cm", ""},
      Pressed(round, 0.0515).asymmetry_of(options), 0, 0.05);
}

/// Two sheets 0.6 mm apart and more, where 2 mm are kept, one turned.
TEST(ContactForces, ThePushOfClothOnClothIsAGradient) {
  PanelMesh garment;
  const PlanarMesh mesh = test::cut_rectangle(0.03, 0.03, 0.01, test::Cut::unstructured);
  test::add_panel(garment, "below", mesh, [](const Vec2& p) { return Vec3(p.x(), 0, -p.y()); });
  test::add_panel(garment, "above", mesh, [](const Vec2& p) {
    const Vec2 q = Eigen::Rotation2Dd(0.3) * p;
    return Vec3(q.x() + 0.004, 0.0006 + 0.02 * p.x(), -q.y() - 0.001);
  });
  const GarmentModel model = compile(garment, {}, garment.placed);
  GarmentModel rigid = model;
  for (StretchTriangle& s : rigid.stretch) {
    s.weft_stiffness = s.warp_stiffness = s.shear_stiffness = 0;
  }
  rigid.bend.clear();
  for (const bool barrier : {false, true}) {
    ForceOptions options;
    options.bounded = barrier;
    ASSERT_GT(largest(forces(rigid, options, model.start)), 10 * model.mean_weight);
    test::expect_near({"the push of cloth on cloth: asymmetry of its stiffness", "relaxation",
                       barrier ? "two sheets, barrier" : "two sheets", ""},
                      asymmetry(stiffness_of(rigid, options, model.start, 1e-8)), 0, 1e-4);
  }
}

TEST_F(Sewn, NoStiffnessIsBeyondItsBound) {
  // Of the stiffness over its bounds, the largest eigenvalue: beyond 2 a step would go too far.
  const GarmentModel model = compile(garment, scene, garment.placed);
  for (const double by : {0.0, 0.0005}) {
    const Places x = crumpled(model, by);
    std::vector<double> bounds;
    forces(model, {}, x, &bounds);
    Eigen::MatrixXd matrix = stiffness_of(model, {}, x, 1e-8);
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        matrix(i, j) /= std::sqrt(bounds[i / 3] * bounds[j / 3]);
      }
    }
    const Eigen::MatrixXd symmetric = 0.5 * (matrix + matrix.transpose());
    const double most =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvalues().maxCoeff();
    const test::Figure figure{"stiffness over the bound that the step is taken from", "relaxation",
                              by > 0 ? "two sewn panels, crumpled" : "two sewn panels, flat"};
    test::state(figure, most, "at most 1", "");
    EXPECT_LE(most, 1.0);
  }
}

TEST_F(Sewn, MovedAndTurnedAsOneItFeelsTheSame) {
  scene.gravity.setZero();
  const GarmentModel model = compile(garment, scene, garment.placed);
  double of_energy = 0, of_forces = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Places x = crumpled(model, 0.003);
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(unit(random), unit(random), unit(random), unit(random)).normalized();
    const Vec3 away(unit(random), unit(random), unit(random));
    Places moved = x;
    for (Vec3& p : moved) p = turn * p + away;
    const Places before = forces(model, {}, x);
    Places after = forces(model, {}, moved);
    for (std::size_t n = 0; n < x.size(); ++n) after[n] -= turn * before[n];
    of_forces = std::max(of_forces, largest(after) / largest(before));
    of_energy = std::max(of_energy, std::abs(energy(model, moved) / energy(model, x) - 1));
  }
  test::expect_near(
      {"rigid motion changes the energy by", "relaxation", "two sewn panels, crumpled", "of it"},
      of_energy, 0, 1e-11);
  test::expect_near({"rigid motion changes the forces by", "relaxation",
                     "two sewn panels, crumpled", "of the largest"},
                    of_forces, 0, 1e-11);
}

TEST_F(Sewn, AtRestItIsFreeOfForces) {
  scene.gravity.setZero();
  const GarmentModel model = compile(garment, scene, garment.placed);
  // Against the force of one strained by a thousandth.
  Places strained = model.start;
  for (Vec3& p : strained) p *= 1.001;
  const double scale = largest(forces(model, {}, strained));
  Places turned = model.start;
  const Eigen::AngleAxisd turn(1.1, Vec3(1, 2, 3).normalized());
  for (Vec3& p : turned) p = turn * p + Vec3(0.3, -2, 1);
  for (const Places& x : {model.start, turned}) {
    test::expect_near(
        {"force on flat cloth", "relaxation",
         x == turned ? "two sewn panels, turned" : "two sewn panels", "of that at 0.1 % strain"},
        largest(forces(model, {}, x)) / scale, 0, 1e-9);
  }
  const SpringSheet sheet(garment, model);
  std::vector<Spring> springs = sheet.edges();
  springs.insert(springs.end(), sheet.bending().begin(), sheet.bending().end());
  Places x = garment.placed;
  for (Vec3& p : x) p = turn * p;
  Places force(x.size(), Vec3::Zero());
  SpringForces(springs, sheet.points()).add(x, Places(x.size(), Vec3::Zero()), force);
  test::expect_near(
      {"force on flat cloth", "springs", "two panels, turned", "of that at 0.1 % strain"},
      largest(force) / scale, 0, 1e-9);
}

}  // namespace gradients_test
}  // namespace toile
