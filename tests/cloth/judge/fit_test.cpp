#include "cloth/judge/fit.h"

#include <gtest/gtest.h>

namespace toile {
namespace fit_test {

GirthEase girth(const std::string& level, double body, double as_cut) {
  GirthEase girth;
  girth.level = level;
  girth.body = body;
  girth.as_cut = as_cut;
  return girth;
}

TEST(Fit, NamesTheLevelsAtWhichClothIsMissing) {
  const Fit fit = fit_of({girth("bust", 1.00, 0.90), girth("waist", 0.80, 0.795),
                          girth("", 0.80, 0.50), girth("hip", 1.00, 1.10)},
                         {}, {});
  EXPECT_EQ(to_string(fit), "too_small");
  ASSERT_EQ(fit.levels.size(), 1U);
  EXPECT_EQ(fit.levels[0].level, "bust");
  EXPECT_NEAR(fit.levels[0].missing(), 0.10, 1e-12);
  EXPECT_EQ(text_of(fit.levels[0]),
            "at the bust the garment is cut 10.0 cm smaller than the body, and stretched by that: "
            "90.0 cm around 100.0 cm");
  EXPECT_EQ(text_of(fit), "too_small, 10.0 cm missing at the bust");
  ASSERT_TRUE(fit.nearest);
  EXPECT_EQ(fit.nearest->level, "bust");
}

TEST(Fit, TheNearestLevelIsOfTheTrunk) {
  LimbEase arm;
  arm.limb = "left upper arm";
  arm.body = 0.30;
  arm.as_cut = 0.31;
  const Fit fit = fit_of({girth("bust", 1.00, 1.40), girth("waist", 0.80, 1.08)}, {}, {arm});
  ASSERT_TRUE(fit.nearest);
  EXPECT_EQ(fit.nearest->level, "waist");
  EXPECT_EQ(text_of(fit), "ok");
}

TEST(Fit, LevelsOfTheGarmentCountWhereTheyLieOnTheTrunk) {
  GarmentLevel seam;
  seam.name = "waist seam";
  seam.as_cut = 0.70;
  EXPECT_EQ(to_string(fit_of({}, {seam}, {})), "not_checked");
  seam.body = 0.72;
  EXPECT_EQ(to_string(fit_of({}, {seam}, {})), "too_small");
  seam.body = 0.705;
  EXPECT_EQ(to_string(fit_of({}, {seam}, {})), "ok");
}

TEST(Fit, ACuffThatIsSmallerThanTheForearmIsNamed) {
  LimbEase forearm;
  forearm.limb = "left forearm";
  forearm.body = 0.224;
  forearm.as_cut = 0.166;
  const Fit fit = fit_of({}, {}, {forearm});
  ASSERT_EQ(fit.levels.size(), 1U);
  EXPECT_EQ(fit.levels[0].level, "left forearm");
  forearm.as_cut = 0.3;
  EXPECT_EQ(to_string(fit_of({}, {}, {forearm})), "ok");
}

TEST(Fit, NothingMeasuredIsNotChecked) {
  EXPECT_EQ(to_string(fit_of({}, {}, {})), "not_checked");
  EXPECT_EQ(to_string(fit_of({girth("", 0.8, 0.5)}, {}, {})), "not_checked");
}

}  // namespace fit_test
}  // namespace toile
