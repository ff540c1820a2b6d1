#include "io/view/picture.h"

#include <gtest/gtest.h>

#include "geometry/error.h"

namespace toile {
namespace picture_test {

PictureMesh square(double width, double height) {
  PictureMesh shown;
  shown.mesh.points = {{0, 0, 0}, {width, 0, 0}, {width, height, 0}, {0, height, 0}};
  shown.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return shown;
}

/// Width and height as the PNG's header states them.
std::array<int, 2> size_of(const std::string& png) {
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value << 8 | static_cast<unsigned char>(png[at + i]);
    return value;
  };
  return {number(16), number(20)};
}

TEST(Picture, ViewsStandSideBySide) {
  Picture one;
  one.views = {View::front};
  one.view_width = 200;
  one.view_height = 150;
  Picture three = one;
  three.views = {View::front, View::left, View::top};
  const auto single = size_of(picture_png({square(1, 1)}, one));
  const auto triple = size_of(picture_png({square(1, 1)}, three));
  EXPECT_EQ(single[0], 200);
  EXPECT_GT(single[1], 150);  // room for the caption
  EXPECT_GE(triple[0], 600);
  EXPECT_LE(triple[0], 620);
  EXPECT_EQ(triple[1], single[1]);
}

TEST(Picture, HeightFollowsTheMeshUnlessGiven) {
  Picture picture;
  picture.view_width = 200;
  const auto wide = size_of(picture_png({square(2, 1)}, picture));
  const auto high = size_of(picture_png({square(1, 2)}, picture));
  EXPECT_NEAR(high[1] - wide[1], 300, 2);
}

TEST(Picture, UnframedMeshesDoNotMoveTheCamera) {
  Picture picture;
  picture.view_width = 200;
  PictureMesh large = square(1, 20);
  const auto alone = size_of(picture_png({square(1, 1)}, picture));
  large.framed = false;
  EXPECT_EQ(size_of(picture_png({square(1, 1), large}, picture)), alone);
  large.framed = true;
  EXPECT_GT(size_of(picture_png({square(1, 1), large}, picture))[1], alone[1]);
}

TEST(Picture, SameInputSameBytes) {
  Picture picture;
  picture.view_width = 120;
  picture.title = "a title";
  picture.bar = ColourBar{"gap, mm", magnitude_ramp(0, 60), "inside"};
  picture.legend = {{quiet_colour(0), "front"}, {quiet_colour(1), "back"}};
  const std::string first = picture_png({square(1, 1)}, picture);
  EXPECT_EQ(picture_png({square(1, 1)}, picture), first);
  picture.bar->ramp.high = 50;
  EXPECT_NE(picture_png({square(1, 1)}, picture), first);
}

TEST(Picture, AnyBytesMayBeText) {
  Picture picture;
  picture.view_width = 64;
  picture.title = "\xff\xfe\x01 \xc3\xa9";
  picture.legend = {{quiet_colour(0), "\xf0\x28\x8c\x28"}};
  EXPECT_GT(size_of(picture_png({square(1, 1)}, picture))[0], 64);
}

TEST(Picture, NothingToShowIsAnError) {
  EXPECT_THROW(picture_png({}, {}), Error);
  Picture none;
  none.views.clear();
  EXPECT_THROW(picture_png({square(1, 1)}, none), Error);
}

TEST(Picture, ViewsHaveNames) {
  EXPECT_EQ(view_named("top"), View::top);
  EXPECT_FALSE(view_named("Front").has_value());
}

}  // namespace picture_test
}  // namespace toile
