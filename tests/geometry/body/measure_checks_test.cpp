#include "geometry/body/measure_checks.h"

#include <gtest/gtest.h>

#include "geometry/body/body_proportions.h"
#include "geometry/error.h"

namespace toile {
namespace measure_checks_test {

bool names(const std::vector<std::string>& found, const std::string& a, const std::string& b) {
  for (const std::string& line : found) {
    if (line.find(a) != std::string::npos && line.find(b) != std::string::npos) return true;
  }
  return false;
}

TEST(MeasureChecks, NameTheMeasuresThatDisagree) {
  EXPECT_TRUE(names(contradictions({{"bust", 0.20}}), "bust 20 cm", "not within"));
  EXPECT_TRUE(
      names(contradictions({{"waist", 1.40}, {"hip", 1.00}}), "waist 140 cm", "hip 100 cm"));
  EXPECT_TRUE(
      names(contradictions({{"waist_height", 1.30}, {"hip_height", 0.80}}), "hip_height", "waist"));
  EXPECT_TRUE(
      names(contradictions({{"height", 1.7}, {"waist_to_hip", 0.40}}), "waist_to_hip", "height"));
  EXPECT_TRUE(names(contradictions({{"crotch_height", 0.78}, {"inside_leg", 0.70}}), "inside_leg",
                    "crotch_height"));
  EXPECT_TRUE(
      contradictions({{"height", 1.7}, {"bust", 0.94}, {"waist", 0.71}, {"hip", 0.98}}).empty());
}

// A crotch depth taken on a chair is less than what the leg leaves of the height of the waist.
// Neither measure is wrong.
TEST(MeasureChecks, LevelsThatWereDerivedContradictNoSum) {
  const MeasureValues given = {{"waist_to_floor", 1.184}, {"inside_leg", 0.790},
                               {"crotch_depth", 0.352},   {"waist_to_knee", 0.662},
                               {"bust", 1.053},           {"hip", 1.052}};
  const MeasureValues filled = filled_measures(given, FigureType::man);
  EXPECT_DOUBLE_EQ(filled.at("crotch_height"), 0.790);
  EXPECT_TRUE(contradictions(given, filled).empty());
  MeasureValues wrong = given;
  wrong["inside_leg"] = 0.70;
  EXPECT_TRUE(names(contradictions(wrong, filled_measures(wrong, FigureType::man)),
                    "inside_leg 70 cm", "crotch_depth 35.2 cm"));
}

// What is filled in contradicts nothing, from a small child to a large adult.
TEST(MeasureChecks, FilledMeasuresAgree) {
  struct Person {
    FigureType figure;
    double height, bust, hip;
  };
  for (const Person& p :
       {Person{FigureType::child, 0.98, 0.55, 0.57}, Person{FigureType::child, 1.4, 0.7, 0.75},
        Person{FigureType::woman, 1.5, 0.76, 0.84}, Person{FigureType::woman, 1.8, 1.4, 1.45},
        Person{FigureType::man, 1.6, 0.84, 0.88}, Person{FigureType::man, 2.0, 1.4, 1.35}}) {
    MeasureValues given = {{"height", p.height}, {"bust", p.bust}, {"hip", p.hip}};
    const MeasureValues filled = filled_measures(given, p.figure);
    given.insert(filled.begin(), filled.end());
    for (const std::string& line : contradictions(given)) ADD_FAILURE() << p.height << ": " << line;
    EXPECT_GT(filled.at("waist"), 0.4 * p.hip);
  }
}

TEST(BodyProportions, NeedThreeMeasuresAndTakeCups) {
  EXPECT_THROW(filled_measures({{"height", 1.7}, {"bust", 0.9}}, FigureType::woman), Error);
  EXPECT_THROW(filled_measures({{"bust", 0.9}, {"hip", 0.9}}, FigureType::woman), Error);
  // FreeSewing has no height: the waist's stands for it.
  const MeasureValues by_waist =
      filled_measures({{"waist_to_floor", 1.054}, {"bust", 0.9}, {"hip", 0.95}}, FigureType::woman);
  EXPECT_NEAR(by_waist.at("height"), 1.70, 1e-9);
  EXPECT_NEAR(underbust_of_cup(0.92, "B"), 0.77, 1e-12);
  EXPECT_THROW(underbust_of_cup(0.92, "Z"), Error);
}

}  // namespace measure_checks_test
}  // namespace toile
