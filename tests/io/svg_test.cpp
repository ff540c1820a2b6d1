#include "io/svg.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "geometry/error.h"

namespace toile {
namespace svg_test {

std::string svg(const std::string& content, const std::string& attributes = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" " +
         attributes + ">" + content + "</svg>";
}

SvgDrawing read(const std::string& content, const std::string& attributes = "") {
  return parse_svg(svg(content, attributes), "x.svg");
}

std::string message_of(const std::string& text) {
  try {
    parse_svg(text, "x.svg");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Where the first line of the drawing ends.
Vec2 tip(const SvgDrawing& drawing) { return drawing.shapes.at(0).paths.at(0).segments.at(0).end; }

std::vector<std::string> ids(const SvgDrawing& drawing) {
  std::vector<std::string> all;
  for (const SvgShape& shape : drawing.shapes) all.push_back(shape.id);
  return all;
}

TEST(Svg, UnitsOfTheDrawing) {
  const double pixel = 0.0254 / 96;
  struct Case {
    std::string attributes;
    double metres;
    bool physical;
  };
  for (const Case& one :
       {Case{R"(width="200mm" height="100mm" viewBox="0 0 200 100")", 1e-3, true},
        Case{R"(width="20cm" viewBox="0 0 200 100")", 1e-3, true},
        Case{R"(width="10in" height="5in" viewBox="0 0 100 50")", 2.54e-3, true},
        Case{R"(width="720pt" viewBox="0 0 10 10")", 0.0254, true},
        Case{R"(width="960px" viewBox="0 0 10 10")", 0.0254, false},
        Case{R"(width="960" height="960" viewBox="0 0 480 480")", 2 * pixel, false},
        Case{R"(viewBox="0 0 480 480")", pixel, false},
        Case{R"(width="100%" height="100%" viewBox="0 0 480 480")", pixel, false},
        Case{R"(width="100mm" height="100mm")", pixel, true}, Case{"", pixel, false}}) {
    const SvgDrawing drawing = read("<line x2='1' y2='2'/>", one.attributes);
    EXPECT_NEAR(drawing.metres_per_unit.x(), one.metres, 1e-12) << one.attributes;
    EXPECT_NEAR(drawing.metres_per_unit.y(), one.metres, 1e-12) << one.attributes;
    EXPECT_EQ(drawing.physical, one.physical) << one.attributes;
    EXPECT_EQ(tip(drawing), Vec2(1, 2)) << one.attributes;
  }
  // The drawing fits the smaller side, unless it fills the frame or is stretched.
  const std::string wide =
      R"(width="200mm" height="400mm" viewBox="0 0 100 100" preserveAspectRatio=)";
  EXPECT_NEAR(read("", wide + "'xMidYMid'").metres_per_unit.y(), 2e-3, 1e-12);
  EXPECT_NEAR(read("", wide + "'xMidYMid slice'").metres_per_unit.y(), 4e-3, 1e-12);
  EXPECT_NEAR(read("", wide + "'none'").metres_per_unit.x(), 2e-3, 1e-12);
  EXPECT_NEAR(read("", wide + "'none'").metres_per_unit.y(), 4e-3, 1e-12);
}

TEST(Svg, TransformsOfAllKinds) {
  const auto moved = [](const std::string& transform) {
    return tip(read("<g transform='" + transform + "'><line x2='1' y2='2'/></g>"));
  };
  EXPECT_TRUE(moved("translate(3,4)").isApprox(Vec2(4, 6)));
  EXPECT_TRUE(moved("translate(3)").isApprox(Vec2(4, 2)));
  EXPECT_TRUE(moved("scale(2)").isApprox(Vec2(2, 4)));
  EXPECT_TRUE(moved("scale(2,-1)").isApprox(Vec2(2, -2)));
  EXPECT_TRUE(moved("rotate(90)").isApprox(Vec2(-2, 1)));
  EXPECT_TRUE(moved("rotate(90 1 2)").isApprox(Vec2(1, 2)));
  EXPECT_TRUE(moved("skewX(45)").isApprox(Vec2(3, 2)));
  EXPECT_TRUE(moved("skewY(45)").isApprox(Vec2(1, 3)));
  EXPECT_TRUE(moved("matrix(1 2 3 4 5 6)").isApprox(Vec2(12, 16)));
  EXPECT_TRUE(moved("translate(10) scale(2),rotate(90)").isApprox(Vec2(6, 2)));
  EXPECT_NE(message_of(svg("<g transform='turn(3)'/>")), "");
  EXPECT_NE(message_of(svg("<g transform='scale(nan)'/>")), "");
}

TEST(Svg, NestedDrawingsSymbolsAndUses) {
  const std::string inner =
      "<svg x='10' y='20' width='100' height='50' viewBox='0 0 10 10'>"
      "<line x2='1' y2='2'/></svg>";
  // 50 is the smaller side: a scale of 5, in the middle of the 100.
  EXPECT_TRUE(tip(read(inner)).isApprox(Vec2(10 + 25 + 5, 20 + 10)));
  const SvgDrawing used = read(
      "<defs><line id='l' x2='1' y2='2'/></defs>"
      "<symbol id='s' viewBox='0 0 10 10'><line x2='1' y2='2'/></symbol>"
      "<g id='in'><use xlink:href='#l' x='5' y='6' transform='scale(2)'/></g>"
      "<use href='#s' width='20' height='20'/>");
  ASSERT_EQ(used.shapes.size(), 2u);
  EXPECT_TRUE(tip(used).isApprox(Vec2(12, 16)));
  EXPECT_TRUE(used.uses.at(0).at.isApprox(Vec2(10, 12)));
  EXPECT_EQ(used.uses[0].target, "l");
  EXPECT_EQ(used.groups.at(static_cast<std::size_t>(used.shapes[0].group)).id, "in");
  EXPECT_TRUE(used.shapes[1].paths[0].segments[0].end.isApprox(Vec2(2, 4)));
}

TEST(Svg, WhatIsHiddenOrOnlyDefinedIsNotDrawn) {
  const std::string lines =
      "<style>.gone { display: none } g.unseen, #never {visibility:hidden}\n"
      "@media print { #shown { display:none } } /* .mark{display:none} */"
      "path.gone.back { display: inline }</style>"
      "<line id='shown' x2='1' class='mark'/>"
      "<line id='a' x2='1' display='none'/><g style='display:none'><line id='b' x2='1'/></g>"
      "<line id='c' x2='1' class='other gone'/><g class='unseen'><line id='d' x2='1'/>"
      "<line id='seen' x2='1' visibility='visible'/></g><line id='never' x2='1'/>"
      "<line id='e' x2='1' style='fill:none; visibility : hidden'/>"
      "<path id='back' class='gone back' d='M0 0h1'/>"
      "<line id='inline' class='gone' style='display:inline' x2='1'/>"
      "<clipPath><rect id='f' width='1' height='1'/></clipPath><marker><path d='M0 0h1'/></marker>"
      "<mask><rect width='1' height='1'/></mask><pattern><rect width='1' height='1'/></pattern>"
      "<symbol><rect width='1' height='1'/></symbol><defs><rect width='1' height='1'/></defs>"
      "<script>alert(1)</script><image/><image/>";
  const SvgDrawing drawing = read(lines);
  EXPECT_EQ(ids(drawing), (std::vector<std::string>{"shown", "seen", "back", "inline"}));
  EXPECT_EQ(drawing.ignored.at("image"), 2);
  EXPECT_EQ(drawing.ignored.at("script"), 1);
}

TEST(Svg, NamesOfShapesGroupsAndTexts) {
  const SvgDrawing drawing = read(
      "<g id='layer1' inkscape:groupmode='layer' inkscape:label='Front &amp; back'>"
      "<path id='p' class='fabric sa' inkscape:label='Yoke' marker-start='url(#a)' "
      "style='marker-end:url(\"#b\")' d='M0 0h5v5z'><title>The yoke</title></path>"
      "<text transform='translate(1 0)'><tspan x='2' y='3'>Cut\n  2</tspan><tspan>of "
      "it</tspan></text>"
      "<text><textPath xlink:href='#p'>along</textPath></text></g>");
  ASSERT_EQ(drawing.shapes.size(), 1u);
  const SvgShape& shape = drawing.shapes[0];
  EXPECT_EQ(shape.label, "Yoke");
  EXPECT_EQ(shape.title, "The yoke");
  EXPECT_EQ(shape.classes, (std::vector<std::string>{"fabric", "sa"}));
  EXPECT_EQ(shape.marker_start, "a");
  EXPECT_EQ(shape.marker_end, "b");
  EXPECT_EQ(drawing.groups[static_cast<std::size_t>(shape.group)].label, "Front & back");
  ASSERT_EQ(drawing.texts.size(), 2u);
  EXPECT_EQ(drawing.texts[0].text, "Cut 2 of it");
  EXPECT_EQ(drawing.texts[0].at, Vec2(3, 3));
  EXPECT_EQ(drawing.texts[1].on_path, "p");
}

TEST(Svg, BasicShapesAndPrefixes) {
  const SvgDrawing drawing = parse_svg(
      "<s:svg xmlns:s='http://www.w3.org/2000/svg' viewBox='0 0 200 100'>"
      "<s:rect width='50%' height='10'/><s:circle r='5'/><s:ellipse rx='2' ry='3'/>"
      "<s:polyline points='0,0 1,1 2 0'/><s:polygon points='0 0 1 1 2,0'/><s:rect width='0' "
      "height='5'/>"
      "<other/></s:svg>",
      "x.svg");
  ASSERT_EQ(drawing.shapes.size(), 5u);
  EXPECT_EQ(tip(drawing), Vec2(100, 0));
  EXPECT_TRUE(drawing.shapes[1].paths[0].closed);
  EXPECT_FALSE(drawing.shapes[3].paths[0].closed);
  EXPECT_TRUE(drawing.shapes[4].paths[0].closed);
}

TEST(Svg, ErrorsNameLineAndElement) {
  const std::string message = message_of(svg("\n<circle id='arm'\n r='5furlong'/>"));
  EXPECT_NE(message.find("x.svg:2: circle 'arm': "), std::string::npos) << message;
  EXPECT_NE(message_of("<html/>").find("is no SVG"), std::string::npos);
  EXPECT_NE(message_of("").find("is no XML"), std::string::npos);
  EXPECT_NE(message_of(svg("").substr(0, 60)).find("is no XML"), std::string::npos);
  EXPECT_NE(message_of(svg("<line x2='1e7'/>")).find("beyond 1,000,000"), std::string::npos);
  EXPECT_NE(message_of(svg("<line x2='5furlong'/>")), "");
  EXPECT_NE(message_of(svg("", "viewBox='0 0 0 5'")), "");
  EXPECT_NE(message_of(svg("", "width='-5mm'")), "");
}

TEST(Svg, PathsThatCannotBeReadAreKeptWithTheirError) {
  const SvgDrawing drawing =
      parse_svg(svg("\n<path id='arm'\n d='M0 0L1'/><polygon points='1'/>"), "x.svg");
  ASSERT_EQ(drawing.shapes.size(), 2u);
  const SvgShape& arm = drawing.shapes[0];
  EXPECT_TRUE(arm.paths.empty());
  const std::string message = arm.unreadable.value().what();
  EXPECT_NE(message.find("x.svg:2: path 'arm': "), std::string::npos) << message;
  EXPECT_TRUE(drawing.shapes[1].unreadable);
}

TEST(Svg, UsesThatDrawThemselvesAreRefused) {
  const std::string own = message_of(svg("<g id='a'><use href='#a'/></g>"));
  EXPECT_NE(own.find("draws itself"), std::string::npos) << own;
  const std::string ring =
      message_of(svg("<defs><g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g></defs>"
                     "<use href='#a'/>"));
  EXPECT_NE(ring.find("draws itself"), std::string::npos) << ring;
  // Copies of copies: ten billion lines by twenty elements.
  std::string copies = "<defs><line id='l0' x2='1'/>";
  for (int i = 1; i <= 10; ++i) {
    const std::string use = "<use href='#l" + std::to_string(i - 1) + "'/>";
    copies += "<g id='l" + std::to_string(i) + "'>";
    for (int k = 0; k < 10; ++k) copies += use;
    copies += "</g>";
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_NE(message_of(svg(copies + "</defs><use href='#l10'/>")).find("500,000"),
            std::string::npos);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(Svg, EntitiesAreNeverReplaced) {
  const std::string bomb =
      "<!DOCTYPE svg [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;&a;\">]>" + svg("<text>&b;</text>");
  EXPECT_NE(message_of(bomb).find("declares entities"), std::string::npos);
  const std::string outside =
      "<!DOCTYPE svg [<!ENTITY a SYSTEM \"file:///etc/passwd\">]>" + svg("<text>&a;</text>");
  EXPECT_NE(message_of(outside).find("declares entities"), std::string::npos);
  // Illustrator declares its namespaces so.
  const std::string plain =
      "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"svg11.dtd\" "
      "[<!ENTITY ns_svg \"http://www.w3.org/2000/svg\">]>" +
      svg("<line x2='1'/>");
  EXPECT_EQ(message_of(plain), "");
}

TEST(Svg, DeepDrawingsAreRefused) {
  for (const int depth : {300, 100'000}) {
    std::string deep;
    for (int i = 0; i < depth; ++i) deep += "<g>";
    for (int i = 0; i < depth; ++i) deep += "</g>";
    EXPECT_NE(message_of(svg(deep)).find("elements deep"), std::string::npos) << depth;
  }
}

}  // namespace svg_test
}  // namespace toile
