#include "io/measure_names.h"

#include <gtest/gtest.h>

#include <set>

namespace toile {
namespace measure_names_test {

TEST(MeasureNames, EveryForeignNameStandsForKnownOnes) {
  for (const DraftingProgram program :
       {DraftingProgram::valentina, DraftingProgram::freesewing, DraftingProgram::garmentcode}) {
    std::set<std::string_view> foreign;
    std::set<std::string_view> alone;
    for (const ForeignMeasure& measure : foreign_measures(program)) {
      EXPECT_TRUE(foreign.insert(measure.name).second) << measure.name << " is there twice";
      ASSERT_FALSE(measure.terms.empty()) << measure.name;
      for (const MeasureTerm& term : measure.terms) {
        ASSERT_NE(find_measure_name(term.name), nullptr) << term.name;
      }
      if (measure.terms.size() == 1) {
        EXPECT_TRUE(alone.insert(measure.terms[0].name).second) << measure.terms[0].name;
      }
    }
  }
}

TEST(MeasureNames, GarmentCodeGetsMostOfItsBodyBlock) {
  EXPECT_GE(foreign_measures(DraftingProgram::garmentcode).size(), 18U);
}

TEST(MeasureNames, AreOneEach) {
  std::set<std::string_view> seen;
  for (const MeasureName& measure : measure_names()) EXPECT_TRUE(seen.insert(measure.name).second);
  EXPECT_EQ(find_measure_name("chest"), find_measure_name("bust"));
  EXPECT_EQ(find_measure_name("left_knee"), nullptr);
  EXPECT_EQ(find_measure_name("shoulder_angle")->unit, MeasureUnit::degrees);
}

}  // namespace measure_names_test
}  // namespace toile
