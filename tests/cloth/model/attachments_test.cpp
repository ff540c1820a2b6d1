#include "cloth/model/attachments.h"

#include <gtest/gtest.h>

#include <iostream>
#include <numbers>
#include <numeric>
#include <random>

#include "cloth/model/compile.h"
#include "cloth/model/nested_meshes.h"
#include "cloth/relaxation/attachment_forces.h"
#include "cloth/relaxation/relax.h"
#include "cloth/scene/collider.h"
#include "geometry/distance_grid.h"
#include "tests/cloth/figure.h"
#include "tests/pattern/samples.h"
#include "tests/support/shapes.h"
#include "tests/support/slope.h"
#include "tests/support/tubes.h"

namespace toile {
namespace attachments_test {

Attachment to_level(const std::string& landmark, double above = 0) {
  return {AttachedTo::level, landmark, above, Vec3::Zero(), true, 100, 8};
}

Attachment to_point(const Vec3& point) { return {AttachedTo::point, "", 0, point, true, 100, 0.4}; }

/// A sheet of 20 x 10 cm in the plane z = 0.
constexpr int columns = 8, rows = 4;
PanelMesh sheet() { return test::flat_panel(test::grid(0.2, 0.1, columns, rows)); }

std::vector<int> top() {
  std::vector<int> points(columns + 1);
  std::iota(points.begin(), points.end(), rows * (columns + 1));
  return points;
}

TEST(Attachments, PullAsTheGradientOfTheirEnergy) {
  const Skeleton skeleton = test::figure();
  Scene scene;
  scene.skeleton = &skeleton;
  PanelMesh garment = sheet();
  garment.attachments = {{"panel.2", top(), to_level("left_wrist")},
                         {"panel.v0", {0}, to_point({0.001, 0.002, 0})}};
  const GarmentModel model = compile(garment, scene, garment.placed);
  ASSERT_EQ(model.attachments.size(), top().size() + 1);
  const auto energy = [&](const Vec4s& x) {
    double sum = 0;
    for (const AttachedPoint& attached : model.attachments) {
      Vec3 displacement = as_vec3(x[attached.point]) - attached.anchor;
      if (!attached.axis.isZero()) displacement = displacement.dot(attached.axis) * attached.axis;
      const double off = displacement.norm();
      const double elastic = attached.max_pull / attached.stiffness;
      sum += off < elastic ? 0.5 * attached.stiffness * off * off
                           : attached.max_pull * (off - 0.5 * elastic);
    }
    return sum;
  };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  const AttachmentForces forces(model, false);
  int elastic = 0, at_most = 0;
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<Vec3> places = garment.placed;
    // Some within 8 N of the wrist's level, x = 0.7, and 0.4 N of the point, some beyond.
    for (Vec3& p : places) {
      p += Vec3(0.6 + 0.05 * unit(random), 0.01 * unit(random), 0.01 * unit(random));
    }
    places[0] = 0.006 * Vec3(unit(random), unit(random), unit(random));
    const Vec4s x = as_vec4(places);
    for (const AttachedPoint& attached : model.attachments) {
      const double pull = attachment_pull(attached, places[attached.point]).norm();
      EXPECT_LE(pull, attached.max_pull * (1 + 1e-12));
      ++(pull < attached.max_pull * (1 - 1e-9) ? elastic : at_most);
    }
    Vec4s force(x.size(), Vec4{});
    forces.add(0, x.size(), x, force);
    const std::vector<Vec3> slope = test::slope(energy, x, 1e-8);
    for (std::size_t v = 0; v < x.size(); ++v) {
      ASSERT_LT((as_vec3(force[v]) + slope[v]).cwiseAbs().maxCoeff(), 1e-5) << v;
    }
  }
  EXPECT_GT(elastic, 50);
  EXPECT_GT(at_most, 50);
}

TEST(Attachments, SpreadAlongTheirEdgeWhateverItsMesh) {
  std::vector<Remark> remarks;
  Pattern pattern = samples::parse(samples::bag);
  // The curved bottom.
  pattern.panels[0].attachments = {
      {"0", 0, PanelAttachment::Share::whole, {AttachedTo::place, "", 0, {}, false, 900, 12}}};
  PanelMesh garment = mesh_panels(pattern, {0.01, 2}, remarks);
  for (;; garment = coarsen(garment)) {
    const auto attached = attached_points(garment, {}, garment.placed, 0.002);
    const std::vector<int>& points = garment.attachments[0].points;
    ASSERT_EQ(attached.size(), points.size());
    double stiffness = 0, max_pull = 0;
    for (const AttachedPoint& each : attached) {
      EXPECT_EQ(each.anchor, garment.placed[each.point]);
      stiffness += each.stiffness;
      max_pull += each.max_pull;
    }
    EXPECT_NEAR(stiffness, 900, 1e-9);
    EXPECT_NEAR(max_pull, 12, 1e-9);
    // An end stands for half as much of the edge as those within.
    EXPECT_NEAR(attached.front().stiffness / attached[1].stiffness, 0.5, 0.02);
    if (garment.subdivisions == 0) break;
  }
}

TEST(Attachments, LevelsAreThoseOfTheBody) {
  const Skeleton skeleton = test::figure();
  Scene scene;
  scene.skeleton = &skeleton;
  PanelMesh garment = sheet();
  const auto held_at = [&](const Attachment& how) {
    garment.attachments = {{"panel.v3", {3}, how}};
    return attached_points(garment, scene, garment.placed, 0.002).at(0);
  };
  // A place is off a level by this much along its axis.
  const auto off = [](const AttachedPoint& attached, const Vec3& p) {
    return attached.axis.dot(p - attached.anchor);
  };
  const AttachedPoint waist = held_at(to_level("waist", 0.03));
  EXPECT_EQ(waist.axis, Vec3(Vec3::UnitY()));
  EXPECT_NEAR(off(waist, {0.3, 1.03, -0.2}), 0, 1e-15);
  // Arms are held out level, so nearer to the body is "above".
  const AttachedPoint wrist = held_at(to_level("left_wrist", 0.05));
  EXPECT_NEAR(std::abs(wrist.axis.x()), 1, 1e-12);
  EXPECT_NEAR(off(wrist, {0.65, 1.2, 0.1}), 0, 1e-12);
  const AttachedPoint other = held_at(to_level("right_wrist", 0.05));
  EXPECT_NEAR(off(other, {-0.65, 1.2, 0.1}), 0, 1e-12);
  const AttachedPoint knee = held_at(to_level("right_knee", -0.1));
  EXPECT_NEAR(off(knee, {-0.1, 0.35, 0.2}), 0, 1e-12);
  // It pulls toward its level, and in no other way.
  const Vec3 pull = attachment_pull(waist, {0.3, 1.02, -0.2});
  EXPECT_LT((pull - Vec3(0, 100 * 0.01, 0)).norm(), 1e-12);
}

TEST(Attachments, PlacesAreWhereTheClothMayBe) {
  const double radius = 0.1, offset = 0.002;
  const Collider body(test::closed_tube(radius, radius, 0.5, 400));
  Scene scene;
  scene.collider = &body;
  PanelMesh garment = sheet();
  const auto anchor_of = [&](const Attachment& how, const Vec3& placed) {
    garment.attachments = {{"panel.v0", {0}, how}};
    garment.placed[0] = placed;
    return attached_points(garment, scene, garment.placed, 0.002).at(0).anchor;
  };
  Attachment how = to_point({0, 0.2, 0.08});
  EXPECT_LT((anchor_of(how, {9, 9, 9}) - Vec3(0, 0.2, radius + offset)).norm(), 2e-4);
  how.point = {0, 0.2, 0.3};
  EXPECT_EQ(anchor_of(how, {9, 9, 9}), how.point);
  how.to = AttachedTo::place;
  EXPECT_EQ(anchor_of(how, {0.01, 0.2, 0.5}), Vec3(0.01, 0.2, 0.5));
  how.to = AttachedTo::skin;
  EXPECT_LT((anchor_of(how, {0.5, 0.2, 0}) - Vec3(radius + offset, 0.2, 0)).norm(), 2e-4);
  // From inside, the middles of the tube's sides are nearer than its corners.
  const Vec3 from_inside = anchor_of(how, {0.05, 0.2, 0});
  EXPECT_NEAR(std::hypot(from_inside.x(), from_inside.z()), radius + offset, 2e-4);
}

TEST(Attachments, SayWhatTheSceneLacks) {
  PanelMesh garment = sheet();
  Scene scene;
  const auto error = [&](const Attachment& how) {
    garment.attachments = {{"panel.v3", {3}, how}};
    return samples::error_of([&] { compile(garment, scene, garment.placed); });
  };
  EXPECT_HOLDS(error(to_level("waist")),
               "attachment 'panel.v3': is held at 'waist', but there is no skeleton");
  Skeleton skeleton = test::figure();
  scene.skeleton = &skeleton;
  EXPECT_HOLDS(error(to_level("bust")), "'bust', but there is no body");
  const Collider ball(test::sphere(0.1, 2));
  scene.collider = &ball;
  scene.body_contact = BodyContactTerm::none;
  EXPECT_HOLDS(error(to_level("bust")), "'bust', but the body shows none");
  std::erase_if(skeleton.segments, [](const Segment& s) { return s.part == "left_arm"; });
  EXPECT_HOLDS(error(to_level("left_elbow")), "lacks that limb");
  skeleton.joints.erase("waist");
  EXPECT_HOLDS(error(to_level("waist")), "no joint 'waist'");
}

/// A sheet that hangs from springs at two corners: what they pull with is its weight.
TEST(Attachments, CarryTheWeightOfASheetThatHangsFromThem) {
  constexpr double width = 0.2, height = 0.1;
  PanelMesh garment = sheet();
  const Vec3 left(0, height, 0), right(width, height, 0);
  Attachment how = to_point(left);
  how.max_pull = 5;
  how.stiffness = 300;
  const int first = rows * (columns + 1);
  garment.attachments = {{"left", {first}, how}, {"right", {first + columns}, how}};
  garment.attachments[1].how.point = right;
  Scene scene;
  scene.self_contact = false;
  const GarmentModel model = compile(garment, scene, garment.placed);
  RelaxOptions options;
  options.max_iterations = 20000;
  options.stop_median = options.stop_rms = 0.001;
  std::vector<Vec3> x = model.start;
  EXPECT_TRUE(relax(model, options, x).converged);
  const auto measured = measure_attachments(garment, model.attachments, point_positions(model, x));
  const double weight = width * height * scene.fabric.areal_density * 9.81;
  const Vec3 sum = measured[0].pull + measured[1].pull;
  std::cout << "pulls " << measured[0].pull.transpose() << " and " << measured[1].pull.transpose()
            << " N, weight " << weight << " N\n";
  EXPECT_NEAR(sum.y() / weight, 1, 0.01);
  EXPECT_NEAR(sum.x() / weight, 0, 0.01);
  EXPECT_NEAR(sum.z() / weight, 0, 0.01);
  // Its weight draws its corners together, so each pulls outward.
  EXPECT_LT(measured[0].pull.x(), -0.1 * weight);
  EXPECT_GT(measured[1].pull.x(), 0.1 * weight);
  for (const AttachmentMeasurement& each : measured) {
    EXPECT_NEAR(each.off_mean, each.pull.norm() / how.stiffness, 1e-12);
  }
}

TEST(Attachments, GiveWayToMoreThanTheyHold) {
  PanelMesh garment = sheet();
  const double weight = 0.2 * 0.1 * Fabric().areal_density * 9.81;
  for (const double share : {0.8, 1.2}) {
    Attachment how{AttachedTo::place, "", 0, Vec3::Zero(), true, 1000, share * weight};
    garment.attachments = {{"panel.2", top(), how}};
    Scene scene;
    scene.self_contact = false;
    const GarmentModel model = compile(garment, scene, garment.placed);
    RelaxOptions options;
    options.max_iterations = 2000;
    std::vector<Vec3> x = model.start;
    relax(model, options, x);
    const auto measured = measure_attachments(garment, model.attachments, x);
    if (share < 1) {
      EXPECT_GT(measured[0].off_mean, 0.01);
      EXPECT_NEAR(measured[0].pull.y() / weight, share, 1e-6);
    } else {
      EXPECT_LT(measured[0].off_mean, 0.001);
      EXPECT_NEAR(measured[0].pull.y() / weight, 1, 0.01);
    }
  }
}

TEST(Attachments, ThoseThatLastAreToldFromTheOthers) {
  PanelMesh garment = sheet();
  garment.attachments = {{"a", {0}, to_point({0, 0, 1})}, {"b", {1}, to_point({0, 0, 2})}};
  garment.attachments[0].how.always = false;
  const auto all = attached_points(garment, {}, garment.placed, 0.002);
  const auto left = lasting(all);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].attachment, 1);
  auto measured = measure_attachments(garment, all, garment.placed);
  std::vector<Vec3> moved = garment.placed;
  for (Vec3& p : moved) p.z() += 0.5;
  measure_lasting(garment, left, moved, measured);
  EXPECT_NEAR(measured[0].off_mean, 1, 1e-3);
  EXPECT_NEAR(measured[1].off_mean, 1.5, 1e-3);
}

