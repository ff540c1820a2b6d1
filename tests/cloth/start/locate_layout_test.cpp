#include "cloth/start/locate_layout.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>

#include "tests/cloth/figure.h"

namespace toile {
namespace locate_layout_test {

using test::figure;

/// A strapless top: a tube around the trunk, from the waist to the armpits of figure().
PanelMesh top() {
  PanelMesh garment = test::tube();
  test::name_panel(garment.panels[0], "front_bodice");
  test::name_panel(garment.panels[1], "back_bodice");
  for (Vec3& p : garment.placed) p.y() -= 0.2;
  return garment;
}

LayoutMove turn(double degrees) {
  LayoutMove move;
  move.rotation = Eigen::AngleAxisd(degrees * test::pi / 180, Vec3::UnitY()).toRotationMatrix();
  return move;
}

double largest_difference(const PanelMesh& a, const PanelMesh& b) {
  double largest = 0;
  for (std::size_t p = 0; p < a.placed.size(); ++p) {
    largest = std::max(largest, (a.placed[p] - b.placed[p]).norm());
  }
  return largest;
}

/// How far from top() the garment is once it is moved to the body.
double off_when_moved(PanelMesh garment) {
  const auto move = locate_layout(garment, figure());
  if (!move) return 1e9;
  move_layout(*move, garment);
  EXPECT_FALSE(locate_layout(garment, figure()));
  return largest_difference(garment, top());
}

TEST(LocateLayout, WhatStandsAroundTheBodyStays) {
  EXPECT_FALSE(locate_layout(top(), figure()));
  PanelMesh raised = top();
  move_layout({turn(0).rotation, Vec3(0.1, 0.2, 0)}, raised);
  EXPECT_FALSE(locate_layout(raised, figure()));
}

TEST(LocateLayout, WhatStandsLowerOrAsideIsBroughtBack) {
  for (const Vec3& by : {Vec3(0, -0.3, 0), Vec3(0, -1.1, 0), Vec3(0, 0.9, 0), Vec3(0.8, 0, 0),
                         Vec3(-0.5, -0.85, 2)}) {
    PanelMesh garment = top();
    move_layout({Eigen::Matrix3d::Identity(), by}, garment);
    EXPECT_LT(off_when_moved(garment), 1e-9) << by.transpose();
  }
}

TEST(LocateLayout, NamesTellHowItIsTurned) {
  for (const double degrees : {90.0, 180.0, -90.0, 80.0}) {
    PanelMesh garment = top();
    move_layout(turn(degrees), garment);
    const double left = std::abs(std::remainder(degrees, 90)) * test::pi / 180;
    EXPECT_LT(off_when_moved(garment), test::tube_radius * left + 1e-9) << degrees;
  }
  PanelMesh nameless = top();
  for (MeshedPanel& panel : nameless.panels) test::name_panel(panel, "bodice");
  move_layout(turn(90), nameless);
  EXPECT_FALSE(locate_layout(nameless, figure()));
}

TEST(LocateLayout, APanelOnTheWrongSideTurnsNothing) {
  PanelMesh garment = top();
  test::name_panel(garment.panels[0], "left_bodice");
  test::name_panel(garment.panels[1], "right_bodice");
  EXPECT_TRUE(locate_layout(garment, figure()));
  // By its sides it is turned by a quarter, by its front and back it is not.
  test::add_half(garment, "front_bodice", -test::pi / 2);
  test::add_half(garment, "back_bodice", test::pi / 2);
  EXPECT_FALSE(locate_layout(garment, figure()));
}

TEST(LocateLayout, ThePanelsFollowTheBodysOwnMove) {
  // The scan lay on its back about its own middle, and so does the pattern.
  BodyMove cleaned;
  cleaned.rotation = Eigen::AngleAxisd(-test::pi / 2, Vec3::UnitX()).toRotationMatrix();
  cleaned.translation = Vec3(0, 0.85, 0.05);
  PanelMesh garment = top();
  for (Vec3& p : garment.placed) {
    p = cleaned.rotation.transpose() * (p - cleaned.translation);
  }
  Skeleton skeleton = figure();
  skeleton.cleaned = cleaned;
  const auto move = locate_layout(garment, skeleton);
  ASSERT_TRUE(move);
  EXPECT_TRUE(move->as_body);
  move_layout(*move, garment);
  EXPECT_LT(largest_difference(garment, top()), 1e-9);
  EXPECT_FALSE(locate_layout(garment, skeleton));
}

TEST(LocateLayout, SaysWhatItDid) {
  LayoutMove move = turn(90);
  move.translation = Vec3(0.3, 0.6, 0.4);
  PanelMesh at_origin;
  at_origin.placed = {Vec3(0.1, 0, 0), Vec3(-0.1, 0, 0)};
  EXPECT_EQ(text_of(move, at_origin),
            "turned by 90 degrees, raised by 60 cm, moved level by 50 cm");
}

TEST(LacksPlaces, PanelsInOneUprightPlaneDo) {
  PanelMesh garment = top();
  EXPECT_FALSE(lacks_places(garment, nullptr));
  garment.has_places = false;
  EXPECT_TRUE(lacks_places(garment, nullptr));
  garment.has_places = true;
  for (std::size_t p = 0; p < garment.placed.size(); ++p) {
    garment.placed[p] = Vec3(garment.flat[p].x(), garment.flat[p].y(), 0);
  }
  const Skeleton skeleton = figure();
  EXPECT_TRUE(lacks_places(garment, nullptr));
  EXPECT_TRUE(lacks_places(garment, &skeleton));
  EXPECT_TRUE(lacks_places(garment, std::make_unique<Skeleton>().get()));
  // An apron hangs before the body.
  for (Vec3& p : garment.placed) p.z() = 0.25;
  EXPECT_FALSE(lacks_places(garment, &skeleton));
  // A blanket of two pieces that falls on the body is laid out level.
  for (Vec3& p : garment.placed) p = Vec3(p.x(), 2, p.y());
  EXPECT_FALSE(lacks_places(garment, &skeleton));
}

}  // namespace locate_layout_test
}  // namespace toile
