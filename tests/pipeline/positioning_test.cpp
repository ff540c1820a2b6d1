// Garments that say only where on the body their panels belong, from pattern to verdict.
#include <gtest/gtest.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace positioning_test {

using Json = nlohmann::json;

/// Mirrors a drawing: x to -x, and the side that its curves bulge to.
void mirror(Json& panel) {
  for (Json& vertex : panel["vertices"]) vertex[0] = -vertex[0].get<double>();
  for (Json& edge : panel["edges"]) {
    if (!edge.contains("curvature")) continue;
    for (Json& control : edge["curvature"]["params"]) control[1] = -control[1].get<double>();
  }
}

/// The sample T-shirt without a translation or rotation: its body flat, its sleeves in one piece
/// and rolled, their halves joined along the overarm.
Json tshirt_by_part() {
  Json file = Json::parse(read_text(sample("tshirt")));
  Json& panels = file["pattern"]["panels"];
  for (auto& [name, panel] : panels.items()) {
    panel.erase("translation");
    panel.erase("rotation");
    const bool front = name.find("front") != std::string::npos;
    const bool left = name.starts_with("left");
    panel["placement"]["side"] = front ? "front" : "back";
    panel["placement"]["turn"] = front == left ? 40 : -40;
    // The backs are drawn as seen through the front.
    if (!front) mirror(panel);
  }
  for (const std::string side : {"left", "right"}) {
    const Json& front = panels[side + "_sleeve_f"];
    const Json& back = panels[side + "_sleeve_b"];
    const double out = side == "left" ? 1 : -1;
    // Turned so that the shoulder is above; as seen from outside, a left sleeve's front is left.
    const auto upright = [&](const Json& half, int vertex) {
      const Json& at = half["vertices"][vertex];
      return Json{out * std::abs(at[1].get<double>()) * (&half == &front ? -1 : 1),
                  -std::abs(at[0].get<double>())};
    };
    const bool left = side == "left";
    const int front_edges[] = {left ? 0 : 3, left ? 1 : 2};  // cap, underarm
    const int back_edges[] = {left ? 3 : 0, left ? 2 : 1};
    Json sleeve;
    sleeve["placement"] = {{"part", side + "_arm"}, {"around", true}};
    sleeve["vertices"] = {upright(front, 0), upright(front, left ? 1 : 3), upright(front, 2),
                          upright(back, 2), upright(back, left ? 3 : 1)};
    const auto cap = [&](const Json& half, int edge, int from, int to) {
      Json joined = {{"endpoints", {from, to}}, {"curvature", half["edges"][edge]["curvature"]}};
      // The back halves are drawn as seen through the front.
      if (&half == &back) {
        for (Json& control : joined["curvature"]["params"]) {
          control[1] = -control[1].get<double>();
        }
      }
      return joined;
    };
    sleeve["edges"] = {cap(front, front_edges[0], left ? 0 : 1, left ? 1 : 0),
                       {{"endpoints", {1, 2}}},
                       {{"endpoints", {2, 3}}},
                       {{"endpoints", {3, 4}}},
                       cap(back, back_edges[0], left ? 4 : 0, left ? 0 : 4)};
    Json stitches = Json::array();
    for (Json stitch : file["pattern"]["stitches"]) {
      if (stitch[2]["name"] == side + " overarm") continue;
      for (int i = 0; i < 2; ++i) {
        Json& ref = stitch[i];
        if (ref["panel"] == side + "_sleeve_f") {
          ref = {{"panel", side + "_sleeve"}, {"edge", ref["edge"] == front_edges[0] ? 0 : 1}};
        } else if (ref["panel"] == side + "_sleeve_b") {
          ref = {{"panel", side + "_sleeve"}, {"edge", ref["edge"] == back_edges[0] ? 4 : 3}};
        }
      }
      stitches.push_back(stitch);
    }
    file["pattern"]["stitches"] = stitches;
    panels[side + "_sleeve"] = sleeve;
    panels.erase(side + "_sleeve_f");
    panels.erase(side + "_sleeve_b");
  }
  return file;
}

