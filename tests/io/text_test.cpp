#include "io/text.h"

#include <gtest/gtest.h>

#include <limits>

namespace toile {
namespace text_test {

TEST(Text, IsShownOnOneLineAndCut) {
  EXPECT_EQ(shown_text("a\nb"),
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(shown_text(std::string(80, 'x')), std::string(80, 'x'));
  EXPECT_EQ(shown_text(std::string(5000, 'x')), std::string(80, 'x') + "...");
}

TEST(Text, WellFormedUtf8IsKept) {
  const std::string good = "Ärmel \xE2\x80\x93 袖 \xF0\x9F\x91\x95";
  EXPECT_EQ(valid_utf8(good), good);
}

TEST(Text, WhatIsNotUtf8IsReplaced) {
  const std::string mark = "\xEF\xBF\xBD";
  EXPECT_EQ(valid_utf8("a\xFFz"), "a" + mark + "z");
  EXPECT_EQ(valid_utf8("\xC0\xAF"), mark + mark);             // overlong slash
  EXPECT_EQ(valid_utf8("\xED\xA0\x80"), mark + mark + mark);  // surrogate
  EXPECT_EQ(valid_utf8("\xE2\x80"), mark + mark);             // cut off
  EXPECT_EQ(valid_utf8(std::string("\0\n", 2)), mark + mark);
}

TEST(Text, HtmlIsEscaped) {
  EXPECT_EQ(html_escaped("<b a=\"1\" c='2'>&</b>"),
            "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;&lt;/b&gt;");
}

TEST(Text, Base64OfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFF\xFE\xFD"), "//79");
}

TEST(Text, NumbersWithDecimals) {
  EXPECT_EQ(fixed_number(1234.56, 1), "1234.6");
  EXPECT_EQ(fixed_number(-0.04, 1), "0.0");
  EXPECT_EQ(fixed_number(-0.06, 1), "-0.1");
  EXPECT_EQ(fixed_number(3, 0), "3");
}

TEST(Text, NumbersReadBackToTheSameBits) {
  for (const double value : {0.1, -1.0 / 3, 1e-300, 123456789.0, 5e-324}) {
    std::string text;
    append_number(text, value);
    EXPECT_EQ(parse_number(text), value) << text;
  }
  EXPECT_EQ(parse_number("+2.5"), 2.5);
  EXPECT_EQ(parse_number("1e-999"), 0.0);
  EXPECT_EQ(parse_number("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number(""), std::nullopt);
  EXPECT_EQ(parse_number("1.5m"), std::nullopt);
}

}  // namespace text_test
}  // namespace toile
