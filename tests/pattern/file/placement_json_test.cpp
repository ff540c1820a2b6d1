#include "pattern/file/placement_json.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "pattern/mesh/seam_orientation.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace placement_json_test {

using samples::error_of;
using samples::file;
using samples::polygon;

/// A rectangle 20 wide and 30 high, placed so.
std::string panel(const std::string& placement, const std::string& name = "p") {
  return polygon(name, "[0,0],[20,0],[20,30],[0,30]", "\"placement\": " + placement);
}

PatternPanel read(const std::string& placement) {
  return samples::parse(file(panel(placement))).panels[0];
}

std::string refusal(const std::string& placement) {
  return error_of([&] { read(placement); });
}

TEST(PlacementJson, ReadsEveryKeyInThePatternsUnit) {
  const PatternPanel whole = read(R"({"part": "left_leg", "side": "back", "around": 0.5,
      "axis": "-y", "turn": -30, "shift": 2, "offset": 7, "at": "hip", "level": 12})");
  EXPECT_EQ(whole.part, BodyPart::left_leg);
  const PanelPlacement expected = {
      PlacementSide::back, 0.5,       PlacementAxis::minus_y, -30, 0.02, 7 * 0.01,
      "left_hip",          -12 * 0.01};
  EXPECT_EQ(whole.placement, expected);
  EXPECT_TRUE(whole.placement.by_part());
  const PanelPlacement rolled = read(R"({"part": "right_arm", "around": true})").placement;
  EXPECT_EQ(rolled.around, 1);
  EXPECT_EQ(side_or_default(rolled, BodyPart::right_arm), PlacementSide::right);
  EXPECT_FALSE(read(R"({"part": "torso"})").placement.by_part());
  EXPECT_FALSE(read(R"({"part": "torso", "around": false})").placement.by_part());
}

TEST(PlacementJson, WhatIsWrittenIsReadTheSame) {
  const PanelPlacement placement = {
      PlacementSide::left, 1 / 3.0, PlacementAxis::minus_x, 12.3, -0.1, 1 / 7.0, "waist", 0.7};
  const JsonDocument document(placement_json(placement).dump(), "test.json");
  EXPECT_EQ(read_placement(document.root(), BodyPart::torso, 1), placement);
  EXPECT_EQ(placement_json({}).dump(), "{}");
}

TEST(PlacementJson, RefusesWhatMakesNoSense) {
  EXPECT_HOLDS(refusal(R"({"part": "tail"})"), "'tail' is no body part; use one of torso, head");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "side": "top"})"),
               "'top' is unknown; use one of front, back, left, right");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "side": ""})"), "is unknown");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "sied": "front"})"), "panel 'p'");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "sied": "front"})"), "unknown key 'sied'");
  EXPECT_HOLDS(refusal(R"({"side": "front"})"), "not at which body part");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "offset": 3})"), "add 'side' or 'around'");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "around": 1.5})"), "is not between 0 and 1");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "around": -1})"), "is not between 0 and 1");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "around": "yes"})"), "around");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "side": "front", "axis": "z"})"),
               "'z' is unknown; use one of y, -y, x, -x");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "side": "front", "offset": -1})"), "offset");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "side": "front", "offset": 500})"), "out of range");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "side": "front", "turn": 400})"), "full turn");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "side": "front", "at": "elbow"})"),
               "'elbow' is no joint; use one of pelvis, waist");
  EXPECT_HOLDS(refusal(R"({"part": "torso", "side": "front", "level": 3})"), "add 'at'");
}

TEST(PlacementJson, TranslationAndRotationBesideItAreSaidToBeUnused) {
  std::vector<Remark> remarks;
  parse_pattern(file(polygon("p", "[0,0],[20,0],[20,30]",
                             R"("translation": [1,2,3],
                                "placement": {"part": "torso", "side": "front"})")),
                "test.json", remarks);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_FALSE(remarks[0].warning);
  EXPECT_HOLDS(remarks[0].text, "panel 'p': 'translation' is not used");
}

TEST(PlacementJson, BesideTheSchematicFigurePanelsFaceOutAndUp) {
  struct Case {
    const char* placement;
    Vec3 out, up;
  };
  for (const Case& c : {Case{R"({"part": "torso", "side": "front"})", {0, 0, 1}, {0, 1, 0}},
                        Case{R"({"part": "torso", "side": "back"})", {0, 0, -1}, {0, 1, 0}},
                        Case{R"({"part": "left_arm", "around": true})", {1, 0, 0}, {0, 1, 0}},
                        Case{R"({"part": "right_leg", "around": true})", {-1, 0, 0}, {0, 1, 0}}}) {
    const PatternPanel p = read(c.placement);
    EXPECT_LT((p.rotation.col(2) - c.out).norm(), 1e-15) << c.placement;
    EXPECT_LT((p.rotation.col(1) - c.up).norm(), 1e-15) << c.placement;
    EXPECT_NEAR(p.rotation.determinant(), 1, 1e-15);
  }
  const PatternPanel across =
      read(R"({"part": "left_arm", "side": "front", "axis": "-x", "at": "shoulder", "level": 5})");
  EXPECT_LT((across.rotation.col(0) + Vec3::UnitY()).norm(), 1e-15);
  // The line x = 5 is level with the shoulder.
  EXPECT_NEAR(across.place({0.05, 0.1}).y(), 1.35, 1e-12);
  EXPECT_NEAR(across.place({0.05, 0.15}).x(), 0.45, 1e-12);
}

/// Seams and right sides are found without a translation: a front, a back and a sleeve rolled
/// between them, all drawn as seen from outside.
TEST(PlacementJson, SeamsFindTheirWayBesideTheSchematicFigure) {
  const std::string body = "[-20,0],[20,0],[20,30],[-20,30]";
  const Pattern pattern = samples::parse(
      file(polygon("front", body, R"("placement": {"part": "torso", "side": "front"})") + "," +
               polygon("back", body, R"("placement": {"part": "torso", "side": "back"})") + "," +
               polygon("sleeve", "[-15,0],[15,0],[20,30],[0,45],[-20,30]",
                       R"("placement": {"part": "left_arm", "around": true})"),
           R"([{"panel":"front","edge":1},{"panel":"back","edge":3}],
              [{"panel":"front","edge":2},{"panel":"back","edge":2}],
              [{"panel":"sleeve","edge":1},{"panel":"sleeve","edge":4}])"));
  std::vector<Remark> remarks;
  const Orientation orientation = orient(pattern, remarks);
  EXPECT_TRUE(remarks.empty());
  EXPECT_EQ(orientation.mirrored, std::vector<bool>(3, false));
  EXPECT_EQ(orientation.reversed, std::vector<bool>(3, true));
}

}  // namespace placement_json_test
}  // namespace toile
