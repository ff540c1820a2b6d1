#include "pattern/file/attachment_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/pattern/samples.h"

namespace toile {
namespace attachment_json_test {

using samples::error_of;
using samples::file;
using samples::polygon;

/// A rectangle 20 wide and 30 high with these entries of `attach`.
PatternPanel read(const std::string& entries) {
  return samples::parse(
             file(polygon("p", "[0,0],[20,0],[20,30],[0,30]", "\"attach\": [" + entries + "]")))
      .panels[0];
}

std::string refusal(const std::string& entries) {
  return error_of([&] { read(entries); });
}

TEST(AttachmentJson, ReadsEveryKeyInThePatternsUnit) {
  const PatternPanel panel = read(R"(
      {"edge": 2, "to": "bust", "above": -3, "while": "always", "stiffness_N_per_m": 700,
       "max_N": 12.5},
      {"vertex": 0, "to": "place"}, {"vertex": 3, "to": "skin"}, {"edge": 1, "to": [1, 150, -20]},
      {"edge": 0, "to": "left_wrist"})");
  using Share = PanelAttachment::Share;
  ASSERT_EQ(panel.attachments.size(), 5u);
  const PanelAttachment& bust = panel.attachments[0];
  EXPECT_EQ(bust.name, "2");
  EXPECT_EQ(bust.edge, 2);
  EXPECT_EQ(bust.share, Share::whole);
  const Attachment expected = {AttachedTo::level, "bust", -0.03, Vec3::Zero(), true, 700, 12.5};
  EXPECT_EQ(bust.how, expected);
  const PanelAttachment& corner = panel.attachments[1];
  EXPECT_EQ(corner.name, "v0");
  const Vec2 at = corner.share == Share::start ? panel.edges[corner.edge].curve.start()
                                               : panel.edges[corner.edge].curve.end();
  EXPECT_EQ(at, Vec2(0, 0));
  EXPECT_EQ(corner.how, Attachment());
  EXPECT_FALSE(corner.how.always);
  EXPECT_EQ(panel.attachments[2].how.to, AttachedTo::skin);
  EXPECT_EQ(panel.attachments[3].how.to, AttachedTo::point);
  EXPECT_LT((panel.attachments[3].how.point - Vec3(0.01, 1.5, -0.2)).norm(), 1e-15);
  EXPECT_EQ(panel.attachments[4].how.landmark, "left_wrist");
}

TEST(AttachmentJson, WhatIsWrittenIsReadTheSame) {
  for (const Attachment& attachment :
       {Attachment{AttachedTo::level, "hip", 1 / 3.0, Vec3::Zero(), true, 1 / 7.0, 1e4},
        Attachment{AttachedTo::skin, "", 0, Vec3::Zero(), false, 5000, 20},
        Attachment{AttachedTo::place, "", 0, Vec3::Zero(), true, 1, 2},
        Attachment{AttachedTo::height, "", 0, Vec3::Zero(), false, 5, 6, true},
        Attachment{AttachedTo::point, "", 0, Vec3(0.1, 1 / 3.0, -7), false, 3, 4}}) {
    const JsonDocument document(attachment_json(attachment).dump(), "test.json");
    EXPECT_EQ(read_attachment(document.root(), 1), attachment);
  }
}

TEST(AttachmentJson, RefusesWhatMakesNoSense) {
  const std::string place = "panel 'p', attach 0";
  EXPECT_HOLDS(refusal(R"({"edge": 2, "to": "belly"})"), place);
  EXPECT_HOLDS(refusal(R"({"edge": 2, "to": "belly"})"), "'belly' is unknown; use one of pelvis,");
  EXPECT_HOLDS(refusal(R"({"edge": 4, "to": "waist"})"),
               place + ": names edge 4, but the panel has edges 0 to 3");
  EXPECT_HOLDS(refusal(R"({"edge": -1, "to": "waist"})"), place);
  EXPECT_HOLDS(refusal(R"({"vertex": 4, "to": "waist"})"),
               place + ": names vertex 4, which no edge of the panel has");
  EXPECT_HOLDS(refusal(R"({"to": "waist"})"), place + ": names no edge and no vertex, or both");
  EXPECT_HOLDS(refusal(R"({"edge": 1, "vertex": 1, "to": "waist"})"),
               "names no edge and no vertex, or both");
  EXPECT_HOLDS(refusal(R"({"edge": 2})"), "'to'");
  EXPECT_HOLDS(refusal(R"({"edge": 2, "to": [1, 2]})"), place);
  EXPECT_HOLDS(refusal(R"({"edge": 2, "to": [1, 2, 3000]})"), "is more than 10 m");
  EXPECT_HOLDS(refusal(R"({"edge": 2, "to": "place", "above": 2})"), "names no level");
  EXPECT_HOLDS(refusal(R"({"edge": 2, "to": "waist", "while": "sewing"})"),
               "'sewing' is unknown; use one of dressing, always");
  EXPECT_HOLDS(refusal(R"({"edge": 2, "to": "waist", "whlie": "always"})"),
               "has an unknown key 'whlie'; use edge, vertex, to");
  EXPECT_HOLDS(refusal(R"({"edge": 2, "to": "waist", "stiffness_N_per_m": 0})"), "above 0");
  EXPECT_HOLDS(refusal(R"({"edge": 2, "to": "waist", "max_N": -1})"), "above 0");
}

}  // namespace attachment_json_test
}  // namespace toile
