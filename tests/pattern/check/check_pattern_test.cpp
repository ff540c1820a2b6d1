#include "pattern/check/check_pattern.h"

#include <gtest/gtest.h>

#include "tests/pattern/samples.h"

namespace toile {
namespace check_pattern_test {

using samples::curved;
using samples::error_of;
using samples::file;
using samples::polygon;

std::string check_error(const std::string& text) {
  return error_of([&] {
    std::vector<Remark> remarks;
    check_pattern(samples::parse(text), remarks);
  });
}

/// Two squares, the second's sides `length` cm instead of 20, sewn at edge 1.
std::vector<Remark> seam_remarks(double length, const std::string& how = "") {
  const std::string l = std::to_string(length);
  std::vector<Remark> remarks;
  check_pattern(
      samples::parse(file(polygon("a", "[0,0],[20,0],[20,20],[0,20]") + "," +
                              polygon("b", "[0,0],[20,0],[20," + l + "],[0," + l + "]"),
                          R"([{"panel":"a","edge":1},{"panel":"b","edge":3})" + how + "]")),
      remarks);
  return remarks;
}

TEST(Check, ASoundPatternPasses) {
  std::vector<Remark> remarks;
  check_pattern(samples::parse(samples::bag), remarks);
  // The side seams are 40 and 41 cm long, 2.5 % apart; the bottom is the same curve twice.
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_FALSE(remarks[0].warning);
}

TEST(Check, AnOutlineThatCrossesItselfNamesBothEdges) {
  EXPECT_EQ(check_error(file(polygon("bow", "[0,0],[10,10],[10,0],[0,10]"))),
            "test.json: panel 'bow', edge 0: crosses or touches edge 2; an outline must not meet "
            "itself; correct the vertices or the curvature");
  // Touching is crossing too: a vertex in the middle of another edge.
  EXPECT_HOLDS(check_error(file(polygon("pinch", "[0,0],[10,0],[10,10],[5,0],[0,10]"))),
               "crosses or touches");
  // A spike that folds back on itself encloses nothing.
  EXPECT_HOLDS(check_error(file(polygon("spike", "[0,0],[10,0],[20,0],[10,0],[5,8]"))),
               "panel 'spike'");
}

TEST(Check, ProgramsThatMeshNothingWarnOfEachSuchOutline) {
  const std::string square = polygon("square", "[0,0],[20,0],[20,20],[0,20]");
  const std::string bow = polygon("bow", "[0,0],[10,10],[10,0],[0,10]");
  std::vector<Remark> remarks;
  warn_of_outlines(samples::parse(file(square)), remarks);
  EXPECT_TRUE(remarks.empty());
  Pattern pattern = samples::parse(
      file(square + "," + bow + "," + polygon("spike", "[0,0],[10,0],[20,0],[10,0],[5,8]")));
  warn_of_outlines(pattern, remarks);
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_TRUE(remarks[0].warning);
  EXPECT_HOLDS(remarks[0].text, "panel 'bow', edge 0: crosses or touches edge 2");
  EXPECT_HOLDS(remarks[0].text, "mesh-pattern refuses it");
  EXPECT_HOLDS(remarks[1].text, "panel 'spike'");
  // Nobody meshes what the garment is sewn without.
  for (PatternPanel& panel : pattern.panels) panel.left_out = "asked for";
  remarks.clear();
  warn_of_outlines(pattern, remarks);
  EXPECT_TRUE(remarks.empty());
}

TEST(Check, CurvesAreFollowedIntoACrossing) {
  // Straight, the square is simple; its curved top dips through the bottom edge.
  EXPECT_HOLDS(check_error(file(curved("[0.5, 2.5]"))), "panel 'curved', edge 0: crosses");
  EXPECT_EQ(check_error(file(curved("[0.5, 1.5]"))), "");
  EXPECT_HOLDS(
      check_error(file(curved(R"({"type": "cubic", "params": [[2.5, -1.5], [-1.5, -1.5]]})"))),
      "edge 2: crosses itself");
}

// Of no length at all, an edge is merged: see short_edges_test.cpp.
TEST(Check, AnEdgeThatEndsWhereItStartsIsNamed) {
  EXPECT_HOLDS(
      check_error(
          R"({"pattern": {"panels": {"p": {"vertices": [[0,0],[10,0],[10,0],[5,8]], "edges": [
              {"endpoints": [0,1]}, {"endpoints": [1,2], "curvature": [14,3]},
              {"endpoints": [2,3]}, {"endpoints": [3,0]}]}}},
              "properties": {"curvature_coords": "absolute", "units_in_meter": 100}})"),
      "panel 'p', edge 1: ends where it starts; split it in two");
}

