#include "geometry/body/incomplete_body.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "geometry/body/clean_body.h"
#include "geometry/body/find_skeleton.h"
#include "geometry/body/mannequin/mannequin.h"
#include "geometry/body/measures.h"
#include "tests/support/shapes.h"

namespace toile {
namespace incomplete_body_test {

const TriangleMesh& mannequin() {
  static const TriangleMesh made = [] {
    MannequinOptions options;
    options.edge_length = 0.015;
    return make_mannequin(options).surface;
  }();
  return made;
}

/// The mannequin without what `is_gone`, its holes closed.
template <class Gone>
TriangleMesh without(const Gone& is_gone) {
  TriangleMesh cut = mannequin();
  std::erase_if(cut.triangles, [&](const Triangle& t) {
    return is_gone(cut.points[t[0]]) || is_gone(cut.points[t[1]]) || is_gone(cut.points[t[2]]);
  });
  RepairOptions options;
  options.largest_hole = 1;
  return repair(test::soup(cut), "cut", options).mesh;
}

const TriangleMesh& one_armed() {
  static const TriangleMesh body =
      without([](const Vec3& p) { return p.x() < -0.215 && p.y() > 0.75; });
  return body;
}

/// Shoulders to thighs, as a dress form.
const TriangleMesh& form() {
  static const TriangleMesh body =
      without([](const Vec3& p) { return p.y() < 0.78 || p.y() > 1.46 || std::abs(p.x()) > 0.2; });
  return body;
}

TriangleMesh turned(TriangleMesh mesh, double degrees, const Vec3& axis = Vec3::UnitY()) {
  const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, axis);
  for (Vec3& p : mesh.points) p = turn * p;
  return mesh;
}

std::optional<double> value(const std::vector<Measure>& measures, const std::string& name) {
  const Measure* measure = find_measure(measures, name);
  EXPECT_NE(measure, nullptr) << name;
  return measure != nullptr ? measure->value : std::nullopt;
}

std::vector<Measure> measured(const TriangleMesh& body) {
  return measure_body(find_landmarks(body, "body"));
}

TEST(IncompleteBody, OneArmTakesNothingFromTheOthersMeasures) {
  const std::vector<Measure> whole = measured(mannequin());
  // A body askew is measured in its own frame.
  for (const double degrees : {130.0, 180.0}) {
    const std::vector<Measure> found = measured(turned(one_armed(), degrees));
    for (const char* name : {"height", "bust", "waist", "hip", "neck", "head", "inside_leg",
                             "left_upper_arm", "left_arm_length", "left_knee", "right_calf",
                             "front_centre_length", "back_centre_length"}) {
      const auto is = value(found, name);
      ASSERT_TRUE(is) << name << ": " << find_measure(found, name)->reason;
      EXPECT_NEAR(*is, *value(whole, name), 0.003) << name << " turned by " << degrees;
    }
    for (const char* name : {"right_upper_arm", "right_elbow", "right_wrist", "right_arm_length",
                             "right_shoulder_length"}) {
      EXPECT_FALSE(value(found, name)) << name;
      EXPECT_FALSE(find_measure(found, name)->reason.empty()) << name;
    }
  }
}

TEST(IncompleteBody, OfWhomAPartIsMissingIsTurnedAndHasItsOtherJoints) {
  const TriangleMesh lying = turned(turned(one_armed(), 40), -90, Vec3::UnitX());
  const CleanBody body = clean_body(test::soup(lying), "lying");
  ASSERT_TRUE(body.skeleton);
  EXPECT_NE(body.report.missing.find("right arm"), std::string::npos) << body.report.missing;
  EXPECT_NEAR(body.report.height, 1.70, 0.01);
  EXPECT_TRUE(body.skeleton->joints.contains("left_wrist"));
  EXPECT_FALSE(body.skeleton->joints.contains("right_shoulder"));
  EXPECT_NEAR(body.skeleton->joint("left_knee").x(), -body.skeleton->joint("right_knee").x(), 0.01);
  EXPECT_GT(toes_forward(body.mesh, *body.skeleton), 0.02);
  for (const Segment& segment : body.skeleton->segments) EXPECT_NE(segment.part, "right_arm");
  EXPECT_FALSE(joint_outside(*body.skeleton, SurfaceDistance(body.mesh)));
}

TEST(IncompleteBody, ACutArmHasNoWrist) {
  const TriangleMesh body = without([](const Vec3& p) { return p.x() < -0.5 && p.y() > 0.6; });
  const std::vector<Measure> found = measured(body);
  EXPECT_FALSE(value(found, "right_wrist"));
  EXPECT_FALSE(value(found, "right_arm_length"));
  EXPECT_TRUE(value(found, "left_wrist"));
  EXPECT_TRUE(value(found, "right_upper_arm"));
}

TEST(IncompleteBody, ArmsThatBothEndInTheForearmKeepTheirElbows) {
  const TriangleMesh body =
      without([](const Vec3& p) { return std::abs(p.x()) > 0.48 && p.y() > 0.6; });
  const BodyShape whole = find_landmarks(mannequin(), "whole");
  const BodyShape cut = find_landmarks(body, "cut");
  for (const std::string side : {"left_", "right_"}) {
    EXPECT_FALSE(place_of(cut.landmarks, side + "wrist"));
    const Vec3 elbow = whole.frame.skeleton->joint(side + "elbow");
    EXPECT_LT((cut.frame.skeleton->joint(side + "elbow") - elbow).norm(), 0.02) << side;
  }
  const std::vector<Measure> found = measure_body(cut);
  EXPECT_FALSE(value(found, "left_arm_length"));
  EXPECT_NEAR(*value(found, "left_upper_arm"), *value(measure_body(whole), "left_upper_arm"),
              0.005);
}

TEST(IncompleteBody, LegsWithoutFeetTellNoHeights) {
  const std::vector<Measure> whole = measured(mannequin());
  const TriangleMesh body = without([](const Vec3& p) { return p.y() < 0.13; });
  const std::vector<Measure> found = measured(body);
  for (const char* name : {"height", "inside_leg", "bust_height", "left_knee_height",
                           "left_waist_to_floor", "left_ankle", "right_ankle"}) {
    EXPECT_FALSE(value(found, name)) << name;
    EXPECT_FALSE(find_measure(found, name)->reason.empty()) << name;
  }
  for (const char* name : {"bust", "waist", "hip", "left_upper_thigh"}) {
    EXPECT_NEAR(value(found, name).value_or(0), *value(whole, name), 0.004) << name;
  }
  EXPECT_NE(clean_body(test::soup(body), "cut").report.missing.find("feet"), std::string::npos);
}

TEST(IncompleteBody, AGirthAtTheCutOfALegIsNoCalf) {
  const std::vector<Measure> whole = measured(mannequin());
  for (const double cut : {0.12, 0.27, 0.34}) {
    const std::vector<Measure> found =
        measured(without([cut](const Vec3& p) { return p.x() > 0 && p.y() < cut; }));
    EXPECT_FALSE(value(found, "left_ankle")) << cut;
    EXPECT_EQ(value(found, "left_calf").has_value(), cut < 0.2) << cut;
    for (const char* name : {"height", "right_calf", "right_ankle", "left_knee"}) {
      EXPECT_NEAR(value(found, name).value_or(0), *value(whole, name), 0.004) << name;
    }
  }
}

TEST(IncompleteBody, AnArmWithoutAForearmIsNotMeasured) {
  const TriangleMesh body = without([](const Vec3& p) { return p.x() < -0.38 && p.y() > 0.6; });
  const std::vector<Measure> whole = measured(mannequin());
  for (const double degrees : {0.0, 130.0, 180.0}) {
    const std::vector<Measure> found = measured(turned(body, degrees));
    EXPECT_FALSE(value(found, "right_arm_length")) << degrees;
    EXPECT_FALSE(value(found, "right_upper_arm")) << degrees;
    for (const char* name : {"bust", "waist", "hip", "left_arm_length", "front_centre_length"}) {
      const auto is = value(found, name);
      ASSERT_TRUE(is) << name << ": " << find_measure(found, name)->reason;
      EXPECT_NEAR(*is, *value(whole, name), 0.004) << name << " turned by " << degrees;
    }
  }
  const CleanBody cleaned = clean_body(test::soup(turned(body, 130)), "cut");
  ASSERT_TRUE(cleaned.skeleton);
  EXPECT_FALSE(cleaned.skeleton->joints.contains("right_elbow"));
  EXPECT_GT(toes_forward(cleaned.mesh, *cleaned.skeleton), 0.02);
}

TEST(IncompleteBody, ItsJointsAreTakenAgain) {
  const CleanBody first = clean_body(test::soup(one_armed()), "first");
  CleanOptions options;
  options.skeleton = first.skeleton;
  options.metres_per_unit = 1;
  const CleanBody again = clean_body(test::soup(first.mesh), "again", options);
  EXPECT_EQ(again.report.skeleton_refused, "");
  EXPECT_FALSE(again.report.missing.empty());
  ASSERT_TRUE(again.skeleton);
  EXPECT_EQ(again.skeleton->joints.size(), first.skeleton->joints.size());
}

TEST(IncompleteBody, GirthLevelsOfAFormAreThoseThatAreMeasured) {
  const CleanBody body = clean_body(test::soup(form()), "form");
  ASSERT_TRUE(body.skeleton);
  const std::vector<NamedLevel> levels = girth_levels(body.mesh, *body.skeleton);
  const TrunkLevels measured = find_landmarks(body.mesh, "form").levels;
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_NEAR(levels[0].height, *measured.bust.height, 0.002);
  EXPECT_NEAR(levels[1].height, *measured.waist.height, 0.002);
  EXPECT_NEAR(levels[2].height, *measured.hip.height, 0.002);
}

TEST(IncompleteBody, AFormFacesForwardAndHasATorso) {
  const std::vector<Measure> whole = measured(mannequin());
  for (const double degrees : {0.0, 180.0}) {
    const CleanBody body = clean_body(test::soup(turned(form(), degrees)), "form");
    ASSERT_TRUE(body.skeleton) << degrees;
    for (const char* name : {"pelvis", "waist", "chest", "neck"}) {
      EXPECT_TRUE(body.skeleton->joints.contains(name)) << name;
    }
    EXPECT_EQ(body.skeleton->segments.size(), 3U);
    EXPECT_FALSE(joint_outside(*body.skeleton, SurfaceDistance(body.mesh)));
    const std::vector<Measure> found = measured(body.mesh);
    for (const char* name : {"bust", "waist", "hip"}) {
      ASSERT_TRUE(value(found, name)) << name;
      EXPECT_NEAR(*value(found, name), *value(whole, name), 0.005) << name << ", " << degrees;
    }
    EXPECT_FALSE(value(found, "height"));
  }
}

TEST(IncompleteBody, WhatIsNoBodyHasNone) {
  EXPECT_FALSE(incomplete_body(test::sphere(0.5, 3), "sphere"));
  EXPECT_FALSE(incomplete_body(test::box({-0.2, 0, -0.2}, {0.2, 1, 0.2}), "box"));
}

}  // namespace incomplete_body_test
}  // namespace toile
