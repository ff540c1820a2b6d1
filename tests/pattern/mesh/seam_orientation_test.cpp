#include "pattern/mesh/seam_orientation.h"

#include <gtest/gtest.h>

#include "tests/pattern/samples.h"

namespace toile {
namespace seam_orientation_test {

using samples::file;
using samples::polygon;

Orientation orientation_of(const std::string& text, std::vector<Remark>& remarks) {
  return orient(samples::parse(text), remarks);
}

/// Front and back squares, both drawn counter-clockwise; the back 20 cm behind, turned as said.
std::string squares(const std::string& back, const std::string& stitches) {
  return file(polygon("front", "[0,0],[20,0],[20,20],[0,20]", R"("translation": [0,0,10])") + "," +
                  polygon("back", "[0,0],[20,0],[20,20],[0,20]", back),
              stitches);
}

TEST(Orient, PlacedEndPointsDecideWhichWayASeamRuns) {
  std::vector<Remark> remarks;
  // Behind and not turned: edge 1 lies behind edge 1, start behind start.
  const Orientation behind =
      orientation_of(squares(R"("translation": [0,0,-10])",
                             R"([{"panel":"front","edge":1},{"panel":"back","edge":1}])"),
                     remarks);
  EXPECT_FALSE(behind.reversed[0]);
  // Turned about the vertical axis: edge 1 meets edge 3, bottom to bottom, end to start.
  const Orientation turned =
      orientation_of(squares(R"("translation": [20,0,-10], "rotation": [0,180,0])",
                             R"([{"panel":"front","edge":1},{"panel":"back","edge":3}])"),
                     remarks);
  EXPECT_TRUE(turned.reversed[0]);
  EXPECT_TRUE(remarks.empty());
}

TEST(Orient, AStatedDirectionWinsOverThePlacement) {
  std::vector<Remark> remarks;
  const Orientation stated = orientation_of(
      squares(R"("translation": [0,0,-10])",
              R"([{"panel":"front","edge":1},{"panel":"back","edge":1},{"reversed":true}])"),
      remarks);
  EXPECT_TRUE(stated.reversed[0]);
  const Orientation word = orientation_of(
      squares(R"("translation": [20,0,-10], "rotation": [0,180,0])",
              R"([{"panel":"front","edge":1},{"panel":"back","edge":3},"right_wrong"])"),
      remarks);
  EXPECT_FALSE(word.reversed[0]);
}

TEST(Orient, AlikeEndPointsRunEndToStart) {
  std::vector<Remark> remarks;
  // The back's edge lies square to the front's, through its middle.
  const Orientation alike =
      orientation_of(squares(R"("translation": [10,10,10], "rotation": [0,90,0])",
                             R"([{"panel":"front","edge":1},{"panel":"back","edge":0}])"),
                     remarks);
  EXPECT_TRUE(alike.reversed[0]);
}

TEST(Orient, ADartsEdgesMeetAtItsTip) {
  std::vector<Remark> remarks;
  const Orientation dart =
      orientation_of(file(polygon("skirt", "[0,0],[40,0],[40,30],[23,30],[20,15],[17,30],[0,30]"),
                          R"([{"panel":"skirt","edge":3},{"panel":"skirt","edge":4}])"),
                     remarks);
  EXPECT_TRUE(dart.reversed[0]);
  EXPECT_TRUE(remarks.empty());
}

TEST(Orient, RightSidesFaceOutOfTheGarment) {
  std::vector<Remark> remarks;
  const std::string both = R"([{"panel":"front","edge":1},{"panel":"back","edge":1}],
                              [{"panel":"front","edge":3},{"panel":"back","edge":3}])";
  // Both drawn the same way round, back behind front: the back shows its other side.
  const Orientation drawn_alike =
      orientation_of(squares(R"("translation": [0,0,-10])", both), remarks);
  EXPECT_FALSE(drawn_alike.mirrored[0]);
  EXPECT_TRUE(drawn_alike.mirrored[1]);
  // The front behind the back: now the front does.
  const Orientation swapped = orientation_of(squares(R"("translation": [0,0,30])", both), remarks);
  EXPECT_TRUE(swapped.mirrored[0]);
  EXPECT_FALSE(swapped.mirrored[1]);
  EXPECT_TRUE(remarks.empty());
}

TEST(Orient, WherePlacementDoesNotTellTheDrawingDoes) {
  std::vector<Remark> remarks;
  EXPECT_FALSE(orientation_of(file(polygon("p", "[0,0],[9,0],[9,9]")), remarks).mirrored[0]);
  EXPECT_TRUE(orientation_of(file(polygon("p", "[0,0],[9,9],[9,0]")), remarks).mirrored[0]);
}

/// Two halves of a front, sewn along the middle, without places. `left` and `right`: where the
/// middle of each half lies beside that seam, as drawn.
std::string halves(const std::string& left, const std::string& right, const std::string& face) {
  return file(polygon("left_" + face, left, R"("grain": 0)") + "," +
                  polygon("right_" + face, right, R"("grain": 0)"),
              "[{\"panel\":\"left_" + face + "\",\"edge\":3},{\"panel\":\"right_" + face +
                  "\",\"edge\":1}]");
}

TEST(Orient, NamesOfHalvesTellTheRightSideWithoutPlaces) {
  std::vector<Remark> remarks;
  const std::string right_of_seam = "[0,0],[20,0],[20,30],[0,30]";
  const std::string left_of_seam = "[-20,0],[0,0],[0,30],[-20,30]";
  // Seen from outside, the left half of a front lies to the right, that of a back to the left.
  const Orientation front = orientation_of(halves(right_of_seam, left_of_seam, "front"), remarks);
  EXPECT_FALSE(front.mirrored[0]);
  EXPECT_FALSE(front.mirrored[1]);
  const Orientation back = orientation_of(halves(right_of_seam, left_of_seam, "back"), remarks);
  EXPECT_TRUE(back.mirrored[0]);
  EXPECT_TRUE(back.mirrored[1]);
  EXPECT_TRUE(front.reversed[0]);
  EXPECT_TRUE(remarks.empty());
}

TEST(Orient, WithoutPlacesEdgesRunEndToStart) {
  std::vector<Remark> remarks;
  // As drawn, one upon the other, edge 1 would lie start to start.
  const Orientation without = orientation_of(
      squares(R"("grain": 0)", R"([{"panel":"front","edge":1},{"panel":"back","edge":1}])"),
      remarks);
  // The front states a translation, the back none: these are places.
  EXPECT_FALSE(without.reversed[0]);
  const Orientation neither =
      orientation_of(file(polygon("front", "[0,0],[20,0],[20,20],[0,20]", R"("grain": 0)") + "," +
                              polygon("back", "[0,0],[20,0],[20,20],[0,20]", R"("grain": 0)"),
                          R"([{"panel":"front","edge":1},{"panel":"back","edge":1}])"),
                     remarks);
  EXPECT_TRUE(neither.reversed[0]);
}

TEST(Orient, LayeredPanelsFaceTheSameWay) {
  const auto mirrored = [](const std::string& how) {
    std::vector<Remark> remarks;
    const Orientation orientation = orientation_of(
        squares(R"("translation": [0,0,9])",
                R"([{"panel":"front","edge":1},{"panel":"back","edge":1},)" + how + "]"),
        remarks);
    EXPECT_TRUE(remarks.empty());
    EXPECT_FALSE(orientation.reversed[0]);
    return orientation.mirrored[0] != orientation.mirrored[1];
  };
  EXPECT_FALSE(mirrored(R"({"layer": true})"));
  EXPECT_FALSE(mirrored(R"({"layer": true, "reversed": false})"));
  EXPECT_TRUE(mirrored("{}"));
}

// Both squares are drawn alike, the back behind the front: by distance edge 1 runs start to start.
TEST(Orient, GarmentCodesConventionComesBeforeThePlacement) {
  const auto reversed = [](const std::string& how, const std::string& properties) -> bool {
    std::vector<Remark> remarks;
    return orientation_of(
               file(polygon("front", "[0,0],[20,0],[20,20],[0,20]", R"("translation": [0,0,10])") +
                        "," + polygon("back", "[0,0],[20,0],[20,20],[0,20]"),
                    R"([{"panel":"front","edge":1},{"panel":"back","edge":1})" + how + "]",
                    R"("units_in_meter": 100)" + properties),
               remarks)
        .reversed[0];
  };
  const std::string convention = R"(, "normalized_edge_loops": true)";
  EXPECT_FALSE(reversed("", ""));
  EXPECT_FALSE(reversed("", R"(, "normalized_edge_loops": false)"));
  EXPECT_TRUE(reversed("", convention));
  EXPECT_TRUE(reversed(R"(, {"name": "side"})", convention));
  EXPECT_FALSE(reversed(R"(, "right_wrong")", convention));
  EXPECT_FALSE(reversed(R"(, {"reversed": false})", convention));
  // One that was drawn by hand says that it does not keep to the convention.
  EXPECT_FALSE(reversed(R"(, {"reversed": "found"})", convention));
}

// Edge 2 lies nearer to edge 0 end to start, as in a hood that lies folded. That would twist it.
TEST(Orient, AGuessLeavesTheGarmentTwoSided) {
  std::vector<Remark> remarks;
  const std::string side = R"([{"panel":"front","edge":1},{"panel":"back","edge":1}])";
  const std::string top = R"([{"panel":"front","edge":2},{"panel":"back","edge":0}])";
  const std::string bottom = R"([{"panel":"front","edge":0},{"panel":"back","edge":2}])";
  const std::string behind = R"("translation": [0,0,-10])";
  using Directions = std::vector<bool>;
  EXPECT_EQ(orientation_of(squares(behind, top), remarks).reversed, Directions({true}));
  // The side is more certain than the top.
  EXPECT_EQ(orientation_of(squares(behind, top + "," + side), remarks).reversed,
            Directions({false, false}));
  // It is not more certain than top and bottom together.
  EXPECT_EQ(orientation_of(squares(behind, top + "," + side + "," + bottom), remarks).reversed,
            Directions({true, true, true}));
  EXPECT_TRUE(remarks.empty());
}

TEST(Orient, TheSeamAtFaultIsNamed) {
  std::vector<Remark> remarks;
  const auto seam = [](int edge, const std::string& reversed) {
    return R"([{"panel":"front","edge":)" + std::to_string(edge) + R"(},{"panel":"back","edge":)" +
           std::to_string(edge) + R"(},{"reversed":)" + reversed + "}]";
  };
  // The wrong one comes first, so that it is the others that seem to disagree with it.
  orientation_of(squares(R"("translation": [0,0,-10])",
                         seam(3, "true") + "," + seam(0, "false") + "," + seam(1, "false")),
                 remarks);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_EQ(
      remarks[0].text,
      "test.json: panel 'front', edge 3 and panel 'back', edge 3 join a right side to a wrong "
      "side; state \"reversed\": false in the stitch, or check the other seams of these "
      "panels");
}

TEST(Orient, ATwistedBandIsRemarkedOn) {
  std::vector<Remark> remarks;
  // One side seam straight, one crossed: a Moebius band.
  orientation_of(
      squares(R"("translation": [0,0,-10])",
              R"([{"panel":"front","edge":1},{"panel":"back","edge":1},{"reversed":false}],
                 [{"panel":"front","edge":3},{"panel":"back","edge":3},{"reversed":true}])"),
      remarks);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_TRUE(remarks[0].warning);
  EXPECT_HOLDS(remarks[0].text, "join a right side to a wrong side");
}

}  // namespace seam_orientation_test
}  // namespace toile