TEST(Attachments, ThoseOfWhatSlipsHoldOnlyThen) {
  PanelMesh garment = sheet();
  garment.attachments = {{"a", {0}, to_point({0, 0, 1})}, {"b", {1}, to_point({0, 0, 2})}};
  EXPECT_FALSE(hold_what_slips(garment));
  garment.attachments[0].how.only_if_it_slips = true;
  const auto loose = attached_points(garment, {}, garment.placed, 0.002);
  ASSERT_EQ(loose.size(), 1u);
  EXPECT_EQ(loose[0].attachment, 1);
  const auto measured = measure_attachments(garment, loose, garment.placed);
  EXPECT_FALSE(measured[0].used);
  EXPECT_TRUE(measured[1].used);
  const auto held = hold_what_slips(garment);
  ASSERT_TRUE(held);
  EXPECT_EQ(attached_points(*held, {}, garment.placed, 0.002).size(), 2u);
  EXPECT_TRUE(measure_attachments(*held, {}, garment.placed)[0].used);
}

TEST(Attachments, WithoutThemThereIsNoTerm) {
  const PanelMesh garment = sheet();
  const GarmentModel model = compile(garment, {}, garment.placed);
  EXPECT_TRUE(model.attachments.empty());
  EXPECT_TRUE(AttachmentForces(model, true).empty());
}

}  // namespace attachments_test
}  // namespace toile
