#include "geometry/body/mannequin/posed_mannequin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "geometry/body/find_skeleton.h"
#include "geometry/body/mannequin/mannequin.h"
#include "geometry/error.h"
#include "geometry/intersections.h"
#include "geometry/slice.h"
#include "geometry/surface_distance.h"
#include "tests/support/shapes.h"

namespace toile {
namespace posed_mannequin_test {

constexpr double edge_length = 0.015;

const Mannequin& walking() {
  static const Mannequin made = make_mannequin({edge_length, walking_pose()});
  return made;
}

/// The same step with the other leg.
const Mannequin& walking_on() {
  static const Mannequin made = make_mannequin({edge_length, mirrored(walking_pose())});
  return made;
}

const Mannequin& standing() {
  static const Mannequin made = make_mannequin({edge_length, standing_pose()});
  return made;
}

/// Knees and elbows are bent far, and arms and legs swung and spread as far as they go.
Pose leap() {
  Pose pose;
  pose.left.hip_flexion = 60;
  pose.left.hip_abduction = 20;
  pose.left.knee_flexion = 80;
  pose.right.hip_flexion = -30;
  pose.right.hip_rotation = 30;
  pose.right.knee_flexion = 60;
  pose.right.ankle_flexion = 45;
  pose.right.toes_extension = 45;
  pose.left.shoulder_flexion = 90;
  pose.left.elbow_flexion = 90;
  pose.right.shoulder_flexion = -45;
  pose.right.shoulder_abduction = 70;
  pose.right.shoulder_rotation = 40;
  return pose;
}

double tall(const TriangleMesh& mesh) {
  double y = 0;
  for (const Vec3& p : mesh.points) y = std::max(y, p.y());
  return y;
}

TEST(PosedMannequin, IsOneClosedSphereThatDoesNotIntersectItself) {
  const Mannequin leaping = make_mannequin({edge_length, leap()});
  for (const Mannequin* made : {&walking(), &leaping}) {
    const TriangleMesh& mesh = made->surface;
    EXPECT_TRUE(test::is_closed(mesh));
    EXPECT_EQ(mesh.points.size() - mesh.triangles.size() / 2, 2u) << "one sphere";
    EXPECT_TRUE(self_intersections(mesh).empty());
    const double volume = test::volume(mesh) / test::volume(standing().surface);
    std::cout << "volume, of the standing one's: " << volume << "\n";
    EXPECT_NEAR(volume, 1, 0.03);
  }
}

TEST(PosedMannequin, BothFeetOfAStepAreOnTheFloor) {
  double left = 1;
  double right = 1;
  for (const Vec3& p : walking().surface.points) {
    double& low = p.x() > 0 ? left : right;
    low = std::min(low, p.y());
  }
  std::cout << "lowest points: left " << 1000 * left << " mm, right " << 1000 * right << " mm\n";
  EXPECT_EQ(std::min(left, right), 0);
  EXPECT_LT(std::max(left, right), 0.002);
}

TEST(PosedMannequin, BonesKeepTheirLengthsAndPointAsThePoseSays) {
  const Skeleton& at_rest = sample_bones().joints;
  for (const Pose& pose : {walking_pose(), leap()}) {
    const MannequinShape shape;
    const Skeleton posed = PosedMannequin(shape, pose).skeleton();
    double worst = 0;
    for (const Segment& bone : posed.segments) {
      const double before = (at_rest.joint(bone.to) - at_rest.joint(bone.from)).norm();
      const double after = (posed.joint(bone.to) - posed.joint(bone.from)).norm();
      worst = std::max(worst, std::abs(after - before));
    }
    std::cout << "bone lengths change by at most " << worst << " m\n";
    EXPECT_LT(worst, 1e-12);
  }
  const auto forward = [](const Vec3& bone) {
    return std::atan2(bone.z(), -bone.y()) * 180 / std::numbers::pi;
  };
  const auto bone = [](const Skeleton& skeleton, const std::string& from, const std::string& to) {
    return Vec3(skeleton.joint(to) - skeleton.joint(from));
  };
  const Skeleton& walk = walking().skeleton;
  for (const std::string side : {"left_", "right_"}) {
    const SidePose pose = side == "left_" ? walking_pose().left : walking_pose().right;
    const auto swung = [&](const std::string& from, const std::string& to) {
      return forward(bone(walk, side + from, side + to)) -
             forward(bone(at_rest, side + from, side + to));
    };
    EXPECT_NEAR(swung("hip", "knee"), pose.hip_flexion, 1e-9);
    EXPECT_NEAR(swung("knee", "ankle"), pose.hip_flexion - pose.knee_flexion, 1e-9);
    const Vec3 arm = bone(walk, side + "shoulder", side + "elbow").normalized();
    EXPECT_NEAR(std::asin(std::abs(arm.x())) * 180 / std::numbers::pi, pose.shoulder_abduction,
                1e-9);
  }
}

// Girths are measured on the mesh, square to the posed limbs. The upper thigh is measured 3 cm
// below the crotch, where trunk and thigh flow into each other.
TEST(PosedMannequin, GirthsOfTheLimbsStay) {
  const auto compare = [](const Mannequin& made, const std::string& pose) {
    for (std::size_t i = 0; i < made.girths.size(); ++i) {
      const MannequinGirth& girth = made.girths[i];
      const double off = girth.measured - girth.target;
      std::cout << pose << ": " << girth.name << " off by " << 1000 * off << " mm\n";
      EXPECT_NEAR(off, 0, girth.name == "upper thigh" ? 0.008 : 0.004) << pose << " " << girth.name;
    }
  };
  compare(walking(), "walking");
  compare(walking_on(), "its mirror image");
}

TEST(PosedMannequin, LegsAreApartBelowTheUpperThigh) {
  const double crotch = walking().skeleton.joint("pelvis").y();
  double gap = 1;
  for (double y = crotch - 0.05; y > 0.1; y -= 0.02) {
    const auto sections = slice(walking().surface, Vec3(0, y, 0), Vec3::UnitY());
    ASSERT_EQ(sections.size(), 2u) << y;
    double left = 1;
    double right = -1;
    for (const auto& section : sections) {
      for (const Vec3& p : section.points) {
        if (section.centroid.x() > 0) left = std::min(left, p.x());
        if (section.centroid.x() < 0) right = std::max(right, p.x());
      }
    }
    gap = std::min(gap, left - right);
  }
  std::cout << "least gap " << 1000 * gap << " mm\n";
  EXPECT_GT(gap, 0.008);
}

TEST(PosedMannequin, TheOtherLegForwardIsTheMirrorImage) {
  const SurfaceDistance body(walking_on().surface);
  double worst = 0;
  for (const Vec3& p : walking().surface.points) {
    worst = std::max(worst, std::abs(body.closest_point(Vec3(-p.x(), p.y(), p.z())).distance));
  }
  std::cout << "mirror images differ by at most " << 1000 * worst << " mm\n";
  EXPECT_LT(worst, 0.001);
  const MannequinShape shape;
  const PosedMannequin one(shape, walking_pose());
  const PosedMannequin two(shape, mirrored(walking_pose()));
  for (double y = 0; y < 1.7; y += 0.05) {
    const Vec3 p(0.1 + 0.1 * y, y, 0.3 - 0.3 * y);
    EXPECT_EQ(one.distance(p), two.distance(Vec3(-p.x(), p.y(), p.z())));
  }
}

TEST(PosedMannequin, StandingIsTheShapeItIsMadeFrom) {
  const MannequinShape shape;
  const PosedMannequin posed(shape, standing_pose());
  double worst = 0;
  for (std::size_t i = 0; i < standing().surface.points.size(); i += 7) {
    const Vec3 p = standing().surface.points[i];
    worst = std::max(worst, std::abs(posed.distance(p) - shape.distance(p)));
  }
  // The soles are cut before feet and legs are joined, not after.
  EXPECT_LT(worst, 1e-5);
  EXPECT_NEAR(standing().skeleton.joint("left_knee").y(), 0.465, 1e-6);
}

TEST(PosedMannequin, ItsJointsAreInsideAndFoundAgain) {
  const SurfaceDistance body(walking().surface);
  const Skeleton found = find_skeleton(walking().surface, "walking");
  for (const auto& [name, joint] : walking().skeleton.joints) {
    // The crown and the crotch are on the skin.
    const bool inner = name != "head" && name != "pelvis";
    EXPECT_LT(body.closest_point(joint).distance, inner ? -0.015 : 0.002) << name;
    const double off = (found.joint(name) - joint).norm();
    std::cout << name << " found " << 1000 * off << " mm off\n";
    EXPECT_LT(off, 0.06) << name;
  }
  EXPECT_NEAR(walking().skeleton.joint("head").y(), tall(walking().surface), 0.002);
}

// The joints at rest are those that find_skeleton finds on the standing mannequin.
TEST(PosedMannequin, StandingJointsAreThoseThatAreFound) {
  const Skeleton found = find_skeleton(standing().surface, "standing");
  for (const auto& [name, joint] : sample_bones().joints.joints) {
    EXPECT_LT((found.joint(name) - joint).norm(), 0.012) << name;
  }
}

TEST(PosedMannequin, RefusesPosesInWhichPartsTouch) {
  Pose pose;
  pose.right.shoulder_abduction = 30;
  pose.right.elbow_flexion = 90;
  pose.right.shoulder_rotation = -60;
  EXPECT_THROW(make_mannequin({0.015, pose}), Error);
  pose = {};
  pose.left.knee_flexion = 120;
  EXPECT_THROW(make_mannequin({0.015, pose}), Error);
}

}  // namespace posed_mannequin_test
}  // namespace toile
