#include "pattern/seams/integer_programme.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

namespace toile {
namespace integer_programme_test {

// Three that exclude each other in pairs: in fractions each is half chosen, in whole numbers one
// is.
TEST(IntegerProgramme, ChoosesWholeVariables) {
  IntegerProgramme programme(1000);
  const int a = programme.add_variable(1);
  const int b = programme.add_variable(1.1);
  const int c = programme.add_variable(1);
  programme.add_at_most({{a, 1}, {b, 1}}, 1);
  programme.add_at_most({{b, 1}, {c, 1}}, 1);
  programme.add_at_most({{a, 1}, {c, 1}}, 1);
  const auto answer = programme.solve(10);
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->proved);
  EXPECT_NEAR(answer->worth, 1.1, 1e-9);
  EXPECT_EQ(answer->values, (std::vector<bool>{false, true, false}));
}

TEST(IntegerProgramme, FixedVariablesStay) {
  IntegerProgramme programme(1000);
  const int a = programme.add_variable(1);
  const int b = programme.add_variable(3);
  programme.add_at_most({{a, 1}, {b, 1}}, 1);
  programme.fix(a, true);
  const auto answer = programme.solve(10);
  ASSERT_TRUE(answer);
  EXPECT_NEAR(answer->worth, 1, 1e-9);
}

TEST(IntegerProgramme, RelaxedAnswerWithoutAVariableBoundsTheRest) {
  IntegerProgramme programme(1000);
  const int a = programme.add_variable(3);
  const int b = programme.add_variable(2);
  programme.add_at_most({{a, 1}, {b, 1}}, 1);
  const auto answer = programme.solve(10);
  ASSERT_TRUE(answer);
  EXPECT_NEAR(answer->worth, 3, 1e-9);
  EXPECT_NEAR(programme.relaxed_without({a}).worth, 2, 1e-9);
  EXPECT_NEAR(programme.relaxed_without({b}).worth, 3, 1e-9);
}

TEST(IntegerProgramme, SaysThatNothingMeetsTheConstraints) {
  IntegerProgramme programme(1000);
  const int a = programme.add_variable(1);
  programme.add_at_most({{a, -1}}, -2);
  EXPECT_FALSE(programme.solve(10));
}

TEST(IntegerProgramme, EndsWhenItsIterationsAreUsedUp) {
  // Pairs of a ring of eleven exclude each other.
  const auto ring = [](int max_iterations) {
    auto programme = std::make_unique<IntegerProgramme>(max_iterations);
    for (int i = 0; i < 11; ++i) programme->add_variable(1 + 0.01 * i);
    for (int i = 0; i < 11; ++i) programme->add_at_most({{i, 1}, {(i + 1) % 11, 1}}, 1);
    return programme;
  };
  ASSERT_TRUE(ring(1000)->solve(10));
  const auto cut_off = ring(3);
  EXPECT_FALSE(cut_off->solve(10));
  EXPECT_EQ(cut_off->relaxed_without({0}).worth, std::numeric_limits<double>::infinity());
}

}  // namespace integer_programme_test
}  // namespace toile
