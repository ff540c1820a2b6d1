#include "pattern/mesh/short_edges.h"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/triangulate.h"
#include "pattern/constants.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace short_edges_test {

using samples::file;
using samples::polygon;

struct Parsed {
  Pattern pattern;
  std::vector<Remark> remarks;
};

Parsed parsed(const std::string& text) {
  Parsed result;
  result.pattern = parse_pattern(text, "test.json", result.remarks);
  return result;
}

std::vector<int> outline_of(const Pattern& pattern, std::size_t panel) {
  std::vector<int> edges;
  for (const OutlineStep& step : pattern.panels[panel].outline) edges.push_back(step.edge);
  return edges;
}

double length_of(const Pattern& pattern, std::size_t panel, std::size_t edge) {
  return pattern.panels[panel].edges[edge].curve.length();
}

/// Degrees.
double sharpest(const PanelMesh& garment) {
  return smallest_angle(garment.flat, garment.triangles) * 180 / std::numbers::pi;
}

using Edges = std::vector<int>;

/// Front and back of a skirt. Beside the hem, edges of `slit` cm are not sewn.
std::string skirt(const std::string& slit) {
  const std::string corners = "[0,0],[60,0],[60," + slit + "],[60,40],[0,40],[0," + slit + "]";
  return file(
      polygon("front", corners, R"("translation": [0,0,10])") + "," + polygon("back", corners),
      R"([{"panel":"front","edge":2},{"panel":"back","edge":2},{"reversed": false}],
         [{"panel":"front","edge":4},{"panel":"back","edge":4},{"reversed": false}])");
}

TEST(MergeShortEdges, AnEdgeGoesIntoTheNeighbourThatItContinues) {
  const auto [pattern, remarks] = parsed(skirt("0.02"));
  for (const std::size_t panel : {0, 1}) {
    EXPECT_EQ(outline_of(pattern, panel), Edges({0, 2, 3, 4}));
    EXPECT_EQ(pattern.panels[panel].edges[2].curve.start(), Vec2(0.6, 0));
    EXPECT_EQ(pattern.panels[panel].edges[4].curve.end(), Vec2(0, 0));
  }
  EXPECT_EQ(pattern.stitches.size(), 2u);
  ASSERT_EQ(remarks.size(), 4u);
  EXPECT_TRUE(remarks[0].warning);
  EXPECT_EQ(remarks[0].text,
            "test.json: panel 'front', edge 1 (0.2 mm) is too short to mesh; it is merged with "
            "edge 2");
}

// Refused before: needles at 0.2 mm, "zero length" at a hundredth of a millimetre and less.
TEST(MergeShortEdges, WhatWasRefusedIsMeshed) {
  for (const char* slit : {"0.05", "0.02", "0.001", "0"}) {
    for (const double edge_length : {0.015, 0.025}) {
      auto [pattern, remarks] = parsed(skirt(slit));
      check_pattern(pattern, remarks);
      const PanelMesh garment = mesh_panels(pattern, {edge_length}, remarks);
      EXPECT_GT(sharpest(garment), 15) << slit << " cm";
      EXPECT_EQ(garment.seams[1].name, "front.4-back.4");
    }
  }
}

TEST(MergeShortEdges, AnEdgeOfThreeMillimetresStays) {
  const auto [pattern, remarks] = parsed(skirt("0.3001"));
  EXPECT_EQ(outline_of(pattern, 0).size(), 6u);
  EXPECT_TRUE(remarks.empty());
}

/// A front whose dart ends `rest` cm below the armhole, and a back without dart.
std::string bodice(const std::string& rest, const std::string& more_stitches = "") {
  return file(
      polygon("front", "[0,0],[20,0],[20,14],[9,16],[20,18],[20,18." + rest + "],[10,40],[0,40]",
              R"("translation": [0,0,10])") +
          "," + polygon("back", "[0,0],[20,0],[20,14],[20,14." + rest + "],[10,36],[0,36]"),
      R"([{"panel":"front","edge":1},{"panel":"back","edge":1},{"reversed": false}],
         [{"panel":"front","edge":2},{"panel":"front","edge":3},{"reversed": true}],
         [{"panel":"front","edge":4},{"panel":"back","edge":2},{"reversed": false}])" +
          more_stitches);
}

TEST(MergeShortEdges, TwoThatAreSewnTogetherGoWithTheirStitch) {
  auto [pattern, remarks] = parsed(bodice("07"));
  EXPECT_EQ(outline_of(pattern, 0), Edges({0, 1, 2, 3, 5, 6, 7}));
  EXPECT_EQ(outline_of(pattern, 1), Edges({0, 1, 3, 4, 5}));
  ASSERT_EQ(pattern.stitches.size(), 2u);
  // The back's side seam takes its piece in: it goes straight on.
  EXPECT_NEAR(length_of(pattern, 1, 1), 0.1407, 1e-12);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_EQ(remarks[0].text,
            "test.json: panel 'front', edge 4 (0.7 mm) and panel 'back', edge 2 (0.7 mm), sewn "
            "together, are too short to mesh; they are merged with edges 5 and 1");
  check_pattern(pattern, remarks);
  EXPECT_GT(sharpest(mesh_panels(pattern, {0.015}, remarks)), 5);
}

