#include "cloth/judge/fit.h"

#include <gtest/gtest.h>

namespace toile {
namespace fit_test {

Girth girth(const std::string& name, double body, double as_cut) {
  Girth girth;
  girth.name = name;
  girth.is_of_trunk = true;
  girth.garment = girth.hull = body;
  girth.body = body;
  girth.as_cut = girth.on_the_line = as_cut;
  return girth;
}

TEST(Fit, NamesTheLevelsAtWhichClothIsMissing) {
  const Fit fit = fit_of({girth("bust", 1.00, 0.90), girth("waist", 0.80, 0.795),
                          girth("", 0.80, 0.50), girth("hip", 1.00, 1.10)},
                         {});
  EXPECT_EQ(to_string(fit), "too_small");
  ASSERT_EQ(fit.levels.size(), 1U);
  EXPECT_EQ(fit.levels[0].level, "bust");
  EXPECT_NEAR(fit.levels[0].missing(), 0.10, 1e-12);
  EXPECT_EQ(text_of(fit.levels[0]),
            "at the bust the garment is cut 10.0 \xC2\xB1 0.5 cm smaller than the body, and "
            "stretched by that: "
            "90.0 cm around 100.0 cm");
  EXPECT_EQ(text_of(fit), "too_small, 10.0 cm missing at the bust");
  ASSERT_TRUE(fit.nearest);
  EXPECT_EQ(fit.nearest->level, "bust");
}

TEST(Fit, TheNearestLevelIsOfTheTrunk) {
  Girth arm = girth("left upper arm", 0.30, 0.31);
  arm.is_of_trunk = false;
  const Fit fit = fit_of({girth("bust", 1.00, 1.40), girth("waist", 0.80, 1.08), arm}, {});
  ASSERT_TRUE(fit.nearest);
  EXPECT_EQ(fit.nearest->level, "waist");
  EXPECT_EQ(text_of(fit), "ok");
}

TEST(Fit, LevelsOfTheGarmentCountWhereTheyLieOnTheTrunk) {
  GarmentLevel seam;
  seam.name = "waist seam";
  seam.as_cut = 0.70;
  seam.panels = {0, 2};
  EXPECT_EQ(to_string(fit_of({}, {seam})), "not_checked");
  seam.body = 0.72;
  EXPECT_EQ(to_string(fit_of({}, {seam})), "too_small");
  EXPECT_EQ(fit_of({}, {seam}).levels.at(0).panels, seam.panels);
  seam.body = 0.705;
  EXPECT_EQ(to_string(fit_of({}, {seam})), "ok");
}

TEST(Fit, AWaistSeamIsWideForTheWaistWhereverItHangs) {
  GarmentLevel seam;
  seam.name = "waist seam";
  seam.as_cut = 1.14;
  seam.body = 1.01;  // at the hip, where it slid to
  seam.waist = 0.84;
  const Fit fit = fit_of({}, {seam});
  EXPECT_EQ(text_of(fit), "ok");
  ASSERT_TRUE(fit.nearest);
  EXPECT_NEAR(fit.nearest->body, 0.84, 1e-12);
  // What is cut small is told where it lies.
  seam.as_cut = 0.95;
  EXPECT_NEAR(fit_of({}, {seam}).levels.at(0).body, 1.01, 1e-12);
}

TEST(Fit, ACuffThatIsSmallerThanTheForearmIsNamed) {
  GarmentLevel cuff;
  cuff.name = "left cuff";
  cuff.is_of_limb = true;
  cuff.body = 0.224;
  cuff.as_cut = 0.166;
  const Fit fit = fit_of({}, {cuff});
  ASSERT_EQ(fit.levels.size(), 1U);
  EXPECT_EQ(fit.levels[0].level, "left cuff");
  cuff.as_cut = 0.3;
  EXPECT_EQ(to_string(fit_of({}, {cuff})), "ok");
}

TEST(Fit, NothingMeasuredIsNotChecked) {
  EXPECT_EQ(to_string(fit_of({}, {})), "not_checked");
  EXPECT_EQ(to_string(fit_of({girth("", 0.8, 0.5)}, {})), "not_checked");
}

TEST(Fit, AnEdgeThatRodeUpIsComparedWhereItWasDraftedToLie) {
  GarmentLevel hem;
  hem.name = "hem";
  hem.height = 0.906;
  hem.as_cut = 0.92;
  hem.body = 0.93;
  EXPECT_EQ(to_string(fit_of({}, {hem})), "too_small");
  hem.drafted = 0.863;
  hem.drafted_body = 0.979;
  hem.drafted_body_error = 0.002;
  const Fit fit = fit_of({}, {hem});
  ASSERT_EQ(fit.levels.size(), 1U);
  EXPECT_NEAR(fit.levels[0].missing(), 0.059, 1e-12);
  EXPECT_EQ(text_of(fit.levels[0]),
            "at the hem the garment is cut 5.9 \xC2\xB1 0.2 cm smaller than the body where it was "
            "drafted to "
            "lie, 86.3 cm above the floor, and hangs 4.3 cm higher: 92.0 cm around 97.9 cm");
}

TEST(Fit, LegsThatStandApartAreNoReason) {
  Girth knee = girth("knee", 0.81, 0.75);
  knee.is_of_trunk = false;
  EXPECT_EQ(to_string(fit_of({knee}, {})), "too_small");
  knee.is_of_both_legs = true;
  EXPECT_EQ(to_string(fit_of({knee}, {})), "not_checked");
}

TEST(Fit, ATopEdgeCountsWhereItLacksTheLeast) {
  GarmentLevel edge;
  edge.name = "top edge";
  edge.as_cut = 0.84;
  edge.body = 0.842;
  edge.drafted = 1.07;
  edge.drafted_body = 0.86;
  EXPECT_EQ(to_string(fit_of({}, {edge})), "ok");
  edge.body = 0.88;
  EXPECT_NEAR(fit_of({}, {edge}).levels.at(0).missing(), 0.02, 1e-12);
}

TEST(Fit, AFoldIsNoLevel) {
  Girth fold = girth("waist", 0.80, 0.50);
  fold.garment = 1.4 * fold.hull;
  EXPECT_EQ(to_string(fit_of({fold}, {})), "not_checked");
}

}  // namespace fit_test
}  // namespace toile
