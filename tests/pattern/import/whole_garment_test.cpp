#include "pattern/import/whole_garment.h"

#include <gtest/gtest.h>

namespace toile {
namespace whole_garment_test {

Piece piece(const std::string& name, const std::vector<Vec2>& outline) {
  Piece made;
  made.name = name;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    made.outline.push_back(EdgeCurve::line(outline[i], outline[(i + 1) % outline.size()]));
  }
  return made;
}

/// Half a front folded at x = 0, a sleeve that leans, and a band.
PieceDrawing half_a_shirt() {
  PieceDrawing drawing;
  drawing.source = "half.dxf";
  drawing.pieces = {piece("front", {{0, 0}, {0.26, 0}, {0.24, 0.4}, {0.1, 0.6}, {0, 0.5}}),
                    piece("sleeve", {{1, 0}, {1.3, 0.02}, {1.4, 0.3}, {1.2, 0.45}, {0.95, 0.28}}),
                    piece("band", {{2, 0}, {2.5, 0}, {2.5, 0.04}, {2, 0.04}})};
  return drawing;
}

/// What import_pieces() makes of the drawing, and what whole_garment() of that.
ImportOptions whole(const PieceDrawing& drawing, const ImportOptions& given = {}) {
  std::vector<Remark> remarks;
  return whole_garment(import_pieces(drawing, given, remarks), given);
}

using Words = std::vector<std::string>;

TEST(WholeGarment, AHalfIsUnfoldedAndALopsidedPieceIsCutTwice) {
  const ImportOptions options = whole(half_a_shirt());
  EXPECT_EQ(options.pairs, Words{"sleeve"});
  ASSERT_EQ(options.unfold.size(), 1);
  std::vector<Remark> remarks;
  const ImportedPattern half = import_pieces(half_a_shirt(), {}, remarks);
  const ImportedPattern made = import_pieces(half_a_shirt(), options, remarks);
  ASSERT_EQ(made.panels.size(), 4);
  EXPECT_EQ(made.panels[0].name, "front");
  EXPECT_NEAR(made.panels[0].area, 2 * half.panels[0].area, 1e-6);
  EXPECT_TRUE(made.panels[0].is_symmetric);
}

TEST(WholeGarment, WhatTheUserSaysHolds) {
  ImportOptions single;
  single.singles = {"sleeve"};
  EXPECT_EQ(whole(half_a_shirt(), single).pairs, Words{});
  ImportOptions paired;
  paired.pairs = {"sleeve"};
  EXPECT_EQ(whole(half_a_shirt(), paired).unfold, Words{});
}

TEST(WholeGarment, WhatTheDrawingSaysHolds) {
  PieceDrawing drawing = half_a_shirt();
  drawing.pieces[1].quantity = 2;
  EXPECT_EQ(whole(drawing).unfold, Words{});
  // The front alone is neither symmetric nor one of two, and is not said to be folded.
  EXPECT_EQ(whole(drawing).pairs, Words{"front"});
  EXPECT_EQ(whole(drawing).unfold, Words{});
  // Of two, nobody knows, and to name one tells nothing of the other.
  drawing.pieces.push_back(piece("pocket", {{5, 0}, {5.2, 0}, {5.25, 0.3}, {5, 0.2}}));
  EXPECT_EQ(whole(drawing).pairs, Words{});
  ImportOptions single;
  single.singles = {"pocket"};
  EXPECT_EQ(whole(drawing, single).pairs, Words{});
}

TEST(WholeGarment, LeftAndRightFrontsAndAWholeBackAreWhole) {
  PieceDrawing drawing = half_a_shirt();
  // The front's mirror image: neither is a half any more, and nothing tells of the sleeve.
  drawing.pieces.push_back(
      piece("other", {{3.26, 0}, {3.26, 0.5}, {3.16, 0.6}, {3.02, 0.4}, {3, 0}}));
  EXPECT_EQ(whole(drawing).unfold, Words{});
  EXPECT_EQ(whole(drawing).pairs, Words{});
  drawing.pieces.push_back(
      piece("back", {{4, 0}, {4.52, 0}, {4.5, 0.4}, {4.36, 0.6}, {4.16, 0.6}, {4.02, 0.4}}));
  EXPECT_EQ(whole(drawing).pairs, Words{});
}

}  // namespace whole_garment_test
}  // namespace toile
