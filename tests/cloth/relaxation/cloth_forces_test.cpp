#include "cloth/relaxation/cloth_forces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cloth/model/compile.h"
#include "cloth/scene/collider.h"
#include "tests/cloth/panels.h"
#include "tests/support/shapes.h"

namespace toile {
namespace cloth_forces_test {

constexpr int columns = 4, rows = 3;

/// The forces (N) of a step on each node.
std::vector<Vec3> forces_of(ClothForces& forces, std::size_t nodes) {
  std::vector<Vec3> found(nodes);
  forces.step_forces(1, [&](std::size_t begin, std::size_t end, const auto& on_node) {
    for (std::size_t n = begin; n < end; ++n) found[n] = as_vec3(on_node[n]);
  });
  return found;
}

/// Friction over push, summed over a sheet that lies 1 mm deep in its offset from a box and is
/// pushed 1 cm along it.
double friction_over_push(double on_skin, double on_cloth, BodyContactTerm contact) {
  const Collider body{test::box({-0.4, -0.1, -0.4}, {0.4, 0, 0.4})};
  PanelMesh garment;
  test::add_panel(garment, "sheet", test::grid(0.2, 0.15, columns, rows),
                  [](const Vec2& p) { return Vec3(p.x() - 0.1, 0.001, 0.1 - p.y()); });
  Scene scene;
  scene.collider = &body;
  scene.body_contact = contact;
  scene.gravity = Vec3::Zero();
  scene.fabric.friction_skin = on_skin;
  scene.fabric.friction_cloth = on_cloth;
  const GarmentModel model = compile(garment, scene, garment.placed);
  const ForceOptions options;
  ClothForces forces(model, options, {}, model.start, false);
  forces_of(forces, model.nodes);  // the anchors are where it touches first
  forces.advance([&](std::size_t begin, std::size_t end, const auto& move) {
    for (std::size_t n = begin; n < end; ++n) move(n, forces.node(n) + as_vec4(Vec3(0.01, 0, 0)));
  });
  Vec3 sum = Vec3::Zero();
  for (const Vec3& force : forces_of(forces, model.nodes)) sum += force;
  EXPECT_GT(sum.y(), 0);
  return -sum.x() / sum.y();
}

TEST(ClothForces, FrictionOnTheBodyIsTheFabricsOnSkin) {
  for (const auto contact : {BodyContactTerm::nodes, BodyContactTerm::faces}) {
    EXPECT_NEAR(friction_over_push(0.3, 0.9, contact), 0.3, 1e-6);
    EXPECT_NEAR(friction_over_push(0.9, 0.3, contact), 0.9, 1e-6);
    EXPECT_NEAR(friction_over_push(0, 0.9, contact), 0, 1e-9);
  }
}

/// A sheet stretched by 2 % along x, as two panels that are sewn, or as one. The nodes'
/// forces by their positions on a grid.
std::vector<Vec3> forces_on_sheet(bool sewn, bool open) {
  const double width = 0.1, height = 0.15;
  const auto place = [](const Vec2& p) { return Vec3(1.02 * p.x(), p.y(), 0); };
  PanelMesh garment;
  if (sewn) {
    for (const double left : {0.0, width}) {
      test::add_panel(garment, left == 0 ? "a" : "b", test::grid(width, height, columns, rows),
                      [&](const Vec2& p) { return place(p + Vec2(left, 0)); });
    }
    garment.seams = {test::seam("ab", test::side(garment.panels[0], columns, rows, true),
                                test::side(garment.panels[1], columns, rows, false))};
  } else {
    test::add_panel(garment, "whole", test::grid(2 * width, height, 2 * columns, rows), place);
  }
  Scene scene;
  scene.body_contact = BodyContactTerm::none;
  scene.self_contact = false;
  const GarmentModel model = compile(garment, scene, garment.placed);
  const ForceOptions options;
  ClothForces forces(model, options, {}, model.start, open);
  const std::vector<Vec3> found = forces_of(forces, model.nodes);
  std::vector<Vec3> by_place(static_cast<std::size_t>((2 * columns + 1) * (rows + 1)));
  for (std::size_t n = 0; n < found.size(); ++n) {
    const Vec3& at = model.start[n];
    const auto column = std::lround(at.x() / 1.02 / width * columns);
    const auto row = std::lround(at.y() / height * rows);
    by_place[static_cast<std::size_t>(row * (2 * columns + 1) + column)] = found[n];
  }
  return by_place;
}

TEST(ClothForces, ASeamCarriesTheWholeForceOfBothSides) {
  for (const bool open : {false, true}) {
    const std::vector<Vec3> one = forces_on_sheet(false, false);
    const std::vector<Vec3> two = forces_on_sheet(true, open);
    double largest = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_LT((one[i] - two[i]).norm(), 1e-9) << i;
      largest = std::max(largest, one[i].norm());
    }
    EXPECT_GT(largest, 0.1);
    // The halves balance at the seam. What only one of them pulls does not.
    const std::size_t on_seam = columns + (2 * columns + 1);
    EXPECT_LT(std::abs(two[on_seam].x()), 1e-9);
  }
}

TEST(ClothForces, ALoadIsWhatTheClothPullsWithoutItsWeight) {
  PanelMesh garment;
  test::add_panel(garment, "sheet", test::grid(0.1, 0.15, columns, rows),
                  [](const Vec2& p) { return Vec3(1.02 * p.x(), p.y(), 0); });
  Scene scene;
  scene.body_contact = BodyContactTerm::none;
  scene.self_contact = false;
  scene.gravity = {0, 0, -1000};  // across the sheet
  const GarmentModel model = compile(garment, scene, garment.placed);
  const ForceOptions options;
  ClothForces forces(model, options, {}, model.start, false);
  const std::vector<Vec3> found = forces_of(forces, model.nodes);
  double largest = 0;
  for (std::size_t n = 0; n < found.size(); ++n) {
    EXPECT_NEAR(forces.load(n), found[n].head<2>().norm(), 1e-9) << n;
    largest = std::max(largest, forces.load(n));
  }
  EXPECT_GT(largest, 0.1);
}

/// One side of the seam pulls, the other is slack: the node gets all of it.
TEST(ClothForces, ASeamPassesOnWhatOneSidePulls) {
  const double width = 0.1, height = 0.15;
  const auto pull = [&](bool sewn, bool open) {
    PanelMesh garment;
    test::add_panel(garment, "a", test::grid(width, height, columns, rows),
                    [](const Vec2& p) { return Vec3(1.02 * p.x(), p.y(), 0); });
    if (sewn) {
      test::add_panel(garment, "b", test::grid(width, height, columns, rows),
                      [&](const Vec2& p) { return Vec3(1.02 * width + p.x(), p.y(), 0); });
      garment.seams = {test::seam("ab", test::side(garment.panels[0], columns, rows, true),
                                  test::side(garment.panels[1], columns, rows, false))};
    }
    Scene scene;
    scene.body_contact = BodyContactTerm::none;
    scene.self_contact = false;
    scene.gravity = Vec3::Zero();
    const GarmentModel model = compile(garment, scene, garment.placed);
    const ForceOptions options;
    ClothForces forces(model, options, {}, model.start, open);
    const std::vector<Vec3> found = forces_of(forces, model.nodes);
    double sum = 0;
    for (std::size_t n = 0; n < found.size(); ++n) {
      if (std::abs(model.start[n].x() - 1.02 * width) < 1e-6) sum += found[n].x();
    }
    return sum;
  };
  // 1,000 N/m and 2 % over 15 cm; the narrowing across adds its share.
  EXPECT_NEAR(pull(false, false), -0.02 * 1000 * height, 0.3 * 0.02 * 1000 * height);
  EXPECT_NEAR(pull(true, false), pull(false, false), 1e-3);
  EXPECT_NEAR(pull(true, true), pull(false, false), 1e-3);
}

}  // namespace cloth_forces_test
}  // namespace toile
