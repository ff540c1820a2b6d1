#include "geometry/body/find_skeleton.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/error.h"
#include "tests/support/shapes.h"

namespace toile {
namespace find_skeleton_test {

/// The mannequin, made once. Edges of 15 mm show every girth that the search uses.
const TriangleMesh& mannequin() {
  static const TriangleMesh mesh = [] {
    MannequinOptions options;
    options.edge_length = 0.015;
    return make_mannequin(options).surface;
  }();
  return mesh;
}

/// The mannequin with both arms raised by `degrees` from its 45 about the shoulder joints. The
/// armpits stretch over a few centimetres.
TriangleMesh with_arms_raised(double degrees) {
  TriangleMesh mesh = mannequin();
  const Skeleton skeleton = find_skeleton(mesh, "mannequin");
  for (const int side : {1, -1}) {
    const std::string name = side > 0 ? "left_" : "right_";
    const Vec3 joint = skeleton.joint(name + "shoulder");
    const Vec3 along = (skeleton.joint(name + "elbow") - joint).normalized();
    for (Vec3& p : mesh.points) {
      if (side * p.x() < 0 || (p.y() < 1.27 && side * p.x() < 0.182)) continue;
      const double t = std::clamp((along.dot(p - joint) + 0.03) / 0.08, 0.0, 1.0);
      const double turn = degrees * std::numbers::pi / 180 * t * t * (3 - 2 * t);
      p = joint + Eigen::AngleAxisd(side * turn, Vec3::UnitZ()) * (p - joint);
    }
  }
  return mesh;
}

void expect_plausible(const Skeleton& skeleton, double height) {
  const auto at = [&](const std::string& name) { return Vec3(skeleton.joint(name) / height); };
  EXPECT_EQ(skeleton.joints.size(), 17u);
  EXPECT_NEAR(at("head").y(), 1, 0.005);
  EXPECT_NEAR(at("neck").y(), 0.85, 0.03);
  EXPECT_NEAR(at("chest").y(), 0.75, 0.03);
  EXPECT_NEAR(at("waist").y(), 0.635, 0.04);
  EXPECT_NEAR(at("pelvis").y(), 0.46, 0.04);
  for (const std::string side : {"left_", "right_"}) {
    const double sign = side == "left_" ? 1 : -1;
    EXPECT_NEAR(sign * at(side + "shoulder").x(), 0.10, 0.02) << side;
    EXPECT_NEAR(at(side + "shoulder").y(), 0.80, 0.02) << side;
    // Bones of an average adult [Drillis & Contini 1966].
    EXPECT_NEAR((at(side + "elbow") - at(side + "shoulder")).norm(), 0.17, 0.025) << side;
    EXPECT_NEAR((at(side + "wrist") - at(side + "elbow")).norm(), 0.14, 0.025) << side;
    EXPECT_NEAR(at(side + "hip").y(), 0.50, 0.03) << side;
    EXPECT_NEAR(at(side + "knee").y(), 0.275, 0.02) << side;
    EXPECT_NEAR(at(side + "ankle").y(), 0.045, 0.015) << side;
  }
  for (const std::string joint : {"shoulder", "elbow", "wrist", "hip", "knee", "ankle"}) {
    const Vec3 right = at("right_" + joint);
    EXPECT_LT((at("left_" + joint) - Vec3(-right.x(), right.y(), right.z())).norm(), 0.006)
        << joint;
  }
}

TEST(FindSkeleton, MannequinHasPlausibleSymmetricJoints) {
  expect_plausible(find_skeleton(mannequin(), "mannequin"), 1.70);
}

TEST(FindSkeleton, SegmentsRunAwayFromThePelvis) {
  const Skeleton skeleton = find_skeleton(mannequin(), "mannequin");
  EXPECT_EQ(skeleton.segments.size(), 12u);
  for (const Segment& segment : skeleton.segments) {
    EXPECT_NE(std::find(body_parts.begin(), body_parts.end(), segment.part), body_parts.end());
    EXPECT_GT((skeleton.joint(segment.from) - skeleton.joint(segment.to)).norm(), 0.05);
  }
  EXPECT_EQ(skeleton.segments.front().from, "pelvis");
}

TEST(FindSkeleton, ArmsMayHangOrReachOut) {
  for (const double degrees : {-25.0, -15.0, 20.0, 40.0}) {
    SCOPED_TRACE(degrees);
    expect_plausible(find_skeleton(with_arms_raised(degrees), "posed"), 1.70);
  }
}

TEST(FindSkeleton, JointsLieInsideTheBody) {
  const Skeleton skeleton = find_skeleton(mannequin(), "mannequin");
  for (const auto& [name, joint] : skeleton.joints) {
    if (name == "head" || name == "pelvis") continue;  // crown and crotch are on the surface
    // Winding number by solid angles [Van Oosterom & Strackee 1983]: 1 inside, 0 outside.
    double angle = 0;
    for (const Triangle& t : mannequin().triangles) {
      const Vec3 a = mannequin().points[t[0]] - joint;
      const Vec3 b = mannequin().points[t[1]] - joint;
      const Vec3 c = mannequin().points[t[2]] - joint;
      angle +=
          2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                b.dot(c) * a.norm() + c.dot(a) * b.norm());
    }
    EXPECT_NEAR(angle / (4 * std::numbers::pi), 1, 1e-6) << name;
  }
}

TEST(FindSkeleton, SizeDoesNotMatter) {
  TriangleMesh large = mannequin();
  for (Vec3& p : large.points) p *= 128;  // a power of two, so that nothing rounds differently
  const Skeleton small_one = find_skeleton(mannequin(), "small");
  for (const auto& [name, joint] : find_skeleton(large, "large").joints) {
    EXPECT_LT((joint / 128 - small_one.joint(name)).norm(), 1e-9) << name;
  }
}

TEST(FindSkeleton, ToesTellTheFront) {
  const Skeleton skeleton = find_skeleton(mannequin(), "mannequin");
  EXPECT_GT(toes_forward(mannequin(), skeleton), 0.02);
  TriangleMesh turned = mannequin();
  for (Vec3& p : turned.points) p = Vec3(-p.x(), p.y(), -p.z());
  EXPECT_LT(toes_forward(turned, find_skeleton(turned, "turned")), -0.02);
}

TEST(FindSkeleton, WhatIsNoBodyIsAnError) {
  EXPECT_THROW(find_skeleton(test::cube(), "cube"), Error);
  EXPECT_THROW(find_skeleton(test::sphere(1, 3), "below the floor"), Error);
  EXPECT_THROW(find_skeleton({}, "nothing"), Error);
  // The first body is two legs with nothing above them. The second is a table with four legs.
  const TriangleMesh legs = test::together(test::box({0.05, 0, -0.1}, {0.2, 1.7, 0.1}),
                                           test::box({-0.2, 0, -0.1}, {-0.05, 1.7, 0.1}));
  EXPECT_THROW(find_skeleton(legs, "legs"), Error);
  TriangleMesh armless = mannequin();
  for (Vec3& p : armless.points) p.x() = std::clamp(p.x(), -0.15, 0.15);
  EXPECT_THROW(find_skeleton(armless, "armless"), Error);
}

}  // namespace find_skeleton_test
}  // namespace toile
