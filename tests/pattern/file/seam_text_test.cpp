#include "pattern/file/seam_text.h"

#include <gtest/gtest.h>

namespace toile {
namespace seam_text_test {

TEST(SeamText, IsReadAsItIsWritten) {
  for (const char* text : {"Seam: 1 a", "Seam: 12 b", "Seam: 3 b found", "Seam: 3 a layer",
                           "Seam: 4 a gather", "Seam: 4 b found layer gather 1.5"}) {
    const auto seam = read_seam_text(text);
    ASSERT_TRUE(seam) << text;
    EXPECT_EQ(seam_text(*seam), text);
  }
}

TEST(SeamText, OtherTextsAreNone) {
  for (const char* text : {"", "Seam", "Seam: a", "Seam: 0 a", "Seam: 1", "Seam: 1 c",
                           "Seam: 1 a b", "Seam: 9999999 a", "3 a", "Piece Name: Seam: 1 a"}) {
    EXPECT_FALSE(read_seam_text(text)) << text;
  }
}

}  // namespace seam_text_test
}  // namespace toile
