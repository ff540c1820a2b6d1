#include "geometry/body/measure_errors.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/body/mannequin/mannequin_build.h"
#include "geometry/body/mannequin/mannequin_measures.h"

namespace toile {
namespace measure_errors_test {

std::vector<Measure> measured(const TriangleMesh& body) {
  std::vector<Measure> measures = measure_body(find_landmarks(body, "body"));
  estimate_errors(body, "body", measures);
  return measures;
}

TEST(MeasureErrors, ABodyThatStandsALittleOtherwiseIsWithinThem) {
  MannequinOptions options;
  options.edge_length = 0.012;
  const TriangleMesh body = mesh_mannequin(built_mannequin({}), options).surface;
  const std::vector<Measure> measures = measured(body);
  TriangleMesh other = body;
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.012, Vec3::UnitZ()) * Eigen::AngleAxisd(-0.008, Vec3::UnitX()))
          .toRotationMatrix();
  for (Vec3& point : other.points) point = turn * point;
  const std::vector<Measure> again = measure_body(find_landmarks(other, "body"));
  int within = 0;
  int taken = 0;
  for (const Measure& measure : measures) {
    if (!measure.value) {
      EXPECT_EQ(measure.plus_minus, 0) << measure.name;
      continue;
    }
    EXPECT_GE(measure.plus_minus, 0.004) << measure.name;
    const Measure* same = find_measure(again, measure.name);
    if (same == nullptr || !same->value) continue;
    ++taken;
    if (std::abs(*same->value - *measure.value) <= measure.plus_minus) ++within;
  }
  EXPECT_GT(taken, 90);
  EXPECT_GE(within, 0.9 * taken);
  EXPECT_LT(find_measure(measures, "waist")->plus_minus, 0.02);
}

TEST(MeasuresByProportion, AreTheSamplesOnABodyOfItsSize) {
  MannequinOptions options;
  options.edge_length = 0.012;
  const MeasureValues sample = mannequin_measures(mesh_mannequin(built_mannequin({}), options));
  const MeasureValues known = {{"height", 1.1 * sample.at("height")},
                               {"bust", 1.2 * sample.at("bust")},
                               {"waist", 1.4 * sample.at("waist")}};
  const MeasureValues filled = measures_by_proportion(known);
  EXPECT_FALSE(filled.contains("bust"));
  EXPECT_NEAR(filled.at("arm_length"), 1.1 * sample.at("arm_length"), 1e-9);
  EXPECT_NEAR(filled.at("upper_thigh"), 1.3 * sample.at("upper_thigh"), 1e-9);
  EXPECT_NEAR(filled.at("shoulder_angle"), sample.at("shoulder_angle"), 1e-9);
  EXPECT_EQ(filled.size() + 3, sample.size());
}

}  // namespace measure_errors_test
}  // namespace toile