// Such teeth are meshed for minutes, and then refused: no triangle fits into them.
TEST(Check, ACornerLikeANeedleNamesBothEdges) {
  EXPECT_HOLDS(check_error(file(polygon("p", "[0,0],[10,0],[10,10],[9.8,0.2],[0,0.2]"))),
               "panel 'p', edge 1: meets edge 2 at 1.2 degrees");
  // Outside of the cloth a corner may be as sharp as a cut: edges 1 and 2 are a slit.
  EXPECT_EQ(check_error(file(polygon("p", "[0,0],[10,0],[5,8],[10.1,0],[12,0],[12,10],[0,10]"))),
            "");
}

TEST(Check, AnEdgeIsSewnOnce) {
  const std::string panels = polygon("a", "[0,0],[20,0],[20,20],[0,20]") + "," +
                             polygon("b", "[0,0],[20,0],[20,20],[0,20]");
  EXPECT_HOLDS(check_error(file(panels, R"([{"panel":"a","edge":1},{"panel":"b","edge":3}],
                                           [{"panel":"a","edge":2},{"panel":"b","edge":3}])")),
               "panel 'b', edge 3: is in stitches 0 and 1");
  EXPECT_HOLDS(check_error(file(panels, R"([{"panel":"a","edge":1},{"panel":"a","edge":1}])")),
               "panel 'a', edge 1: stitch 0 sews it to itself");
  EXPECT_HOLDS(check_error(file(
                   panels, R"([{"panel":"a","edge":1},{"panel":"a","edge":1},{"layer":true}])")),
               "panel 'a', edge 1: stitch 0 sews it to itself");
}

TEST(Check, AnEdgeIsInAnyNumberOfLayeredStitches) {
  const std::string square = "[0,0],[20,0],[20,20],[0,20]";
  EXPECT_EQ(check_error(file(polygon("a", square) + "," + polygon("b", square) + "," +
                                 polygon("c", square) + "," + polygon("d", square),
                             R"([{"panel":"a","edge":1},{"panel":"b","edge":3}],
                                [{"panel":"a","edge":1},{"panel":"c","edge":1},{"layer":true}],
                                [{"panel":"a","edge":1},{"panel":"d","edge":1},{"layer":true}])")),
            "");
}

TEST(Check, SeamSidesOfDifferentLengthAreRemarkedOn) {
  EXPECT_TRUE(seam_remarks(20).empty());
  EXPECT_TRUE(seam_remarks(20.39).empty());
  const auto note = seam_remarks(21);
  ASSERT_EQ(note.size(), 1u);
  EXPECT_FALSE(note[0].warning);
  EXPECT_EQ(note[0].text,
            "test.json: panel 'b', edge 3 (21.00 cm) is sewn to panel 'a', edge 1 (20.00 cm), "
            "1.05 : 1; the longer side is eased in");
  const auto warning = seam_remarks(26);
  ASSERT_EQ(warning.size(), 1u);
  EXPECT_TRUE(warning[0].warning);
  EXPECT_HOLDS(warning[0].text, "1.30 : 1; right only if the longer side is gathered");
  EXPECT_FALSE(seam_remarks(23.9)[0].warning);
  EXPECT_TRUE(seam_remarks(24.1)[0].warning);
  EXPECT_TRUE(seam_remarks(15)[0].warning);
}

TEST(Check, ADeclaredGatherIsNotWarnedOf) {
  EXPECT_TRUE(seam_remarks(40, R"(, {"gather": true})").empty());
  EXPECT_TRUE(seam_remarks(40, R"(, {"gather": 2})").empty());
  EXPECT_EQ(seam_remarks(40, R"(, {"gather": false})").size(), 1u);
  // It may be drawn 5 % off what is declared.
  EXPECT_TRUE(seam_remarks(41.8, R"(, {"gather": 2})").empty());
  const auto off = seam_remarks(43, R"(, {"gather": 2})");
  ASSERT_EQ(off.size(), 1u);
  EXPECT_TRUE(off[0].warning);
  EXPECT_EQ(off[0].text,
            "test.json: panel 'a', edge 1 (20.00 cm) and panel 'b', edge 3 (43.00 cm) are drawn "
            "2.15 : 1, but declared gathered 2.00 : 1");
  EXPECT_HOLDS(error_of([] { seam_remarks(40, R"(, {"gather": 0.5})"); }), "is no fullness");
  EXPECT_HOLDS(error_of([] { seam_remarks(40, R"(, {"gather": "a lot"})"); }), "number");
}

// A band in two halves, whose side seams part the waist in two as well.
TEST(Check, SeamsThatMeetEndToEndAreOneLine) {
  std::vector<Remark> said;
  check_pattern(
      samples::parse(file(
          polygon("skirt", "[0,0],[80,0],[80,30],[40,30],[0,30]") + "," +
              polygon("left", "[0,0],[25,0],[25,4],[0,4]", R"("translation": [0,40,0])") + "," +
              polygon("right", "[0,0],[25,0],[25,4],[0,4]", R"("translation": [40,40,0])"),
          R"([{"panel":"skirt","edge":3},{"panel":"left","edge":0}],
               [{"panel":"right","edge":0},{"panel":"skirt","edge":2}])")),
      said);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].text,
            "test.json: panel 'skirt', edges 3, 2 (80.00 cm) are sewn to panel 'left', edge 0 and "
            "'right', edge 0 (50.00 cm), 1.60 : 1; right only if the longer side is gathered: say "
            "so by \"gather\": true in the stitch");
}

TEST(Check, OfALongLineTheMostUnequalSeamIsNamed) {
  std::string stitches;
  for (int i = 0; i < 6; ++i) {
    const std::string edge = std::to_string(i);
    stitches.append(i == 0 ? "" : ",").append(R"([{"panel":"a","edge":)").append(edge);
    stitches.append(R"(},{"panel":"b","edge":)").append(edge).append("}]");
  }
  std::vector<Remark> said;
  check_pattern(
      samples::parse(file(
          polygon("a", "[0,0],[10,0],[20,0],[30,0],[40,0],[50,0],[60,0],[60,20],[0,20]") + "," +
              polygon("b", "[0,0],[5,0],[10,0],[15,0],[17,0],[22,0],[27,0],[27,-20],[0,-20]",
                      R"("translation": [0,-1,0])"),
          stitches)),
      said);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_HOLDS(said[0].text,
               "test.json: panel 'a', edge 3 (10.00 cm) is sewn to panel 'b', edge 3 (2.00 cm), "
               "5.00 : 1, the most unequal of 6 seams in a line, together 2.22 : 1; right only if");
}

TEST(Check, TheRealPatternsPass) {
  for (const std::string name : {"shirt_mean.json", "dress_pencil.json"}) {
    const auto path = samples::real_pattern(name);
    if (!path) GTEST_SKIP() << name << " is not in ../shared/data or TOILE_DATA";
    std::vector<Remark> remarks;
    check_pattern(read_pattern(*path, remarks), remarks);
    int warnings = 0;
    for (const Remark& remark : remarks) warnings += remark.warning;
    // The dress is gathered all around the waist: nine seams, 1.30 : 1.
    EXPECT_EQ(warnings, name == "shirt_mean.json" ? 0 : 1);
    EXPECT_EQ(remarks.size() - static_cast<std::size_t>(warnings),
              name == "shirt_mean.json" ? 0u : 2u);
  }
}

}  // namespace check_pattern_test
}  // namespace toile
