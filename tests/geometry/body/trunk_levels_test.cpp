#include "geometry/body/trunk_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/body/mannequin/mannequin_build.h"
#include "geometry/slice.h"
#include "tests/support/shapes.h"

namespace toile {
namespace trunk_levels_test {

/// A level ellipse, metres.
struct Ring {
  double y = 0;
  double half_width = 0;
  double half_depth = 0;
};

/// A closed surface through the rings, smooth from ring to ring, as turned on an oval lathe.
TriangleMesh lathe(const std::vector<Ring>& rings) {
  constexpr int around = 96;
  constexpr int between = 24;
  TriangleMesh mesh;
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    for (int k = 0; k < between + (i + 2 == rings.size() ? 1 : 0); ++k) {
      const double t = static_cast<double>(k) / between;
      const double s = t * t * (3 - 2 * t);
      const auto mix = [s](double a, double b) { return a + s * (b - a); };
      const Ring& a = rings[i];
      const Ring& b = rings[i + 1];
      for (int j = 0; j < around; ++j) {
        const double angle = 2 * std::numbers::pi * j / around;
        mesh.points.emplace_back(mix(a.half_width, b.half_width) * std::cos(angle),
                                 a.y + t * (b.y - a.y),
                                 -mix(a.half_depth, b.half_depth) * std::sin(angle));
      }
    }
  }
  const int levels = static_cast<int>(mesh.points.size()) / around;
  const int bottom = static_cast<int>(mesh.points.size());
  mesh.points.emplace_back(0, rings.front().y, 0);
  mesh.points.emplace_back(0, rings.back().y, 0);
  for (int j = 0; j < around; ++j) {
    const int next = (j + 1) % around;
    for (int i = 0; i + 1 < levels; ++i) {
      const int a = i * around + j;
      const int b = i * around + next;
      mesh.triangles.push_back({a, b, a + around});
      mesh.triangles.push_back({b, b + around, a + around});
    }
    mesh.triangles.push_back({next, j, bottom});
    mesh.triangles.push_back({(levels - 1) * around + j, (levels - 1) * around + next, bottom + 1});
  }
  return mesh;
}

TrunkLevels levels_of(const TriangleMesh& mesh) { return trunk_levels(body_frame(mesh, "form")); }

/// Hip at 0.12 m, waist at 0.32, bust at 0.52.
const std::vector<Ring> form = {
    {0, 0.16, 0.11}, {0.12, 0.18, 0.13}, {0.32, 0.13, 0.095}, {0.52, 0.16, 0.125}};

std::vector<Ring> with(std::vector<Ring> rings, double lift, const std::vector<Ring>& above,
                       const std::vector<Ring>& below = {}) {
  for (Ring& ring : rings) ring.y += lift;
  rings.insert(rings.begin(), below.begin(), below.end());
  for (Ring ring : above) {
    ring.y += lift;
    rings.push_back(ring);
  }
  return rings;
}

void expect_form(const TrunkLevels& found, double lift) {
  ASSERT_TRUE(found.waist.height) << found.waist.reason;
  ASSERT_TRUE(found.bust.height && found.hip.height);
  EXPECT_NEAR(*found.waist.height, 0.32 + lift, 0.006);
  EXPECT_NEAR(*found.bust.height, 0.52 + lift, 0.006);
  EXPECT_NEAR(*found.hip.height, 0.12 + lift, 0.006);
}

void expect_nothing(const TrunkLevels& found) {
  for (const TrunkLevel* level :
       {&found.bust, &found.underbust, &found.waist, &found.abdomen, &found.hip}) {
    EXPECT_FALSE(level->height);
    EXPECT_FALSE(level->reason.empty());
  }
}

TEST(TrunkLevels, AFormWithoutLimbsHasBustWaistAndHip) {
  expect_form(levels_of(lathe(with(form, 0, {{0.7, 0.06, 0.055}}))), 0);
}

TEST(TrunkLevels, TheNeckOfABodyWithoutArmsIsNoWaist) {
  const std::vector<Ring> head = {{0.68, 0.055, 0.055}, {0.80, 0.075, 0.09}, {0.92, 0.02, 0.02}};
  expect_form(levels_of(lathe(with(form, 0, head))), 0);
}

TEST(TrunkLevels, ThePoleOfAFormIsNoWaist) {
  const std::vector<Ring> stand = {
      {0, 0.25, 0.25}, {0.02, 0.25, 0.25}, {0.03, 0.02, 0.02}, {0.795, 0.02, 0.02}};
  expect_form(levels_of(lathe(with(form, 0.8, {{0.7, 0.06, 0.055}}, stand))), 0.8);
}

TEST(TrunkLevels, WhatIsNoTrunkHasNone) {
  // A vase, round all over.
  std::vector<Ring> vase = form;
  for (Ring& ring : vase) ring.half_depth = ring.half_width;
  expect_nothing(levels_of(lathe(with(vase, 0, {{0.7, 0.06, 0.06}}))));
  // An hourglass, too thin; and two balls of different size, one on the other.
  std::vector<Ring> hourglass = form;
  hourglass[2] = {0.32, 0.07, 0.06};
  expect_nothing(levels_of(lathe(with(hourglass, 0, {{0.7, 0.06, 0.055}}))));
  std::vector<Ring> balls = form;
  balls[1] = {0.12, 0.34, 0.25};
  balls[2] = {0.32, 0.193, 0.142};
  balls[3] = {0.52, 0.205, 0.151};
  expect_nothing(levels_of(lathe(with(balls, 0, {{0.7, 0.06, 0.055}}))));
}

/// A woman's body in its frame, with breasts moved forward and down (metres).
BodyFrame with_breasts(double forward, double down) {
  MannequinOptions options;
  options.edge_length = 0.009;
  static const Mannequin woman = mesh_mannequin(built_mannequin({}), options);
  static const TrunkLevels levels = [] {
    BodyFrame frame{
        woman.surface, woman.skeleton, "", Eigen::Matrix3d::Identity(), Vec3::Zero(), 0};
    for (const Vec3& p : woman.surface.points) frame.height = std::max(frame.height, p.y());
    return trunk_levels(frame);
  }();
  BodyFrame frame{woman.surface, woman.skeleton, "", Eigen::Matrix3d::Identity(), Vec3::Zero(), 0};
  for (Vec3& p : frame.mesh.points) {
    frame.height = std::max(frame.height, p.y());
    for (const double side : {-0.09, 0.09}) {
      const Vec3 breast(side, *levels.bust.height, 0.12);
      const double reach = (p - breast).norm() / 0.07;
      p += std::exp(-reach * reach) * Vec3(0, -down, forward);
    }
  }
  return frame;
}

double trunk_girth(const BodyFrame& body, double y) {
  return slice(body.mesh, {0, y, 0}, Vec3::UnitY()).front().girth;
}

TEST(TrunkLevels, ALowBustIsWhereItStandsOut) {
  const TrunkLevels plain = trunk_levels(with_breasts(0, 0));
  for (const double down : {0.03, 0.06, 0.09}) {
    const BodyFrame body = with_breasts(0.04, down);
    const TrunkLevels low = trunk_levels(body);
    ASSERT_TRUE(low.bust.height && low.underbust.height);
    EXPECT_NEAR(*low.bust.height, *plain.bust.height - down, 0.012) << down;
    // Below the breasts the trunk is as it was, within 3 cm.
    EXPECT_LT(trunk_girth(body, *low.underbust.height),
              trunk_girth(with_breasts(0, 0), *low.underbust.height) + 0.03)
        << down;
    EXPECT_GT(*low.underbust.height, *low.waist.height);
  }
}

}  // namespace trunk_levels_test
}  // namespace toile
