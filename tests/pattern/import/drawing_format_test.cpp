#include "pattern/import/drawing_format.h"

#include <gtest/gtest.h>

#include "tests/pattern/samples.h"

namespace toile {
namespace drawing_format_test {

using samples::error_of;

TEST(DrawingFormat, IsToldByContent) {
  EXPECT_EQ(drawing_format("0\nSECTION\n", "x"), DrawingFormat::dxf);
  EXPECT_EQ(drawing_format("<?xml version=\"1.0\"?>\n<svg/>", "x"), DrawingFormat::svg);
  EXPECT_EQ(drawing_format("\xEF\xBB\xBF {\"pattern\": {}}", "x"), DrawingFormat::json);
}

TEST(DrawingFormat, SaysWhatElseItIs) {
  const auto refused = [](const std::string& text) {
    return error_of([&] { drawing_format(text, "x"); });
  };
  EXPECT_HOLDS(refused("%PDF-1.7"), "x: is a PDF");
  EXPECT_HOLDS(refused("<?xml version=\"1.0\"?><pattern/>"), "Valentina or Seamly2D");
  EXPECT_HOLDS(refused(""), "is empty");
  EXPECT_HOLDS(refused("vertices 1 2 3"), "is neither DXF, SVG nor JSON");
}

}  // namespace drawing_format_test
}  // namespace toile
