#include "pattern/seams/seam_pairs.h"

#include "tests/pattern/samples.h"

namespace toile {
namespace seam_pairs_test {

// Rectangles are walked from the lower left corner: hem, right side, top, left side.
constexpr int hem = 0;
constexpr int right = 1;
constexpr int top = 2;
constexpr int left = 3;

class Halves : public testing::Test {
 protected:
  void draw(const std::string& piece) {
    draw_all({"left_front_" + piece, "left_back_" + piece, "right_front_" + piece,
              "right_back_" + piece});
  }

  void draw_all(const std::vector<std::string>& names) {
    std::string panels;
    for (const std::string& name : names) {
      panels += (panels.empty() ? "" : ",") + samples::polygon(name, "[0,0],[20,0],[20,50],[0,50]");
    }
    std::vector<Remark> remarks;
    evidence = seam_evidence(parse_drawn_pattern(samples::file(panels), "test", remarks), false);
  }

  double measure(SeamMeasure measure, int panel_a, int edge_a, int panel_b, int edge_b) const {
    const SeamPairs pairs(evidence, true);
    return pairs.measures(panel_a * 4 + edge_a, panel_b * 4 + edge_b)[static_cast<int>(measure)];
  }

  SeamEvidence evidence;
};

// Seen from outside, the wearer's left front ends at the middle of the body on its left.
TEST_F(Halves, OfABodiceMeetInTheMiddle) {
  draw("torso");
  EXPECT_NEAR(measure(SeamMeasure::centre_seam, 0, left, 2, right), 1, 1e-9);
  EXPECT_NEAR(measure(SeamMeasure::centre_seam, 1, right, 3, left), 1, 1e-9);
  EXPECT_NEAR(measure(SeamMeasure::centre_seam, 0, right, 2, left), 0, 1e-9);
  EXPECT_NEAR(measure(SeamMeasure::outsides_meet, 0, right, 2, left), 1, 1e-9);
  EXPECT_NEAR(measure(SeamMeasure::outsides_meet, 0, left, 2, right), 0, 1e-9);
  EXPECT_NEAR(measure(SeamMeasure::centres_apart, 0, left, 1, right), 1, 1e-9);
  EXPECT_NEAR(measure(SeamMeasure::centres_apart, 0, right, 1, left), 0, 1e-9);
}

TEST_F(Halves, OfBothSidesAreSewnToTheirLikesAlone) {
  const auto possible = [this](int panel_a, int panel_b, bool heed_sides) {
    return SeamPairs(evidence, heed_sides).possible(panel_a * 4 + right, panel_b * 4 + left);
  };
  draw_all({"left_torso", "left_yoke", "right_torso", "right_yoke"});
  EXPECT_TRUE(possible(0, 1, true)) << "left torso and yoke";
  EXPECT_TRUE(possible(0, 2, true)) << "left and right torso";
  EXPECT_FALSE(possible(0, 3, true)) << "left torso and right yoke";
  EXPECT_FALSE(possible(3, 0, true)) << "right yoke and left torso";
  EXPECT_TRUE(possible(0, 3, false)) << "where sides are not heeded";
  // Sleeves of both arms never meet.
  for (const char* piece : {"sleeve", "cuff"}) {
    draw(piece);
    for (const bool heed_sides : {false, true}) {
      EXPECT_TRUE(possible(0, 1, heed_sides)) << piece;
      EXPECT_FALSE(possible(0, 2, heed_sides)) << piece;
      EXPECT_FALSE(possible(0, 3, heed_sides)) << piece;
    }
  }
}

TEST_F(Halves, OfSkirtsSayNothingOfTheMiddle) {
  draw("skirt");
  EXPECT_EQ(measure(SeamMeasure::centre_seam, 0, left, 2, right), 0);
  EXPECT_EQ(measure(SeamMeasure::centres_apart, 0, left, 1, right), 0);
}

TEST_F(Halves, HemsOfSkirtsAreNotSewnToEachOther) {
  draw("skirt");
  EXPECT_NEAR(measure(SeamMeasure::end_to_end, 0, hem, 1, hem), 1, 1e-9);
  EXPECT_NEAR(measure(SeamMeasure::end_to_end, 0, top, 1, top), 0, 1e-9);
  draw("torso");
  EXPECT_NEAR(measure(SeamMeasure::end_to_end, 0, hem, 1, hem), 0, 1e-9);
}

TEST_F(Halves, StandFarApartInTheFileUnlessTheyAreOfOnePiece) {
  draw("torso");
  EXPECT_EQ(measure(SeamMeasure::far_in_file, 0, left, 1, right), 0) << "beside each other";
  EXPECT_NEAR(measure(SeamMeasure::far_in_file, 0, left, 3, right), std::log(3.0), 1e-12);
  EXPECT_EQ(measure(SeamMeasure::far_in_file, 0, left, 2, right), 0) << "left and right front";
}

// Nothing tells which of equal pieces a number means, nor what a number means without a name.
TEST(NumbersOfPieces, SayNothingOfEqualPiecesAndOfPiecesWithoutAKind) {
  const auto numbers = [](const std::string& name, const std::string& corner) {
    std::vector<Remark> remarks;
    const std::string panels = samples::polygon(name + "1", "[0,0],[20,0],[20,50],[0,50]") + "," +
                               samples::polygon(name + "3", "[0,0],[20,0],[20,50]," + corner);
    const SeamEvidence evidence =
        seam_evidence(parse_drawn_pattern(samples::file(panels), "test", remarks), false);
    const SeamMeasures found = SeamPairs(evidence, true).measures(right, 4 + left);
    const auto at = [&](SeamMeasure measure) { return found[static_cast<int>(measure)]; };
    return std::array{at(SeamMeasure::numbers_apart), at(SeamMeasure::first_number),
                      at(SeamMeasure::later_number)};
  };
  const std::array nothing = {0.0, 0.0, 0.0};
  EXPECT_EQ(numbers("piece", "[0,50]"), nothing);
  EXPECT_EQ(numbers("piece", "[0,60]"), nothing);
  EXPECT_EQ(numbers("skirt_", "[0,50]"), nothing);
  EXPECT_EQ(numbers("skirt_", "[0,60]"), (std::array{1.0, 0.0, 0.0}));
}

TEST(CutsIntoASkirt, AreSlitsAtTheHemAndDartsAtTheWaist) {
  const auto slit = [](const std::string& vertices, int leg) {
    std::vector<Remark> remarks;
    const std::string panels = samples::polygon("skirt_front", vertices);
    const SeamEvidence evidence =
        seam_evidence(parse_drawn_pattern(samples::file(panels), "test", remarks), false);
    const SeamPairs pairs(evidence, true);
    return pairs.measures(leg, leg + 1)[static_cast<int>(SeamMeasure::slit)];
  };
  EXPECT_EQ(slit("[0,0],[28,0],[25.79,9.88],[31,1.2],[60,0],[60,60],[0,60]", 1), 1) << "slanted";
  EXPECT_EQ(slit("[0,0],[60,0],[60,60],[32,60],[30,48],[28,60],[0,60]", 3), 0);
  EXPECT_EQ(slit("[0,0],[60,0],[60,60],[32,60],[30,30],[28,60],[0,60]", 3), 1) << "30 cm long";
}

TEST_F(Halves, FrontAndBackAreNotSewnTopToHem) {
  draw("torso");
  EXPECT_NEAR(measure(SeamMeasure::end_to_end, 0, top, 1, hem), 1, 1e-9);
  EXPECT_NEAR(measure(SeamMeasure::end_to_end, 0, top, 1, top), 0, 1e-9);
  EXPECT_NEAR(measure(SeamMeasure::end_to_end, 0, right, 1, left), 0, 1e-9);
}

// A rectangle is mirrored in two ways.
TEST_F(Halves, AreMirroredAsDrawn) {
  draw("cuff");
  EXPECT_EQ(evidence.mirror[0 * 4 + top], 2 * 4 + top);
  EXPECT_EQ(evidence.mirror[0 * 4 + hem], 2 * 4 + hem);
  EXPECT_EQ(evidence.mirror[0 * 4 + left], 2 * 4 + right);
}

TEST(NumberedPieces, AreMirroredWhereTheyAreAloneInFront) {
  const auto mirror = [](const std::string& other) {
    std::vector<Remark> remarks;
    const std::string panels = samples::polygon("skirt_front_0", "[0,0],[60,0],[60,20],[0,20]") +
                               "," + samples::polygon(other, "[0,0],[60,0],[60,20],[0,20]");
    const Pattern pattern = parse_drawn_pattern(samples::file(panels), "test", remarks);
    return seam_evidence(pattern, false).mirror;
  };
  EXPECT_EQ(mirror("skirt_back_0")[right], left);
  EXPECT_EQ(mirror("skirt_front_1")[right], -1);
}

// Reflected across its length, too, it would coincide with itself.
TEST(Bands, ChangeTheirEndsInTheMirrorWhereverTheirEdgesAreCut) {
  std::vector<Remark> remarks;
  const std::string band = samples::polygon("wb_front", "[0,0],[30,0],[60,0],[60,5],[30,5],[0,5]");
  const SeamEvidence evidence =
      seam_evidence(parse_drawn_pattern(samples::file(band), "test", remarks), false);
  EXPECT_EQ(evidence.mirror, (std::vector<int>{1, 0, 5, 4, 3, 2}));
}

TEST(WhatHangs, HangsByItsUpperEdge) {
  const auto turned = [](const std::string& holder, const std::string& hung, int holds, int hangs) {
    std::vector<Remark> remarks;
    const std::string panels = samples::polygon(holder, "[0,0],[20,0],[20,6],[0,6]") + "," +
                               samples::polygon(hung, "[0,0],[20,0],[20,50],[0,50]");
    const SeamEvidence evidence =
        seam_evidence(parse_drawn_pattern(samples::file(panels), "test", remarks), false);
    const SeamPairs pairs(evidence, true);
    return pairs.measures(holds, 4 + hangs)[static_cast<int>(SeamMeasure::hangs_turned)];
  };
  EXPECT_NEAR(turned("waistband", "skirt", hem, top), 0, 1e-9);
  EXPECT_NEAR(turned("waistband", "skirt", hem, hem), 2, 1e-9);
  EXPECT_NEAR(turned("waistband", "skirt", top, top), 2, 1e-9);
  EXPECT_NEAR(turned("waistband", "skirt", hem, left), 1, 1e-9);
  // A cuff may be drawn along the arm or across it; its flounce is drawn as it hangs.
  EXPECT_NEAR(turned("left_cuff", "left_cuff_skirt", top, top), 0, 1e-9);
  EXPECT_NEAR(turned("left_cuff", "left_cuff_skirt", hem, hem), 2, 1e-9);
  EXPECT_EQ(turned("front", "skirt", hem, hem), 0) << "a bodice holds a peplum by either";
}

}  // namespace seam_pairs_test
}  // namespace toile
