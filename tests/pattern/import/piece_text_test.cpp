#include "pattern/import/piece_text.h"

#include <gtest/gtest.h>

namespace toile {
namespace piece_text_test {

TEST(PieceText, QuantitiesAreReadAsTheyAreWritten) {
  const auto expect = [](const char* text, int count, bool pair) {
    const auto quantity = read_quantity(text);
    ASSERT_TRUE(quantity) << text;
    EXPECT_EQ(quantity->count, count) << text;
    EXPECT_EQ(quantity->pair, pair) << text;
  };
  expect("2", 2, false);
  expect("1,1", 2, true);
  expect("1+1", 2, true);
  expect("2, 0", 2, false);
  expect("1 pair", 2, true);
  expect("2 mirrored", 2, true);
  expect("Left and right", 2, true);
  expect("1 mirrored", 1, false);
  expect("99999999999999", 1000, false);
  EXPECT_FALSE(read_quantity("some"));
  EXPECT_FALSE(read_quantity("0"));
  EXPECT_FALSE(read_quantity("0,0"));
  EXPECT_TRUE(read_quantity("2,0")->none_mirrored);
  EXPECT_FALSE(read_quantity("2")->none_mirrored);
}

TEST(PieceText, KeysCountInAnyCapitals) {
  PieceTexts texts;
  texts.add("PIECE NAME:  Front panel \nsize : 38");
  texts.add("Piece Name: second");
  texts.add("anything: else");
  EXPECT_EQ(texts.value("piece name"), "Front panel");
  EXPECT_EQ(texts.value("size"), "38");
  EXPECT_EQ(texts.others(), 1);
  EXPECT_FALSE(texts.quantity());
}

TEST(PieceText, LabelsSayCut) {
  PieceTexts texts;
  texts.add("Fabric, Cut 1 on fold");
  EXPECT_EQ(texts.quantity()->count, 1);
  EXPECT_EQ(texts.material(), "Fabric");
  texts.add("Back Panel_1");
  EXPECT_EQ(texts.spelling_of("BACKPANEL1"), "Back Panel_1");
  EXPECT_EQ(texts.spelling_of("FRONT"), "");
}

TEST(PieceText, AnAnnotationCountsWhereNoQuantityIsStated) {
  const auto count = [](const std::string& quantity, const std::string& annotation) {
    PieceTexts texts;
    texts.add("Quantity: " + quantity + "\nAnnotation: " + annotation);
    const auto read = texts.quantity();
    return read ? read->count : -1;
  };
  EXPECT_EQ(count("0", "2XFABRIC"), 2);
  EXPECT_EQ(count("0,0", "2x rib"), 2);
  EXPECT_EQ(count("0", "1XFABRIC 1X INTERLIN"), 1);
  EXPECT_EQ(count("1", "2XFABRIC"), 1);
  EXPECT_EQ(count("0", "RECTANGLE"), -1);
  EXPECT_EQ(count("0", "2X"), -1);
}

}  // namespace piece_text_test
}  // namespace toile
