#include "pattern/file/pattern_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "pattern/constants.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace pattern_file_test {

using samples::curved;
using samples::error_of;
using samples::file;
using samples::polygon;

std::string parse_error(const std::string& text) {
  return error_of([&] { samples::parse(text); });
}

std::vector<std::string> remarks_of(const std::string& text) {
  std::vector<Remark> remarks;
  parse_pattern(text, "test.json", remarks);
  std::vector<std::string> texts;
  for (const Remark& remark : remarks) texts.push_back(remark.text);
  return texts;
}

const std::string square = polygon("square", "[0,0],[20,0],[20,20],[0,20]");

TEST(PatternFile, ReadsCentimetresAsMetres) {
  const Pattern pattern = samples::parse(file(square));
  ASSERT_EQ(pattern.panels.size(), 1u);
  EXPECT_EQ(pattern.panels[0].name, "square");
  EXPECT_DOUBLE_EQ(pattern.panels[0].edges[0].curve.length(), 0.2);
  const Pattern inches = samples::parse(file(square, "", R"("units_in_meter": 39.37007874015748)"));
  EXPECT_NEAR(inches.panels[0].edges[0].curve.length(), 20 * 0.0254, 1e-15);
}

TEST(PatternFile, BothGenerationsOfCurvatureGiveTheSameCurve) {
  const Pattern old_spec = samples::parse(file(curved("[0.3, 0.2]")));
  const Pattern new_spec =
      samples::parse(file(curved(R"({"type": "quadratic", "params": [[0.3, 0.2]]})")));
  // Absolute control points are in the panel's drawing. The edge runs from (20, 20) to (0, 20), so
  // (0.3, 0.2) along and to the left of it is (14, 16).
  const Pattern absolute =
      samples::parse(file(curved(R"({"type": "quadratic", "params": [[14, 16]]})"), "",
                          R"("curvature_coords": "absolute", "units_in_meter": 100)"));
  const EdgeCurve& one = old_spec.panels[0].edges[2].curve;
  const EdgeCurve& two = new_spec.panels[0].edges[2].curve;
  const EdgeCurve& three = absolute.panels[0].edges[2].curve;
  for (const double f : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    EXPECT_EQ(one.at(f), two.at(f));
    EXPECT_TRUE(one.at(f).isApprox(three.at(f), 1e-12));
  }
  EXPECT_LT(one.at(0.5).y(), 0.2);
}

TEST(PatternFile, ReadsCubicsAndCircles) {
  const Pattern cubic =
      samples::parse(file(curved(R"({"type": "cubic", "params": [[0.25, 0.5], [0.75, 0.5]]})")));
  // By symmetry the middle is at 3/4 of the control points' height, left of the direction: below.
  EXPECT_TRUE(cubic.panels[0].edges[2].curve.at(0.5).isApprox(Vec2(0.1, 0.2 - 0.75 * 0.1), 1e-12));
  const Pattern circle =
      samples::parse(file(curved(R"({"type": "circle", "params": [10, 0, 1]})")));
  const EdgeCurve& half = circle.panels[0].edges[2].curve;
  EXPECT_NEAR(half.length(), std::numbers::pi * 0.1, 1e-12);
  // Right of the direction from (20,20) to (0,20) is up.
  EXPECT_TRUE(half.at(0.5).isApprox(Vec2(0.1, 0.3), 1e-12));
}

TEST(PatternFile, AChainOfCubicsIsOneEdge) {
  // Two cubics that are straight: up to (0.5, 0.3) of the edge's frame and down again.
  const Pattern chain = samples::parse(file(curved(
      R"({"type": "cubics", "params": [[0.1, 0.06], [0.3, 0.18], [0.5, 0.3], [0.7, 0.18], [0.9, 0.06]]})")));
  const EdgeCurve& edge = chain.panels[0].edges[2].curve;
  EXPECT_NEAR(edge.length(), 2 * 0.2 * std::hypot(0.5, 0.3), 1e-12);
  EXPECT_TRUE(edge.at(0.5).isApprox(Vec2(0.1, 0.2 - 0.3 * 0.2), 1e-9));
  EXPECT_HOLDS(
      parse_error(file(curved(R"({"type": "cubics", "params": [[0, 0], [1, 0], [2, 0]]})"))),
      "panel 'curved', edge 2, curvature, params: has 3 points instead of 2, 5, 8");
}

