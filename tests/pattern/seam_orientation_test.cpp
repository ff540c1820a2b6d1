#include "pattern/seam_orientation.h"

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
