#include "cloth/ease/ease_targets.h"

#include <gtest/gtest.h>

#include "geometry/error.h"
#include "tests/support/run_program.h"

namespace toile {
namespace ease_targets_test {

TargetFinding finding(double ease, double error) {
  return {"bust", ease, error, {"bust", 0.07, 0.10}};
}

TEST(EaseTargets, WordsOfAFitter) {
  EXPECT_EQ(finding(0.08, 0.003).word(), "as intended");
  EXPECT_EQ(finding(0.068, 0.003).word(), "close");
  EXPECT_EQ(finding(0.02, 0.003).word(), "too tight");
  EXPECT_EQ(finding(0.102, 0.003).word(), "loose");
  EXPECT_EQ(finding(0.15, 0.003).word(), "too wide");
  EXPECT_NEAR(finding(0.02, 0.003).off(), -0.05, 1e-12);
  EXPECT_EQ(text_of(finding(0.15, 0.003)),
            "too wide by 5.0 \xC2\xB1 0.3 cm at the bust: ease 15.0 cm, meant 7.0 to 10.0 cm");
}

TEST(EaseTargets, TooWideIsWhatHasOneLevelTooWideAndNoneTooTight) {
  const TargetFinding wide = finding(0.15, 0.003);
  const TargetFinding loose = finding(0.102, 0.003);
  const TargetFinding tight = finding(0.02, 0.003);
  EXPECT_TRUE(is_too_wide({loose, wide}));
  EXPECT_FALSE(is_too_wide({loose}));
  EXPECT_FALSE(is_too_wide({wide, tight}));
  EXPECT_FALSE(is_too_wide({}));
}

TEST(EaseTargets, TablesOfTheTrade) {
  for (const std::string& name : ease_target_names()) {
    EXPECT_EQ(read_ease_targets(name).name, name);
  }
  EXPECT_THROW(read_ease_targets("no such table"), Error);
}

TEST(EaseTargets, BothSidesAreCompared) {
  const EaseTargets targets{"own", {{"wrist", 0.01, 0.03}, {"top edge", 0, 0.02}}};
  Girth wrist;
  wrist.name = "left wrist";
  wrist.body = 0.16;
  wrist.as_cut = 0.22;
  wrist.garment = wrist.hull = 0.22;
  wrist.panels = {{3}, {5}};
  GarmentLevel edge;
  edge.name = "top edge";
  edge.as_cut = 0.75;
  edge.body = 0.80;
  edge.drafted = 1.02;
  edge.drafted_body = 0.74;
  const auto findings = compare_with_targets(targets, {wrist}, {edge});
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].level, "left wrist");
  EXPECT_NEAR(findings[0].off(), 0.03, 1e-12);
  EXPECT_EQ(findings[0].panels, (std::vector<int>{3, 5}));
  EXPECT_EQ(findings[1].word(), "as intended");  // where it was drafted to lie
}

class EaseTargetFile : public testing::Test {
 protected:
  EaseTargets read(const std::string& text) {
    pipeline::write_text(folder / "t.json", text);
    return read_ease_targets((folder / "t.json").string());
  }
  pipeline::ScratchFolder folder;
};

TEST_F(EaseTargetFile, OfOnesOwn) {
  const EaseTargets targets = read(R"({"name": "blouse", "ease_cm": {"bust": [7, 10.5]}})");
  EXPECT_EQ(targets.name, "blouse");
  ASSERT_EQ(targets.levels.size(), 1U);
  EXPECT_NEAR(targets.levels[0].most, 0.105, 1e-12);
}

TEST_F(EaseTargetFile, WhatIsNoRangeIsAnError) {
  for (const char* text :
       {"", "[]", R"({"name": "x"})", R"({"name": "x", "ease_cm": {"bust": [7]}})",
        R"({"name": "x", "ease_cm": {"bust": [10, 7]}})",
        R"({"name": "x", "ease_cm": {"bust": 7}})",
        R"({"name": "x", "ease_cm": {"bust": [0, 1e9]}})"}) {
    EXPECT_THROW(read(text), Error) << text;
  }
}

}  // namespace ease_targets_test
}  // namespace toile