TEST(PatternFile, NotchesAndInnerLinesAreRead) {
  const std::string marked =
      polygon("p", "[0,0],[20,0],[20,20],[0,20]",
              R"("notches": [{"vertex": 2, "angle": 90}], "internal_lines": [[[1, 2], [3, 4]]],
         "cut_outs": [[[5, 5], [6, 5], [6, 6]]], "drill_holes": [[7, 8]], "material": "twill",
         "quantity": 2)");
  const PatternPanel panel = samples::parse(file(marked)).panels[0];
  ASSERT_EQ(panel.notches.size(), 1u);
  EXPECT_TRUE(panel.notches[0].at.isApprox(Vec2(0.2, 0.2)));
  EXPECT_NEAR(panel.notches[0].angle.value(), std::numbers::pi / 2, 1e-12);
  EXPECT_TRUE(panel.internal_lines.at(0).at(1).isApprox(Vec2(0.03, 0.04)));
  EXPECT_EQ(panel.cut_outs.at(0).size(), 3u);
  EXPECT_TRUE(panel.drill_holes.at(0).isApprox(Vec2(0.07, 0.08)));
  EXPECT_EQ(panel.material, "twill");
  EXPECT_EQ(panel.quantity, 2);
  EXPECT_HOLDS(
      parse_error(file(polygon("p", "[0,0],[20,0],[20,20]", R"("notches": [{"vertex": 3}])"))),
      "notch 0");
}

TEST(PatternFile, RotatesAboutFixedXThenYThenZ) {
  const Pattern pattern = samples::parse(file(polygon(
      "turned", "[0,0],[10,0],[10,10]", R"("translation": [1,2,3], "rotation": [90,0,90])")));
  // x to y by the turn about z; y to z by the one about x, which z then leaves alone.
  EXPECT_TRUE(pattern.panels[0].place({1, 0}).isApprox(Vec3(0.01, 1.02, 0.03), 1e-12));
  EXPECT_TRUE(pattern.panels[0].place({0, 1}).isApprox(Vec3(0.01, 0.02, 1.03), 1e-12));
}

TEST(PatternFile, NormalizedTranslationsPutTheOriginInTheMiddle) {
  const std::string properties = R"("units_in_meter": 100, "normalize_panel_translation": true)";
  const Pattern pattern = samples::parse(file(square, "", properties));
  EXPECT_TRUE(pattern.panels[0].edges[0].curve.start().isApprox(Vec2(-0.1, -0.1), 1e-12));
  EXPECT_NEAR(pattern.panels[0].place({-0.1, -0.1}).norm(), 0, 1e-12);
}

TEST(PatternFile, ReadsToilesOwnKeys) {
  const Pattern pattern = samples::parse(
      file(polygon("sleeve", "[0,0],[20,0],[20,20],[0,20]",
                   R"("placement": {"part": "left_arm"}, "grain": 45, "fabric": "denim")"),
           R"([{"panel":"sleeve","edge":1},{"panel":"sleeve","edge":3},
               {"name":"underarm","reversed":true}],
              [{"panel":"sleeve","edge":0},{"panel":"sleeve","edge":2},"right_wrong"])"));
  const PatternPanel& panel = pattern.panels[0];
  EXPECT_EQ(panel.part, BodyPart::left_arm);
  EXPECT_EQ(panel.fabric, "denim");
  EXPECT_DOUBLE_EQ(panel.grain, std::numbers::pi / 4);
  EXPECT_EQ(pattern.stitches[0].name, "underarm");
  EXPECT_EQ(pattern.stitches[0].direction, StitchDirection::end_to_start);
  EXPECT_EQ(pattern.stitches[1].direction, StitchDirection::start_to_start);
  EXPECT_HOLDS(
      parse_error(file(polygon("p", "[0,0],[1,0],[1,1]", R"("placement": {"part": "tail"})"))),
      "'tail' is no body part; use one of torso, head");
}

TEST(PatternFile, PanelsFollowThePanelOrder) {
  std::string text = file(square + "," + polygon("first", "[0,0],[1,0],[1,1]"));
  text.insert(text.find("\"panels\""), R"("panel_order": ["first", "square", "gone"], )");
  EXPECT_EQ(samples::parse(text).panels[0].name, "first");
}

TEST(PatternFile, EdgesMayBeListedInAnyOrderAndDirection) {
  const Pattern pattern = samples::parse(file(
      R"("p": {"vertices": [[0,0],[10,0],[10,10],[0,10]], "edges": [
        {"endpoints": [0,1]}, {"endpoints": [3,2]}, {"endpoints": [0,3]}, {"endpoints": [1,2]}]})"));
  const std::vector<OutlineStep>& walk = pattern.panels[0].outline;
  ASSERT_EQ(walk.size(), 4u);
  EXPECT_EQ(walk[1].edge, 3);
  EXPECT_TRUE(walk[1].forward);
  EXPECT_EQ(walk[2].edge, 1);
  EXPECT_FALSE(walk[2].forward);
}

