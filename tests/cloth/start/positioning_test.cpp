#include "cloth/start/positioning.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <iostream>

#include "cloth/start/constants.h"
#include "cloth/start/turn_and_lift.h"
#include "geometry/body/bones.h"
#include "tests/cloth/figure.h"
#include "tests/support/shapes.h"
#include "tests/support/tubes.h"

namespace toile {
namespace positioning_test {

using test::figure;

/// A rectangle that the skeleton is to position.
PanelMesh panel(BodyPart part, const PanelPlacement& placement, double width = 0.3,
                double height = 0.4, int columns = 6, int rows = 8) {
  PanelMesh garment;
  MeshedPanel& added = test::add_panel(garment, "panel", test::grid(width, height, columns, rows),
                                       [](const Vec2& p) { return Vec3(p.x(), p.y(), 7); });
  added.is = classify({"", part});
  added.placement = placement;
  return garment;
}

/// A small body far below everything: nothing is in the way.
const DistanceGrid& far_body() {
  static const DistanceGrid body{
      SurfaceDistance(test::box({-0.02, -9, -0.02}, {0.02, -8.9, 0.02}))};
  return body;
}

struct Axes {
  Vec3 right, up, out;
};

/// Of a panel() that stands flat.
Axes axes_of(const std::vector<Vec3>& placed, int columns = 6) {
  const Vec3 right = (placed[1] - placed[0]).normalized();
  const Vec3 up = (placed[columns + 1] - placed[0]).normalized();
  return {right, up, right.cross(up)};
}

PanelPlacement at_side(PlacementSide side) {
  PanelPlacement placement;
  placement.side = side;
  return placement;
}

PanelPlacement rolled_around(double around = 1) {
  PanelPlacement placement;
  placement.around = around;
  return placement;
}

TEST(Positioning, PartFramesAreTheShortestTurnFromUpright) {
  double worst = 0;
  for (const Vec3& up : {Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, -1),
                         Vec3(-0.7, 0.7, 0.1).normalized(), Vec3(0, -1, 0)}) {
    const Eigen::Matrix3d frame = part_frame(up);
    worst = std::max(worst, (frame.col(1) - up).norm());
    worst = std::max(worst, (frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm());
    worst = std::max(worst, (frame.col(0).cross(frame.col(1)) - frame.col(2)).norm());
  }
  EXPECT_LT(worst, 1e-15);
  // The front of an arm held out level stays in front, its outer side comes to be above.
  EXPECT_LT((part_frame({-1, 0, 0}).col(2) - Vec3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((part_frame({-1, 0, 0}).col(0) - Vec3::UnitY()).norm(), 1e-15);
}

TEST(Positioning, APanelsAxisIsLaidAlongItsBone) {
  Skeleton skeleton = figure();
  const Vec3 slope = Vec3(0.5, -0.8, 0.2).normalized();
  skeleton.joints["left_elbow"] = skeleton.joint("left_shoulder") + 0.5 * slope;
  skeleton.joints["left_wrist"] = skeleton.joint("left_shoulder") + 0.8 * slope;
  double worst = 0;
  for (const PlacementSide side :
       {PlacementSide::front, PlacementSide::back, PlacementSide::left, PlacementSide::right}) {
    PanelPlacement placement = at_side(side);
    placement.at = "left_elbow";
    placement.level = 0.25;
    placement.shift = 0.03;
    const Positioning done =
        position_panels(panel(BodyPart::left_arm, placement), far_body(), &skeleton);
    const Axes axes = axes_of(done.placed);
    worst = std::max(worst, (axes.up + slope).norm());
    // The point of the middle line at y = 0.25 stands off the elbow, straight out and shifted.
    const Vec3 there = 0.5 * (done.placed[5 * 7] + done.placed[5 * 7 + 6]);
    const Vec3 expected = skeleton.joint("left_elbow") + flat_offset * axes.out + 0.03 * axes.right;
    worst = std::max(worst, (there - expected).norm());
    EXPECT_EQ(done.panels.at(0).distance, flat_offset);
  }
  std::cout << "axis along the bone: off by " << worst << " at most\n";
  EXPECT_LT(worst, 1e-12);
}

TEST(Positioning, SidesAreTheWearersAndTheRightSideIsOut) {
  const Skeleton skeleton = figure();
  struct Case {
    PlacementSide side;
    double turn;
    Vec3 out;
  };
  const double half = std::sqrt(0.5);
  for (const Case& c :
       {Case{PlacementSide::front, 0, {0, 0, 1}}, Case{PlacementSide::back, 0, {0, 0, -1}},
        Case{PlacementSide::left, 0, {1, 0, 0}}, Case{PlacementSide::right, 0, {-1, 0, 0}},
        Case{PlacementSide::front, 45, {half, 0, half}},
        Case{PlacementSide::back, -45, {half, 0, -half}}}) {
    PanelPlacement placement = at_side(c.side);
    placement.turn_degrees = c.turn;
    const Positioning done =
        position_panels(panel(BodyPart::torso, placement), far_body(), &skeleton);
    const Axes axes = axes_of(done.placed);
    EXPECT_LT((axes.out - c.out).norm(), 1e-12);
    EXPECT_LT((axes.up - Vec3::UnitY()).norm(), 1e-12);
    // Its upper end at the neck, its middle before the bones.
    EXPECT_NEAR(done.placed.back().y(), 1.4, 1e-12);
    const Vec3 middle = 0.5 * (done.placed.front() + done.placed.back());
    EXPECT_LT((middle - Vec3(0, 1.2, 0) - flat_offset * c.out).norm(), 1e-12);
  }
}

TEST(Positioning, PanelsDrawnAcrossAreTurned) {
  const Skeleton skeleton = figure();
  struct Case {
    PlacementAxis axis;
    Vec2 up;
  };
  for (const Case& c :
       {Case{PlacementAxis::plus_y, {0, 1}}, Case{PlacementAxis::minus_y, {0, -1}},
        Case{PlacementAxis::plus_x, {1, 0}}, Case{PlacementAxis::minus_x, {-1, 0}}}) {
    PanelPlacement placement = at_side(PlacementSide::back);
    placement.axis = c.axis;
    const Positioning done =
        position_panels(panel(BodyPart::torso, placement), far_body(), &skeleton);
    const Axes axes = axes_of(done.placed);
    EXPECT_LT((c.up.x() * axes.right + c.up.y() * axes.up - Vec3::UnitY()).norm(), 1e-12);
    EXPECT_LT((axes.out + Vec3::UnitZ()).norm(), 1e-12);
  }
}

TEST(Positioning, SeveralBonesGiveTheirMeanOrientation) {
  Skeleton skeleton = figure();
  skeleton.joints["waist"] = {0, 1.0, 0.1};
  skeleton.joints["chest"] = {0.02, 1.2, 0.05};
  const Bones bones(skeleton, BodyPart::torso);
  PanelPlacement placement = at_side(PlacementSide::front);
  placement.at = "neck";
  placement.level = 0.45;
  const PanelMesh garment = panel(BodyPart::torso, placement, 0.3, 0.5, 6, 10);
  const Positioning done = position_panels(garment, far_body(), &skeleton);
  // 5 cm stand above the neck and 45 lie along the bones below it: by hand, each bone's direction
  // times its length before the panel.
  const Vec3 neck = skeleton.joint("neck"), chest = skeleton.joint("chest");
  const Vec3 waist = skeleton.joint("waist"), pelvis = skeleton.joint("pelvis");
  const double upper = (neck - chest).norm(), middle = (chest - waist).norm();
  const double rest = 0.45 - upper - middle;
  ASSERT_GT(rest, 0.01);
  const Vec3 sum = (upper + 0.05) * (neck - chest) / upper + (chest - waist) +
                   rest * (waist - pelvis).normalized();
  const double error = (axes_of(done.placed).up - sum.normalized()).norm();
  std::cout << "mean orientation of three bones: off by " << error << "\n";
  EXPECT_LT(error, 1e-12);
  EXPECT_GT((sum.normalized() - (neck - chest) / upper).norm(), 0.05);
  // Which is the chord of the bones; and the middle is the centroid of the stretch.
  const double end = bones.along.back();
  const auto [centre, direction] = bones.average(end - 0.45, end + 0.05);
  const Vec3 chord = bones.at(end + 0.05).first - bones.at(end - 0.45).first;
  EXPECT_LT((chord.normalized() - direction).norm(), 1e-12);
  Vec3 mean = Vec3::Zero();
  constexpr int samples = 2000;
  for (int i = 0; i < samples; ++i) {
    mean += bones.at(end - 0.45 + 0.5 * (i + 0.5) / samples).first / samples;
  }
  EXPECT_LT((mean - centre).norm(), 1e-6);
}

TEST(Positioning, FlatPanelsClearTheBodyByTheOffset) {
  const Skeleton skeleton = figure();
  const SurfaceDistance exact(test::box({-0.15, 0.7, -0.1}, {0.15, 1.5, 0.12}));
  const DistanceGrid body{exact};
  for (const double offset : {0.005, 0.04}) {
    for (const auto& [side, skin] :
         {std::pair(PlacementSide::front, 0.12), std::pair(PlacementSide::back, 0.1),
          std::pair(PlacementSide::left, 0.15)}) {
      PanelPlacement placement = at_side(side);
      placement.offset = offset;
      const Positioning done = position_panels(panel(BodyPart::torso, placement), body, &skeleton);
      double nearest = 1;
      for (const Vec3& p : done.placed)
        nearest = std::min(nearest, exact.closest_point(p).distance);
      std::cout << "asked " << 1000 * offset << " mm, stands " << 1000 * nearest << " mm off\n";
      EXPECT_GT(nearest, offset - 1e-6);
      // Beyond its band the grid interpolates.
      EXPECT_LT(nearest, offset + (offset < 0.01 ? 0.0005 : 0.015));
      EXPECT_GT(done.panels[0].distance, skin + offset - 1e-6);
    }
  }
}

TEST(Positioning, RolledPanelsStandAroundTheirBones) {
  const Skeleton skeleton = figure();
  const PanelMesh sleeve = panel(BodyPart::left_arm, rolled_around(), 0.4, 0.3, 40, 6);
  // An arm of 4 cm radius along x, before a torso.
  TriangleMesh arm = test::closed_tube(0.04, 0.04, 0.7, 48);
  for (Vec3& p : arm.points) p = Vec3(p.y(), 1.3 + p.x(), p.z());
  for (Triangle& t : arm.triangles) std::swap(t[1], t[2]);
  const DistanceGrid body{SurfaceDistance(arm)};
  const Positioning done = position_panels(sleeve, body, &skeleton);
  const PositionedPanel& how = done.panels.at(0);
  EXPECT_TRUE(how.rolled);
  EXPECT_FALSE(how.bent);
  EXPECT_EQ(how.points_too_near, 0);
  EXPECT_NEAR(how.distance, 0.4 / (2 * test::pi), 1e-15);
  EXPECT_NEAR(how.gap, 0, 1e-15);
  double worst = 0;
  for (std::size_t p = 0; p < done.placed.size(); ++p) {
    const double angle = (sleeve.flat[p].x() - 0.2) / how.distance;
    // The middle on top of the arm, +x of the sleeve toward the back; its upper end at the
    // shoulder.
    const Vec3 expected(0.15 + how.drawn_out + 0.3 - sleeve.flat[p].y(),
                        1.3 + how.distance * std::cos(angle), -how.distance * std::sin(angle));
    worst = std::max(worst, (done.placed[p] - expected).norm());
  }
  std::cout << "rolled around the arm: off by " << worst << " m at most\n";
  EXPECT_LT(worst, 1e-12);
  // The seam's sides meet at the underarm.
  EXPECT_LT((done.placed[0] - done.placed[40]).norm(), 1e-12);
  EXPECT_NEAR(done.placed[0].y(), 1.3 - how.distance, 1e-12);
}

TEST(Positioning, ASleeveThatReachesTheHandGoesAllAroundIt) {
  const Skeleton skeleton = figure();
  // Half as wide at its hem as at its top. The seam of a short one stands open at the hem.
  for (const double length : {0.2, 0.7}) {
    PanelMesh sleeve = panel(BodyPart::left_arm, rolled_around(), 0.4, length, 40, 28);
    for (Vec2& point : sleeve.flat) {
      point.x() = 0.2 + (point.x() - 0.2) * (0.5 + 0.5 * point.y() / length);
    }
    const Positioning done = position_panels(sleeve, far_body(), &skeleton);
    const double open = (done.placed[0] - done.placed[40]).norm();
    const double across = 2 * done.panels.at(0).distance;
    if (length < 0.5) {
      EXPECT_NEAR(open, across, 0.02 * across) << "half of the circle is open";
    } else {
      EXPECT_LT(open, 0.15 * across);
    }
    const std::size_t top = 28 * 41;
    EXPECT_LT((done.placed[top] - done.placed[top + 40]).norm(), 0.02) << length;
  }
}

/// The width of a sleeve is that of its outline, where a level of it has no point of the border.
TEST(Positioning, ACoarseSleeveGoesAsFarAroundTheHandAsAFineOne) {
  const Skeleton skeleton = figure();
  const auto rolled = [&](int columns, int rows) {
    PanelMesh sleeve = panel(BodyPart::left_arm, rolled_around(), 0.4, 0.7, columns, rows);
    for (Vec2& point : sleeve.flat) {
      point.x() = 0.2 + (point.x() - 0.2) * (0.5 + 0.5 * point.y() / 0.7);
      // The inner points lie between those of the border.
      const bool is_border = std::abs(point.x() - 0.2) > 0.199 * (0.5 + 0.5 * point.y() / 0.7);
      if (!is_border && point.y() > 0.01 && point.y() < 0.65) point.y() += 0.35 / rows;
    }
    return position_panels(sleeve, far_body(), &skeleton).placed;
  };
  const std::vector<Vec3> coarse = rolled(8, 10);
  const std::vector<Vec3> fine = rolled(8, 40);
  double worst = 0;
  for (int row = 0; row <= 10; ++row) {
    for (const int column : {0, 8}) {
      worst = std::max(worst, (coarse[row * 9 + column] - fine[4 * row * 9 + column]).norm());
    }
  }
  std::cout << "borders of a coarse and of a fine sleeve: " << 1000 * worst << " mm apart\n";
  EXPECT_LT(worst, 0.01);
}

TEST(Positioning, RolledPanelsAreWidenedUntilTheLimbFits) {
  const Skeleton skeleton = figure();
  const SurfaceDistance exact(test::closed_tube(0.16, 0.12, 1.5, 96));
  const DistanceGrid body{exact};
  // 90 cm around: 14.3 cm radius, less than the half axis of 16 cm.
  PanelPlacement placement = rolled_around();
  placement.offset = 0.004;
  const PanelMesh skirt = panel(BodyPart::torso, placement, 0.9, 0.3, 60, 6);
  const Positioning done = position_panels(skirt, body, &skeleton);
  const PositionedPanel& how = done.panels.at(0);
  EXPECT_EQ(how.points_too_near, 0);
  EXPECT_NEAR(how.gap, 2 * test::pi * how.distance - 0.9, 1e-12);
  EXPECT_NEAR(how.distance, 0.164, 0.001);
  double nearest = 1;
  for (const Vec3& p : done.placed) nearest = std::min(nearest, exact.closest_point(p).distance);
  std::cout << "radius " << how.distance << " m, gap " << how.gap << " m, " << 1000 * nearest
            << " mm off the skin\n";
  EXPECT_GT(nearest, 0.004 - 1e-4);
  // Open in the middle of the back.
  EXPECT_LT(0.5 * (done.placed[0].z() + done.placed[60].z()), -0.1);
  EXPECT_NEAR(done.placed[0].x(), -done.placed[60].x(), 1e-12);
}

/// Straight, a long sleeve fits on the forearm alone, and would have to come past the elbow.
TEST(Positioning, ASleeveFollowsABentArm) {
  Skeleton skeleton = figure();
  const Vec3 shoulder = skeleton.joint("left_shoulder");
  const Vec3 elbow = skeleton.joint("left_elbow");
  const Vec3 wrist = elbow + 0.3 * Vec3(0.5, 0, std::sqrt(0.75));
  skeleton.joints["left_wrist"] = wrist;
  const auto bone = [](const Vec3& from, const Vec3& to) {
    constexpr double radius = 0.04;
    TriangleMesh tube = test::closed_tube(radius, radius, (to - from).norm() + 2 * radius, 48);
    const Vec3 along = (to - from).normalized();
    for (Vec3& p : tube.points) {
      p = from + (p.y() - radius) * along + p.x() * Vec3::UnitY().cross(along) -
          p.z() * Vec3::UnitY();
    }
    return SurfaceDistance(tube);
  };
  const DistanceGrid body({bone(shoulder, elbow), bone(elbow, wrist)});
  const PanelMesh sleeve = panel(BodyPart::left_arm, rolled_around(), 0.4, 0.5, 40, 20);
  const Positioning done = position_panels(sleeve, body, &skeleton);
  const PositionedPanel& how = done.panels.at(0);
  EXPECT_TRUE(how.bent);
  EXPECT_EQ(how.points_too_near, 0);
  EXPECT_EQ(how.drawn_out, 0);
  EXPECT_NEAR(how.distance, 0.4 / (2 * test::pi), 0.01);  // wider for the sharp elbow
  const Bones bones(skeleton, BodyPart::left_arm);
  for (int row = 0; row <= 20; ++row) {
    Vec3 middle = Vec3::Zero();
    for (int i = 0; i < 40; ++i) {
      const Vec3& p = done.placed[row * 41 + i];
      EXPECT_GT(body.at(p).distance, rolled_offset - 1e-3);
      middle += p / 40;
    }
    EXPECT_LT(bones.distance(middle), 0.03) << "row " << row;
  }
}

TEST(Positioning, PanelsOfALegStayOnItsSide) {
  const Skeleton skeleton = figure();
  // 12 cm of radius where the plane between the legs is 10 cm off.
  const PanelMesh leg =
      panel(BodyPart::right_leg, rolled_around(), 2 * test::pi * 0.12, 0.5, 40, 6);
  const Positioning rolled = position_panels(leg, far_body(), &skeleton);
  PanelPlacement placement = at_side(PlacementSide::front);
  placement.at = "right_hip";
  const Positioning flat =
      position_panels(panel(BodyPart::right_leg, placement, 0.3, 0.4), far_body(), &skeleton);
  for (const Positioning* done : {&rolled, &flat}) {
    double most = -1;
    for (const Vec3& p : done->placed) most = std::max(most, p.x());
    std::cout << "nearest to the plane between the legs: " << -1000 * most << " mm\n";
    EXPECT_LT(most, -0.005 + 1e-9);
    EXPECT_GT(most, -0.006);
  }
  EXPECT_GT(rolled.panels[0].gap, 0.01);
  EXPECT_NEAR(flat.placed[0].x(), -0.305, 1e-12);
}

TEST(Positioning, TwoHalvesMakeOneTube) {
  const Skeleton skeleton = figure();
  PanelMesh garment = panel(BodyPart::torso, rolled_around(0.5), 0.5, 0.3, 30, 6);
  test::add_panel(garment, "back", test::grid(0.5, 0.3, 30, 6),
                  [](const Vec2&) { return Vec3::Zero().eval(); });
  garment.panels[1].is = classify({"", BodyPart::torso});
  garment.panels[1].placement = rolled_around(0.5);
  garment.panels[1].placement.side = PlacementSide::back;
  const Positioning done = position_panels(garment, far_body(), &skeleton);
  EXPECT_NEAR(done.panels[0].distance, 1.0 / (2 * test::pi), 1e-15);
  for (int row = 0; row <= 6; ++row) {
    const int front = row * 31, rear = 7 * 31 + row * 31;
    EXPECT_LT((done.placed[front] - done.placed[rear + 30]).norm(), 1e-12);
    EXPECT_LT((done.placed[front + 30] - done.placed[rear]).norm(), 1e-12);
    EXPECT_GT(done.placed[front + 15].z(), 0.1);
    EXPECT_LT(done.placed[rear + 15].z(), -0.1);
  }
}

TEST(Positioning, PanelsStandLevelWithWhatTheyAreSewnTo) {
  const Skeleton skeleton = figure();
  PanelPlacement front = at_side(PlacementSide::front);
  front.at = "waist";
  front.level = 0.1;
  PanelMesh garment = panel(BodyPart::torso, front);
  PanelPlacement back = at_side(PlacementSide::back);
  test::add_panel(garment, "back", test::grid(0.3, 0.4, 6, 8),
                  [](const Vec2&) { return Vec3::Zero().eval(); });
  garment.panels[1].is = classify({"", BodyPart::torso});
  garment.panels[1].placement = back;
  // The back's side from its second row on is sewn to the front's from its first row on.
  const std::vector<int> left = test::side(garment.panels[0], 6, 8, true);
  const std::vector<int> right = test::side(garment.panels[1], 6, 8, false);
  garment.seams = {
      test::seam("side", {left.begin(), left.end() - 1}, {right.begin() + 1, right.end()})};
  const Positioning done = position_panels(garment, far_body(), &skeleton);
  EXPECT_NEAR(done.placed[left[2]].y(), 1.0, 1e-12);
  for (std::size_t i = 0; i < garment.seams[0].a.size(); ++i) {
    EXPECT_NEAR(done.placed[garment.seams[0].a[i]].y(), done.placed[garment.seams[0].b[i]].y(),
                1e-12);
  }
}

TEST(Positioning, LeavesExplicitPanelsAlone) {
  const Skeleton skeleton = figure();
  PanelMesh garment = panel(BodyPart::torso, {});
  EXPECT_FALSE(asks_for_skeleton(garment));
  EXPECT_EQ(position_panels(garment, far_body(), nullptr).placed, garment.placed);
  EXPECT_TRUE(position_panels(garment, far_body(), nullptr).panels.empty());
  test::add_panel(garment, "sleeve", test::grid(0.4, 0.3, 4, 4),
                  [](const Vec2&) { return Vec3::Zero().eval(); });
  garment.panels[1].is = classify({"", BodyPart::right_arm});
  garment.panels[1].placement = rolled_around();
  const Positioning done = position_panels(garment, far_body(), &skeleton);
  ASSERT_EQ(done.panels.size(), 1U);
  EXPECT_EQ(done.panels[0].panel, "sleeve");
  EXPECT_TRUE(std::equal(garment.placed.begin(), garment.placed.begin() + garment.panels[0].points,
                         done.placed.begin()));
  // Positioning twice is positioning once, and the dressing starts from there.
  garment.placed = done.placed;
  EXPECT_EQ(position_panels(garment, far_body(), &skeleton).placed, done.placed);
  EXPECT_EQ(turn_and_lift(garment, far_body(), &skeleton).placed, done.placed);
}

std::string refusal(const PanelMesh& garment, const Skeleton* skeleton) {
  try {
    position_panels(garment, far_body(), skeleton);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Positioning, SaysWhatTheSkeletonLacks) {
  const PanelMesh garment = panel(BodyPart::left_arm, rolled_around());
  EXPECT_NE(refusal(garment, nullptr).find("panel 'panel'"), std::string::npos);
  EXPECT_NE(refusal(garment, nullptr).find("--skeleton"), std::string::npos);
  Skeleton none = figure();
  none.segments.clear();
  EXPECT_NE(refusal(garment, &none).find("'left_arm'"), std::string::npos);
  Skeleton jointless = figure();
  jointless.joints.erase("waist");
  jointless.segments = {{"left_leg", "left_hip", "left_knee"}};
  EXPECT_NE(refusal(panel(BodyPart::left_leg, rolled_around()), &jointless).find("'waist'"),
            std::string::npos);
}

}  // namespace positioning_test
}  // namespace toile
