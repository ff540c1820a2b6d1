#include "io/dxf_text.h"

#include <gtest/gtest.h>

namespace toile {
namespace dxf_text_test {

TEST(DxfText, CodesBecomeCharacters) {
  EXPECT_EQ(plain_dxf_text("45%%d, \\U+00E9t\\U+00E9, 5%%%"), "45\u00b0, \u00e9t\u00e9, 5%");
  EXPECT_EQ(plain_dxf_text("%%uunder%%u"), "under");
  EXPECT_EQ(plain_dxf_text("\\U+D8"), "\\U+D8");
}

TEST(DxfText, ParagraphsLoseTheirFormat) {
  EXPECT_EQ(plain_dxf_paragraphs("{\\fArial|b0|i0;\\H2.5;Piece Name:\\~FRONT}\\PSize: M"),
            "Piece Name: FRONT\nSize: M");
  EXPECT_EQ(plain_dxf_paragraphs("a\\\\b \\{c\\} \\S1/2;"), "a\\b {c} 1/2");
  EXPECT_EQ(plain_dxf_paragraphs("\\H2"), "");
}

}  // namespace dxf_text_test
}  // namespace toile
