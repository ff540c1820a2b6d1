#include "geometry/body/mannequin/fit_mannequin.h"

#include <gtest/gtest.h>

#include "geometry/body/body_proportions.h"
#include "geometry/intersections.h"
#include "geometry/slice.h"

namespace toile {
namespace fit_mannequin_test {

FittedMannequin fitted(const MeasureValues& given, FigureType figure) {
  MannequinOptions options;
  options.edge_length = 0.014;
  return fit_mannequin(given, filled_measures(given, figure), figure, options);
}

/// The largest horizontal girth near a height, measured from the mesh alone.
double girth_near(const TriangleMesh& mesh, double height, bool largest) {
  double best = largest ? 0 : 10;
  for (double y = height - 0.02; y <= height + 0.02; y += 0.004) {
    const double girth = slice(mesh, Vec3(0, y, 0), Vec3::UnitY()).front().girth;
    best = largest ? std::max(best, girth) : std::min(best, girth);
  }
  return best;
}

TEST(FitMannequin, ALargerWomanHasTheMeasuresThatWereGiven) {
  const MeasureValues given = {{"height", 1.64}, {"bust", 1.10}, {"waist", 0.94},    {"hip", 1.17},
                               {"neck", 0.39},   {"knee", 0.42}, {"upper_arm", 0.35}};
  const FittedMannequin made = fitted(given, FigureType::woman);
  double top = 0;
  for (const Vec3& p : made.mannequin.surface.points) top = std::max(top, p.y());
  EXPECT_NEAR(top, 1.64, 0.003);
  int seen = 0;
  for (const FittedMeasure& measure : made.measures) {
    if (!measure.is_given) continue;
    EXPECT_NEAR(measure.measured, measure.wanted, 0.002) << measure.name;
    EXPECT_EQ(measure.wanted, given.at(measure.name));
    ++seen;
  }
  EXPECT_EQ(seen, 7);
  for (const FittedMeasure& measure : made.measures) {
    if (measure.name == "waist_height") {
      EXPECT_NEAR(girth_near(made.mannequin.surface, measure.measured, false), 0.94, 0.004);
    }
    if (measure.name == "hip_height") {
      EXPECT_NEAR(girth_near(made.mannequin.surface, measure.measured, true), 1.17, 0.012);
    }
  }
  EXPECT_TRUE(self_intersections(made.mannequin.surface).empty());
}

TEST(FitMannequin, ArmsLeaveTheBustOfALargeWomanFree) {
  const MeasureValues given = {{"height", 1.65}, {"bust", 1.35}, {"hip", 1.42}};
  const FittedMannequin made = fitted(given, FigureType::woman);
  EXPECT_GT(made.pose.left.shoulder_abduction, standing_pose().left.shoulder_abduction);
  for (const FittedMeasure& measure : made.measures) {
    if (!measure.is_given) continue;
    EXPECT_NEAR(measure.measured, measure.wanted, 0.002) << measure.name;
  }
  for (const MannequinGirth& girth : made.mannequin.girths) {
    if (girth.name != "bust") continue;
    const std::vector<Section> sections =
        slice(made.mannequin.surface, girth.centre, Vec3::UnitY());
    ASSERT_FALSE(sections.empty());
    // With arms at its sides the section is 70 cm wide.
    for (const Vec3& p : sections.front().points) EXPECT_LT(std::abs(p.x()), 0.30);
  }
}

TEST(FitMannequin, AChildIsOneSurfaceAndPosesKeepItsBones) {
  const MeasureValues given = {{"height", 1.16}, {"bust", 0.59}, {"hip", 0.63}};
  const MeasureValues filled = filled_measures(given, FigureType::child);
  MannequinOptions options;
  options.edge_length = 0.009;
  options.pose = walking_pose();
  const FittedMannequin made = fit_mannequin(given, filled, FigureType::child, options);
  for (const FittedMeasure& measure : made.measures) {
    if (!measure.is_given) continue;
    EXPECT_NEAR(measure.measured, measure.wanted, 0.002) << measure.name;
  }
  const TriangleMesh& surface = made.mannequin.surface;
  EXPECT_EQ(surface.points.size() - surface.triangles.size() / 2, 2U) << "one sphere";
  EXPECT_TRUE(self_intersections(surface).empty());
  const Skeleton& joints = made.mannequin.skeleton;
  EXPECT_GT(joints.joint("left_ankle").z(), joints.joint("right_ankle").z() + 0.2);
}

TEST(BuiltMannequin, TheSampleIsTheBuildOfOnes) {
  const MannequinShape built = built_mannequin({});
  MannequinShape sample;
  sample.carve(2e-4);
  for (const Vec3& p : {Vec3(0.1, 1.2, 0.12), Vec3(0.4, 1.1, 0), Vec3(0.1, 0.5, 0.05),
                        Vec3(0, 1.6, 0.09), Vec3(0.1, 0.05, 0.1), Vec3(0, 1.47, 0.03)}) {
    EXPECT_NEAR(built.distance(p), sample.distance(p), 2e-3);
  }
}

}  // namespace fit_mannequin_test
}  // namespace toile
