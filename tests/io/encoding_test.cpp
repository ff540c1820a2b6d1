#include "io/encoding.h"

#include <gtest/gtest.h>

namespace toile {
namespace encoding_test {

TEST(Encoding, TellsUtf8) {
  EXPECT_TRUE(is_utf8("Gr\u00f6\u00dfe \u524d \U0001F9F5"));
  EXPECT_FALSE(is_utf8("Gr\xF6\xDF"));
  EXPECT_FALSE(is_utf8("\xC3"));
  EXPECT_FALSE(is_utf8("\xED\xA0\x80"));
}

TEST(Encoding, ReadsCodePages) {
  EXPECT_EQ(to_utf8("Gr\xF6\xDF"
                    "e",
                    "CP1252"),
            "Gr\u00f6\u00dfe");
  EXPECT_EQ(to_utf8("\xC7\xE0\xE4", "CP1251"), "\u0417\u0430\u0434");
  EXPECT_EQ(to_utf8("\x91\x4F", "CP932"), "\u524d");
  EXPECT_EQ(to_utf8("\xF6", "nonsense"), "\u00f6");
  EXPECT_EQ(to_utf8("a\x81"
                    "b",
                    "CP1252"),
            "a\uFFFD"
            "b");
}

}  // namespace encoding_test
}  // namespace toile