TEST(PatternFile, ReportsWhatItDoesNotRead) {
  std::string text = file(polygon("p", "[0,0],[10,0],[10,10]", R"("colour": "red")"));
  const std::vector<std::string> remarks = remarks_of(text);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_EQ(remarks[0], "test.json: panel 'p': key 'colour' is not read");
  EXPECT_TRUE(remarks_of(file(square)).empty());
}

TEST(PatternFile, SaysWhereJsonBreaks) {
  EXPECT_HOLDS(parse_error("{\n\"pattern\": {,\n}"), "test.json:2:13: is not JSON here");
  EXPECT_HOLDS(parse_error(""), "test.json:1:1: is not JSON");
  for (const char* other : {"<?xml version=\"1.0\"?>\n<svg/>", "  0\nSECTION\n", "PK\x03\x04"}) {
    EXPECT_HOLDS(parse_error(other), "test.json: is no pattern that can be read");
  }
  EXPECT_HOLDS(parse_error("[1, 2]"), "has no 'pattern'");
  EXPECT_HOLDS(parse_error("{\"pattern\": 3}"), "pattern: is not an object");
}

TEST(PatternFile, NamesPanelAndEdgeOfWhatIsWrong) {
  EXPECT_HOLDS(parse_error(file("")), "holds no panel");
  EXPECT_HOLDS(parse_error(file(R"("p": {"vertices": [[0,0],[1,"x"]], "edges": []})")),
               "panel 'p', vertices[1][1]: is not a number");
  EXPECT_HOLDS(parse_error(file(R"("p": {"vertices": [[0,0],[1,0],[1,1]], "edges":
                 [{"endpoints":[0,1]},{"endpoints":[1,7]},{"endpoints":[2,0]}]})")),
               "panel 'p', edge 1: names vertex 7, but the panel has 3");
  EXPECT_HOLDS(parse_error(file(R"("p": {"vertices": [[0,0],[1,0],[1,1]], "edges":
                 [{"endpoints":[0,1]},{"endpoints":[1,2]}]})")),
               "panel 'p', edge 0: edges at vertex 0: 1, not 2");
  EXPECT_HOLDS(parse_error(file(R"("p": {"vertices": [[0,0],[1,0],[1,1]], "edges":
                 [{"endpoints":[0,1]},{"endpoints":[1,1]},{"endpoints":[1,0]}]})")),
               "edge 1: starts and ends at the same vertex");
  EXPECT_HOLDS(parse_error(file(R"("p": {"vertices": [[0,0],[1,0],[1,1],[5,5],[6,5],[6,6]],
                 "edges": [{"endpoints":[0,1]},{"endpoints":[1,2]},{"endpoints":[2,0]},
                 {"endpoints":[3,4]},{"endpoints":[4,5]},{"endpoints":[5,3]}]})")),
               "edge 3: belongs to a second loop");
  EXPECT_HOLDS(parse_error(file(curved(R"({"type": "spiral", "params": []})"))),
               "panel 'curved', edge 2, curvature, type: 'spiral' is unknown");
  EXPECT_HOLDS(parse_error(file(curved(R"({"type": "circle", "params": [-3, 0, 1]})"))),
               "panel 'curved', edge 2, curvature, params[0]: is no radius");
  EXPECT_HOLDS(parse_error(file(square, "", R"("units_in_meter": 0)")), "units_in_meter");
  EXPECT_HOLDS(parse_error(file(square, "", R"("curvature_coords": "polar")")), "'polar'");
  EXPECT_HOLDS(parse_error(file(polygon("p", "[0,0],[1e9,0],[1,1]"))), "check 'units_in_meter'");
}

TEST(PatternFile, TooManyPanelsEdgesAndStitchesAreRefusedAtOnce) {
  const std::string corners = "[0,0],[10,0],[10,10],[0,10]";
  std::string panels = polygon("p", corners);
  for (int i = 0; i < max_panels; ++i)
    panels.append(",").append(polygon(std::to_string(i), corners));
  EXPECT_HOLDS(parse_error(file(panels)), "pattern, panels: has 1001 panels, more than 1000");
  std::string teeth = "[-1,0]";
  for (int i = 0; i < max_panel_edges; ++i) {
    teeth.append(",[").append(std::to_string(i)).append(i % 2 == 0 ? ",0]" : ",1]");
  }
  EXPECT_HOLDS(parse_error(file(polygon("p", teeth))), "panel 'p': has 2001 edges, more than 2000");
  std::string stitches = "[]";
  for (int i = 0; i < max_stitches; ++i) stitches.append(",[]");
  EXPECT_HOLDS(parse_error(file(polygon("p", corners), stitches)), "has 20001 stitches");
}