TEST(MergeShortEdges, TheOtherSideMayBeTwiceAsLong) {
  const auto merged = [](const std::string& longer) {
    const std::string side = R"("translation": [0,0,10])";
    return parsed(
               file(polygon("a", "[0,0],[20,0],[20,20],[20,20.2],[0,20.2]", side) + "," +
                        polygon("b", "[0,0],[20,0],[20,20],[20," + longer + "],[0," + longer + "]"),
                    R"([{"panel":"a","edge":1},{"panel":"b","edge":1},{"reversed": false}],
                          [{"panel":"a","edge":2},{"panel":"b","edge":2},{"reversed": false}])"))
        .pattern.stitches.size();
  };
  EXPECT_EQ(merged("20.5"), 1u);
  EXPECT_EQ(merged("20.7"), 2u);
}

TEST(MergeShortEdges, TheOnlySeamBetweenTwoPanelsStays) {
  const auto [pattern, remarks] = parsed(
      file(polygon("a", "[0,0],[20,0],[20,20],[0.2,20],[0,20]") + "," +
               polygon("b", "[0,0],[20,0],[20,20],[0.2,20],[0,20]", R"("translation": [0,0,10])"),
           R"([{"panel":"a","edge":3},{"panel":"b","edge":3}])"));
  EXPECT_EQ(pattern.stitches.size(), 1u);
  EXPECT_EQ(outline_of(pattern, 0).size(), 5u);
  EXPECT_TRUE(remarks.empty());
}

// A round neck may be drawn as edges of 2 mm.
TEST(MergeShortEdges, ManyInARowDrawACurveAndStay) {
  std::string corners = "[0,0],[20,0],[20,20]";
  for (int i = 1; i < 20; ++i) {
    const double x = 20 - i * 0.2;
    corners += ",[" + std::to_string(x) + "," + std::to_string(20 - (20 - x) * (x - 16) / 4) + "]";
  }
  const auto [pattern, remarks] = parsed(file(polygon("p", corners + ",[16,20],[0,20]")));
  EXPECT_EQ(outline_of(pattern, 0).size(), 24u);
  EXPECT_TRUE(remarks.empty());
}

TEST(MergeShortEdges, ANarrowStripKeepsItsEnds) {
  const auto [pattern, remarks] = parsed(file(polygon("strap", "[0,0],[20,0],[20,0.2],[0,0.2]")));
  EXPECT_EQ(outline_of(pattern, 0).size(), 4u);
}

TEST(MergeShortEdges, ACutCornerIsMovedByItsOwnWidth) {
  const auto [pattern, remarks] =
      parsed(file(polygon("p", "[0,0],[19.8,0],[20,0.2],[20,20],[0,20]")));
  ASSERT_EQ(outline_of(pattern, 0).size(), 4u);
  // The edge that takes the corner in ends at the far end of it, so the corner is cut.
  const OutlineStep taker = pattern.panels[0].outline[1];
  EXPECT_EQ(taker.edge, 2);
  EXPECT_EQ(pattern.panels[0].edges[2].curve.start(), Vec2(0.198, 0));
  EXPECT_EQ(pattern.panels[0].edges[2].curve.end(), Vec2(0.2, 0.2));
}

TEST(MergeShortEdges, AnAttachmentHoldsThePlace) {
  const auto [pattern, remarks] = parsed(
      file(polygon("p", "[0,0],[20,0],[20,0.1],[20,20],[0,20]",
                   R"("attach": [{"edge": 1, "to": "waist"}, {"edge": 3, "to": "waist"}])")));
  const std::vector<PanelAttachment>& attachments = pattern.panels[0].attachments;
  ASSERT_EQ(attachments.size(), 2u);
  EXPECT_EQ(attachments[0].edge, 2);
  EXPECT_EQ(attachments[0].share, PanelAttachment::Share::start);
  EXPECT_EQ(attachments[0].name, "1");
  EXPECT_EQ(attachments[1].edge, 3);
  EXPECT_EQ(attachments[1].share, PanelAttachment::Share::whole);
}

TEST(MergeShortEdges, AnElasticStays) {
  Pattern pattern = samples::parse(skirt("0.4"));
  pattern.panels[0].edges[1].curve = EdgeCurve::line({0.6, 0}, {0.6, 0.001});
  pattern.panels[0].edges[2].curve = EdgeCurve::line({0.6, 0.001}, {0.6, 0.4});
  pattern.panels[0].edges[1].elastic = Elastic{0.5, 20};
  std::vector<Remark> remarks;
  merge_short_edges(pattern, remarks);
  EXPECT_EQ(outline_of(pattern, 0).size(), 6u);
}

}  // namespace short_edges_test
}  // namespace toile
