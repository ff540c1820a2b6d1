#include "io/measure_words.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/error.h"
#include "io/measures_file.h"

namespace toile {
namespace measure_words_test {

std::string name_of(const std::string& word) {
  const std::optional<MeasureWord> found = measure_of_word(word);
  return found ? found->side + std::string(found->measure.name) : "";
}

TEST(MeasureWords, PeopleAndProgramsAreUnderstood) {
  EXPECT_EQ(name_of("bust"), "bust");
  EXPECT_EQ(name_of("Inside leg"), "inside_leg");
  EXPECT_EQ(name_of("inside-leg length"), "inside_leg");
  EXPECT_EQ(name_of("Brustumfang"), "bust");
  EXPECT_EQ(name_of("Hüftumfang"), "hip");
  EXPECT_EQ(name_of("Hueftumfang"), "hip");
  EXPECT_EQ(name_of("tour de taille"), "waist");
  EXPECT_EQ(name_of("Tour de tête"), "head");
  EXPECT_EQ(name_of("hip girth"), "hip");
  EXPECT_EQ(name_of("neck circumference"), "neck");
  EXPECT_EQ(name_of("left knee girth"), "left_knee");
  EXPECT_EQ(name_of("lowbust_circ"), "underbust");
  EXPECT_EQ(name_of("hpsToBust"), "bust_depth");
  EXPECT_EQ(name_of("leg_circ"), "upper_thigh");
}

TEST(MeasureWords, PeopleWinOverPrograms) {
  EXPECT_EQ(name_of("neck_circ"), "neck") << "its base in Valentina";
  EXPECT_EQ(name_of("hips"), "hip") << "higher in FreeSewing";
}

TEST(MeasureWords, UnknownOnesAreNone) {
  EXPECT_EQ(name_of("wingspan"), "");
  EXPECT_EQ(name_of(""), "");
  EXPECT_EQ(name_of("umfang"), "");
  EXPECT_EQ(name_of("left bust"), "") << "it has no sides";
  EXPECT_EQ(name_of("head_l"), "") << "of two measures";
}

TEST(MeasureWords, AWidthOfBothSidesIsHalvedAndTold) {
  MeasureSet set;
  add_measure("Rückenbreite=36", 0.01, set);
  EXPECT_NEAR(set.values.at("across_back"), 0.18, 1e-12);
  EXPECT_EQ(set.taken_as.at("Rückenbreite"), "across_back");
  EXPECT_THROW(add_measure("across_back=18", 0.01, set), Error);
}

}  // namespace measure_words_test
}  // namespace toile