TEST(PatternFile, StitchesNameWhatIsMissing) {
  EXPECT_HOLDS(
      parse_error(file(square, R"([{"panel":"square","edge":0},{"panel":"back","edge":2}])")),
      "stitch 0: names panel 'back' (edge 2), which the pattern does not have");
  EXPECT_HOLDS(
      parse_error(file(square, R"([{"panel":"square","edge":0},{"panel":"square","edge":9}])")),
      "stitch 0: names edge 9 of panel 'square', which has edges 0 to 3");
  EXPECT_HOLDS(
      parse_error(file(square, R"([{"panel":"square","edge":0},{"panel":"square","edge":-1}])")),
      "stitch 0: names edge -1 of panel 'square', which has edges 0 to 3");
  EXPECT_HOLDS(
      parse_error(file(square, R"([{"panel":"square","edge":1e10},{"panel":"square","edge":1}])")),
      "stitch 0: names edge 1e+10 of panel 'square', which has edges 0 to 3");
  EXPECT_HOLDS(
      parse_error(file(square, R"([{"panel":"square","edge":0},{"panel":"square","edge":1.5}])")),
      "stitch 0, side 1, edge: is not a whole number");
  EXPECT_HOLDS(parse_error(file(square, R"([{"panel":"square","edge":0}])")), "stitch 0");
}

TEST(PatternFile, AShortRadiusIsTakenAsHalfTheChordAndSaid) {
  const auto remarks = remarks_of(file(curved(R"({"type": "circle", "params": [8, 0, 1]})")));
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_HOLDS(remarks[0], "panel 'curved', edge 2: the circle's radius is too short");
}

TEST(PatternFile, MutatedFilesAreReadOrRefusedButNeverCrash) {
  std::mt19937 random(3);
  const std::string alphabet = "{}[]\",:0123456789.-eE\\ntruefalse \xc3\x01";
  int read = 0;
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = samples::bag;
    const int edits = 1 + static_cast<int>(random() % 4);
    for (int e = 0; e < edits; ++e) {
      const std::size_t at = random() % text.size();
      const char c = alphabet[random() % alphabet.size()];
      switch (random() % 5) {
        case 0:
          text[at] = c;
          break;
        case 1:
          text.insert(at, 1, c);
          break;
        case 2:
          text.erase(at, 1);
          break;
        case 3: {
          // Numbers for numbers keep the file's form and break its meaning.
          const std::size_t digit = text.find_first_of("0123456789", at);
          if (digit != std::string::npos) text[digit] = static_cast<char>('0' + random() % 10);
          break;
        }
        default:
          text.erase(at, 1 + random() % 30);
      }
    }
    try {
      std::vector<Remark> remarks;
      const Pattern pattern = parse_pattern(text, "mutant.json", remarks);
      check_pattern(pattern, remarks);
      const PanelMesh garment = mesh_panels(pattern, {0.05, -1}, remarks);
      ++read;
      for (const Vec2& point : garment.flat) ASSERT_TRUE(point.allFinite());
      for (const Vec3& point : garment.placed) ASSERT_TRUE(point.allFinite());
      for (const MeshedSeam& seam : garment.seams) ASSERT_EQ(seam.a.size(), seam.b.size());
    } catch (const Error& error) {
      ++refused;
      ASSERT_FALSE(std::string(error.what()).empty());
    }
  }
  EXPECT_GT(read, 150);
  EXPECT_GT(refused, 250);
}

TEST(PatternFile, ElasticsAreRead) {
  const auto elastic = [](const std::string& keys) {
    const std::string panel = R"("p": {"vertices": [[0,0],[20,0],[0,20]], "edges": [
        {"endpoints": [0,1], "elastic": {)" +
                              keys + R"(}}, {"endpoints": [1,2]}, {"endpoints": [2,0]}]})";
    return samples::parse(samples::file(panel)).panels[0].edges;
  };
  const auto edges = elastic(R"("ratio": 0.6, "stiffness_N": 12)");
  ASSERT_TRUE(edges[0].elastic);
  EXPECT_EQ(edges[0].elastic->ratio, 0.6);
  EXPECT_EQ(edges[0].elastic->stiffness, 12);
  EXPECT_FALSE(edges[1].elastic);
  EXPECT_EQ(elastic(R"("ratio": 1)")[0].elastic->stiffness, 20);
  for (const char* keys :
       {"", R"("ratio": 0)", R"("ratio": 1.2)", R"("ratio": 0.5, "stiffness_N": 0)",
        R"("ratio": 0.5, "stiffness_N": -3)"}) {
    EXPECT_HOLDS(samples::error_of([&] { elastic(keys); }), "panel 'p', edge 0") << keys;
  }
}

}  // namespace pattern_file_test
}  // namespace toile
