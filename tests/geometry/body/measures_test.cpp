#include "geometry/body/measures.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/body/body_proportions.h"
#include "geometry/body/mannequin/fit_mannequin.h"
#include "geometry/body/mannequin/mannequin.h"
#include "geometry/body/tape.h"
#include "geometry/decimate.h"
#include "geometry/geodesic.h"
#include "geometry/slice.h"
#include "tests/support/noise.h"
#include "tests/support/shapes.h"

namespace toile {
namespace measures_test {

constexpr double millimetre = 0.001;

const Mannequin& mannequin() {
  static const Mannequin made = [] {
    MannequinOptions options;
    options.edge_length = 0.012;
    return make_mannequin(options);
  }();
  return made;
}

const BodyShape& shape() {
  static const BodyShape found = find_landmarks(mannequin().surface, "mannequin");
  return found;
}

const std::vector<Measure>& measures() {
  static const std::vector<Measure> taken = measure_body(shape());
  return taken;
}

double value(const std::string& name) {
  const Measure* measure = find_measure(measures(), name);
  return measure != nullptr && measure->value ? *measure->value : std::nan("");
}

double target(const std::string& name) {
  for (const MannequinGirth& girth : mannequin().girths) {
    if (girth.name == name) return girth.target;
  }
  return std::nan("");
}

/// Metres by which the landmark moves that moves most; `back` undoes what was done to the body.
template <class Back>
double most_moved(const TriangleMesh& changed, const Back& back,
                  const BodyShape& unchanged = shape()) {
  const Landmarks before = given_landmarks(unchanged);
  const Landmarks after = given_landmarks(find_landmarks(changed, "changed"));
  double most = 0;
  for (const Landmark& landmark : before) {
    const auto place = place_of(after, landmark.name);
    EXPECT_EQ(place.has_value(), landmark.place.has_value()) << landmark.name;
    if (!place || !landmark.place) continue;
    const double moved = (back(*place) - *landmark.place).norm();
    most = std::max(most, moved);
  }
  return most;
}

TEST(Measures, GirthsLieInThePlanesThatAreGiven) {
  const BodyMeasures all = body_measures(measures());
  ASSERT_GT(all.girths.size(), 10U);
  for (const BodyGirth& girth : all.girths) {
    EXPECT_NEAR(girth.normal.norm(), 1, 1e-9);
    EXPECT_EQ(all.lengths.at(girth.name), girth.girth);
    double nearest = 1;
    for (const Section& section : slice(mannequin().surface, girth.origin, girth.normal)) {
      nearest = std::min(nearest, std::abs(section.girth - girth.girth));
    }
    EXPECT_LT(nearest, 1e-6) << girth.name;
  }
  EXPECT_GT(all.shoulder_points.at("left").x(), 0.1);
  EXPECT_LT(all.shoulder_points.at("right").x(), -0.1);
}

TEST(Measures, GirthsOfTheMannequinAreThoseItWasMadeTo) {
  EXPECT_NEAR(value("bust"), target("bust"), 1 * millimetre);
  EXPECT_NEAR(value("hip"), target("hip"), 1.5 * millimetre);
  // The mannequin's waist is 2 cm below its thinnest place, its knee 5 mm below the kneecap.
  EXPECT_NEAR(value("waist"), target("waist"), 5 * millimetre);
  EXPECT_NEAR(value("left_knee"), target("knee"), 3 * millimetre);
  EXPECT_NEAR(value("left_calf"), target("calf"), 1.5 * millimetre);
  // The wrist is found thinner next to where it was made.
  EXPECT_NEAR(value("right_wrist"), target("wrist"), 4 * millimetre);
  EXPECT_LT(value("underbust"), value("bust"));
  EXPECT_LT(value("waist"), value("abdomen"));
}

TEST(Measures, BothSidesOfASymmetricBodyAgree) {
  for (const Measure& measure : measures()) {
    ASSERT_TRUE(measure.value) << measure.name << ": " << measure.reason;
    EXPECT_FALSE(measure.definition.empty()) << measure.name;
    EXPECT_GT(*measure.value, 0) << measure.name;
    if (!measure.name.starts_with("left_")) continue;
    const double other = value("right_" + measure.name.substr(5));
    EXPECT_NEAR(*measure.value, other, measure.is_angle ? 0.5 : 2 * millimetre) << measure.name;
  }
}

TEST(Measures, ArcsMakeUpTheirGirths) {
  for (const auto& [girth, front, back] : {std::array{"bust", "bust_arc", "back_arc"},
                                           std::array{"waist", "front_waist_arc", "back_waist_arc"},
                                           std::array{"hip", "front_hip_arc", "back_hip_arc"}}) {
    double sum = 0;
    for (const std::string side : {"left_", "right_"})
      sum += value(side + front) + value(side + back);
    EXPECT_NEAR(sum, value(girth), 1e-9) << girth;
  }
}

TEST(Measures, HeightsAddUp) {
  EXPECT_NEAR(value("waist_to_hip"), value("waist_height") - value("hip_height"), 1e-12);
  EXPECT_NEAR(value("crotch_depth") + value("crotch_height"), value("waist_height"), 1e-12);
  EXPECT_GT(value("left_waist_to_floor"), value("waist_height"));
  EXPECT_GT(value("left_front_full_length"), value("front_centre_length"));
}

TEST(FindLandmarks, DoNotDependOnHowTheBodyIsTurned) {
  for (const double degrees : {7.0, 120.0, 180.0}) {
    const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, Vec3::UnitY());
    TriangleMesh turned = mannequin().surface;
    for (Vec3& p : turned.points) p = turn * p;
    const double most = most_moved(turned, [&](const Vec3& p) { return Vec3(turn.inverse() * p); });
    EXPECT_LT(most, 0.1 * millimetre) << degrees;
  }
}

TEST(FindLandmarks, HoldAtHalfTheResolution) {
  const TriangleMesh& whole = mannequin().surface;
  const TriangleMesh half = decimate(whole, static_cast<int>(whole.triangles.size() / 2));
  EXPECT_LT(most_moved(half, [](const Vec3& p) { return p; }), 5 * millimetre);
}

TEST(FindLandmarks, HoldUnderAMillimetreOfNoise) {
  const TriangleMesh whole = make_mannequin().surface;
  const BodyShape unchanged = find_landmarks(whole, "mannequin");
  for (const unsigned seed : {1U, 2U, 3U}) {
    const double moved = most_moved(
        test::noisy(whole, seed), [](const Vec3& p) { return p; }, unchanged);
    EXPECT_LT(moved, 5 * millimetre) << seed;
  }
}

TEST(FindLandmarks, AFlatChestKeepsItsLevelUnderAMillimetreOfNoise) {
  const MeasureValues given = {{"height", 1.10}, {"bust", 0.59}, {"hip", 0.62}};
  MannequinOptions options;
  options.edge_length = 0.009;
  const TriangleMesh child =
      fit_mannequin(given, filled_measures(given, FigureType::child), FigureType::child, options)
          .mannequin.surface;
  const TrunkLevel bust = find_landmarks(child, "child").levels.bust;
  ASSERT_TRUE(bust.height);
  EXPECT_LT(bust.confidence, 0.6);
  EXPECT_NE(bust.reason.find("stands out little"), std::string::npos) << bust.reason;
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    const TrunkLevel noisy = find_landmarks(test::noisy(child, seed), "noisy").levels.bust;
    ASSERT_TRUE(noisy.height);
    EXPECT_NEAR(*noisy.height, *bust.height, 4 * millimetre) << seed;
  }
}