/// Knee-length trousers in two panels, each rolled around a leg: centimetres, y above the ground.
Json trousers() {
  Json file;
  for (const std::string side : {"left", "right"}) {
    Json panel;
    panel["vertices"] = Json::parse(
        "[[-18.5,105],[-25.5,86],[-30.5,75],[-24,42],[27,42],[34.5,75],[25.5,86],[18.5,106.5]]");
    for (int i = 0; i < 8; ++i) panel["edges"].push_back({{"endpoints", {i, (i + 1) % 8}}});
    panel["edges"][1]["curvature"] =
        Json::parse(R"({"type": "quadratic", "params": [[0.72, -0.33]]})");
    panel["edges"][5]["curvature"] =
        Json::parse(R"({"type": "quadratic", "params": [[0.42, -0.36]]})");
    if (side == "right") mirror(panel);
    panel["placement"] = {
        {"part", side + "_leg"}, {"around", true}, {"at", "pelvis"}, {"level", 76}};
    file["pattern"]["panels"][side] = panel;
    file["pattern"]["stitches"].push_back(
        {{{"panel", side}, {"edge", 2}}, {{"panel", side}, {"edge", 4}}});
  }
  for (const int edge : {0, 1, 5, 6}) {
    file["pattern"]["stitches"].push_back(
        {{{"panel", "left"}, {"edge", edge}}, {{"panel", "right"}, {"edge", edge}}});
  }
  file["properties"]["units_in_meter"] = 100;
  return file;
}

class Positioned : public WornSample {
 protected:
  // The mannequin comes clean, with its joints.
  void SetUp() override { make_body("14mm"); }

  /// The report of a dressing that ends well.
  Json dress(const Json& pattern, const std::string& edge_length) {
    write_text(folder / "pattern.json", pattern.dump());
    mesh(folder / "pattern.json", edge_length);
    const pipeline::Run done = WornSample::dress("dressed");
    EXPECT_EQ(done.exit_code, 0) << done.err;
    const Json said = report("dressed");
    EXPECT_EQ(said["verdict"], "sewn");
    EXPECT_EQ(said["scene"]["points_inside_at_start"], 0);
    EXPECT_EQ(said["intersections"]["self"], 0);
    for (const Json& wrap : said["wraps"]) EXPECT_GE(wrap["fraction"], 0.97) << wrap;
    for (const Json& panel : said["scene"]["positioned"]) std::cout << panel << "\n";
    return said;
  }
};

TEST_F(Positioned, ATshirtOfFlatPanelsAndRolledSleeves) {
  // Edges of 20 mm are strained in folds as fine as they are, by what they can't follow.
  const Json said = dress(tshirt_by_part(), "15mm");
  ASSERT_EQ(said["scene"]["positioned"].size(), 6U);
  EXPECT_EQ(said["wraps"].size(), 3U);
  EXPECT_EQ(said["borders"], 4);
  EXPECT_LE(said["strain_off_seams"]["p99"], 0.015);
  for (const Json& panel : said["scene"]["positioned"]) {
    const bool sleeve = panel["panel"].get<std::string>().ends_with("sleeve");
    EXPECT_EQ(panel["rolled"], sleeve) << panel;
    // 40.4 cm around, wider than the arm: no gap is needed.
    if (!sleeve) continue;
    EXPECT_NEAR(panel["radius_mm"].get<double>(), 404.46 / (2 * 3.14159265), 0.5);
    EXPECT_NEAR(panel["gap_mm"].get<double>(), 0, 1e-9);
  }
}

TEST_F(Positioned, TrousersRolledAroundTheLegs) {
  const Json said = dress(trousers(), "20mm");
  ASSERT_EQ(said["scene"]["positioned"].size(), 2U);
  EXPECT_EQ(said["wraps"].size(), 2U);
  EXPECT_EQ(said["borders"], 3);
  // A tube of the thigh's width does not hold half of the hips: it is widened, and open.
  for (const Json& panel : said["scene"]["positioned"]) {
    EXPECT_EQ(panel["points_too_near"], 0);
    EXPECT_GT(panel["gap_mm"], 50);
  }
  // And without a skeleton nothing says where the legs are.
  fs::remove(folder / "body.body.json");
  const fs::path nothing = folder / "nothing.obj";
  const pipeline::Run done = run("dress", {"--body", body, garment, "-o", nothing});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("panel 'left'"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("--skeleton"), std::string::npos) << done.err;
  EXPECT_FALSE(fs::exists(nothing));
}

}  // namespace positioning_test
}  // namespace toile::pipeline