TEST(FindLandmarks, GrowWithTheBody) {
  TriangleMesh child = mannequin().surface;
  for (Vec3& p : child.points) p *= 0.62;
  EXPECT_LT(most_moved(child, [](const Vec3& p) { return Vec3(p / 0.62); }), 1 * millimetre);
}

TEST(FindLandmarks, ASphereHasNoneAndSaysWhy) {
  const BodyShape ball = find_landmarks(test::sphere(0.8, 4), "ball");
  for (const Landmark& landmark : ball.landmarks) {
    if (landmark.name == "floor") continue;
    EXPECT_FALSE(landmark.place) << landmark.name;
    EXPECT_FALSE(landmark.reason.empty()) << landmark.name;
  }
  for (const Measure& measure : measure_body(ball)) {
    EXPECT_FALSE(measure.value) << measure.name;
    EXPECT_FALSE(measure.reason.empty()) << measure.name;
  }
}

TEST(Tape, IsTautOverAHollow) {
  const std::vector<Vec3> hollow = {{0, 0, 0}, {0, 1, 1}, {0, 2, 0}, {0, 3, 1}, {0, 4, 0}};
  EXPECT_NEAR(length_of(taut(hollow, Vec3::UnitZ())), 2 + 2 * std::numbers::sqrt2, 1e-12);
  EXPECT_NEAR(length_of(taut(hollow, -Vec3::UnitZ())), 4, 1e-12);
}

TEST(Geodesic, IsAGreatCircleOnASphere) {
  const TriangleMesh sphere = test::sphere(0.1, 5);
  const double length = length_of(geodesic(sphere, {0.1, 0, 0}, {0, 0.08, 0.06}));
  EXPECT_NEAR(length, 0.1 * std::numbers::pi / 2, 1e-4);
}

}  // namespace measures_test
}  // namespace toile
