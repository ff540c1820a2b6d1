#include "io/dxf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <random>

#include "geometry/error.h"
#include "io/output_file.h"
#include "tests/pattern/import/dxf_samples.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace dxf_test {

using namespace samples;

std::string drawing(const std::string& name) {
  return read_file(std::filesystem::path(TOILE_SOURCE_DIR) / "tests/io/drawings" / name);
}

std::string dxf_error(const std::string& text) {
  return error_of([&] { parse_dxf(text, "a.dxf"); });
}

/// The area under a chain of cubic curves, by Green's theorem on fine chords.
double area_of(const std::vector<DxfCurve>& curves) {
  double twice = 0;
  for (const DxfCurve& curve : curves) {
    const auto& p = curve.points;
    Vec2 last = p[0];
    for (int i = 1; i <= 400; ++i) {
      const double t = i / 400.0;
      const double s = 1 - t;
      const Vec2 next =
          s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
      twice += last.x() * next.y() - last.y() * next.x();
      last = next;
    }
  }
  return twice / 2;
}

TEST(Dxf, UnitsAreThoseOfTheHeader) {
  // By the codes of $INSUNITS in Autodesk's DXF reference.
  const std::map<int, double> metres = {{0, 0},       {1, 0.0254}, {2, 0.3048},  {4, 1e-3},
                                        {5, 1e-2},    {6, 1},      {8, 2.54e-8}, {9, 2.54e-5},
                                        {10, 0.9144}, {13, 1e-6},  {14, 0.1}};
  for (const auto& [code, metre] : metres) {
    const std::string text = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + std::to_string(code) +
                             "\n0\nENDSEC\n0\nEOF\n";
    EXPECT_DOUBLE_EQ(parse_dxf(text, "unit.dxf").unit_metres, metre) << code;
  }
}

TEST(Dxf, ReadsEveryVersionAndItsText) {
  const double quarter = std::numbers::pi * 100 * 100 / 4;
  for (const char* name : {"r12.dxf", "r2000.dxf", "r2007.dxf", "r2013.dxf"}) {
    const DxfDrawing read = parse_dxf(drawing(name), name);
    // R12 has no $INSUNITS.
    EXPECT_DOUBLE_EQ(read.unit_metres, read.version == "AC1009" ? 0 : 1e-3) << name;
    ASSERT_EQ(read.blocks.size(), 1u) << name;
    const DxfBlock& block = read.blocks[0];
    EXPECT_EQ(block.name, "FRONT");
    std::string texts;
    for (const DxfEntity& entity : block.entities) {
      if (entity.kind == DxfEntity::Kind::text) texts += entity.text + "|";
    }
    EXPECT_EQ(texts,
              "Piece Name: Vorderteil Gr\u00f6\u00dfe|Quantity: 1|Size: M|Material: K\u00f6per|")
        << name;
    ASSERT_EQ(block.entities[0].layer, "1");
    EXPECT_NEAR(area_of(block.entities[0].curves), 300 * 600 - 100 * 100 - quarter, 1) << name;
    ASSERT_EQ(read.entities.size(), 2u);
    EXPECT_EQ(read.entities[0].text, "Sample Size: M");
    const DxfEntity& insert = read.entities[1];
    ASSERT_EQ(insert.kind, DxfEntity::Kind::insert);
    const Vec2 corner = insert.placed * Vec2(300, 0);
    EXPECT_NEAR(corner.x(), 1000 + 300 * std::cos(std::numbers::pi / 6), 1e-9);
    EXPECT_NEAR(corner.y(), 150, 1e-9);
  }
}

TEST(Dxf, ArcsAndCirclesKeepTheirRadius) {
  const DxfDrawing read = parse_dxf(
      dxf_file("", group(0, "ARC") + group(8, "1") + group(10, 5) + group(20, 7) + group(40, 100) +
                       group(50, 350) + group(51, 100) + group(0, "CIRCLE") + group(8, "1") +
                       group(10, 5) + group(20, 7) + group(40, 3)),
      "a.dxf");
  ASSERT_EQ(read.entities.size(), 2u);
  const auto& arc = read.entities[0].curves;
  EXPECT_NEAR(arc.front().points[0].x(), 5 + 100 * std::cos(-std::numbers::pi / 18), 1e-9);
  EXPECT_NEAR(arc.back().points[3].y(), 7 + 100 * std::sin(100 * std::numbers::pi / 180), 1e-9);
  for (const DxfCurve& curve : arc) {
    const auto& p = curve.points;
    const Vec2 middle = (p[0] + 3 * p[1] + 3 * p[2] + p[3]) / 8;
    EXPECT_NEAR((middle - Vec2(5, 7)).norm(), 100, 1e-5);
  }
  EXPECT_NEAR(area_of(read.entities[1].curves), std::numbers::pi * 9, 1e-3);
  EXPECT_EQ(read.entities[1].curves.front().points[0], read.entities[1].curves.back().points[3]);
}

TEST(Dxf, WhatIsDrawnFromBehindIsMirrored) {
  const std::string behind = group(210, 0) + group(220, 0) + group(230, -1);
  const DxfDrawing read =
      parse_dxf(dxf_file("", dxf_polyline("1", rectangle(10, 0, 20, 30)) + behind +
                                 dxf_segment("1", {1, 2}, {3, 4}) + behind),
                "a.dxf");
  ASSERT_EQ(read.entities.size(), 2u);
  EXPECT_EQ(read.entities[0].curves[0].points[0], Vec2(-10, 0));
  // A line is in the drawing's own coordinates, whichever way it faces.
  EXPECT_EQ(read.entities[1].curves[0].points[0], Vec2(1, 2));
  const DxfDrawing tilted =
      parse_dxf(dxf_file("", dxf_polyline("1", rectangle(0, 0, 1, 1)) + group(230, 0.5)), "a.dxf");
  EXPECT_TRUE(tilted.entities.empty());
  EXPECT_EQ(tilted.ignored.at("tilted out of the plane"), 1);
}

TEST(Dxf, BlocksOfOneNameAreInsertedInTurn) {
  const std::string blocks = dxf_block("DETAIL", dxf_segment("1", {0, 0}, {1, 0})) +
                             dxf_block("DETAIL", dxf_segment("1", {0, 0}, {2, 0}));
  const DxfDrawing read =
      parse_dxf(dxf_file(blocks, dxf_insert("DETAIL", {0, 0}) + dxf_insert("DETAIL", {5, 5}) +
                                     dxf_insert("NONE", {0, 0})),
                "a.dxf");
  ASSERT_EQ(read.entities.size(), 2u);
  EXPECT_EQ(read.entities[0].block, 0);
  EXPECT_EQ(read.entities[1].block, 1);
  EXPECT_EQ(read.ignored.at("INSERT of a missing block"), 1);
}

TEST(Dxf, TextIsInTheHeadersCodePage) {
  const std::string header = "9\n$ACADVER\n1\nAC1009\n9\n$DWGCODEPAGE\n3\nANSI_1251\n";
  const DxfDrawing read =
      parse_dxf(dxf_file("", dxf_label("\xCF\xE5\xF0\xE5\xE4"), header), "a.dxf");
  EXPECT_EQ(read.entities.at(0).text, "\u041f\u0435\u0440\u0435\u0434");
}

TEST(Dxf, ADeclaredPageOfTwoBytesIsHeeded) {
  const std::string header = "9\n$ACADVER\n1\nAC1009\n9\n$DWGCODEPAGE\n3\nANSI_936\n";
  const auto text_of = [&](const std::string& bytes) {
    return parse_dxf(dxf_file("", dxf_label(bytes), header), "a.dxf").entities.at(0).text;
  };
  // All by itself, this word would be UTF-8, too.
  EXPECT_EQ(text_of("\xC7\xB0\xC6\xAC"), "\u524d\u7247");
  // Some programs declare a page and write UTF-8.
  EXPECT_EQ(text_of("\u524d\u7247"), "\u524d\u7247");
}

TEST(Dxf, SaysWhatIsWrongAndWhere) {
  EXPECT_HOLDS(dxf_error("0\nSECTION\n2\nENTITIES\n0\nLINE\n"), "a.dxf:6: the file ends before");
  EXPECT_HOLDS(dxf_error("0\nSECTION\n2\nENTITIES\nx\nLINE\n"), "a.dxf:5: 'x' is no group code");
  EXPECT_HOLDS(dxf_error("hello\nworld\n"), "is no group code");
  EXPECT_HOLDS(dxf_error("AutoCAD Binary DXF\r\n\x1a"), "is a binary DXF; save it as text");
  EXPECT_HOLDS(dxf_error("AC1027"), "is a DWG file");
  EXPECT_HOLDS(dxf_error(dxf_file("", dxf_segment("1", {0, 0}, {1, 1}) + group(10, "nan"))),
               "'nan' is no number");
  EXPECT_HOLDS(dxf_error(dxf_file("", dxf_segment("1", {0, 0}, {1, 1}) + group(10, "1e30"))),
               "beyond 1,000,000,000 units");
  EXPECT_HOLDS(
      dxf_error(dxf_file("", group(0, "SPLINE") + group(71, "3") + group(10, 0) + group(20, 0))),
      "a spline has too few control points");
  EXPECT_HOLDS(
      dxf_error(dxf_file(dxf_block("B", ""), dxf_insert("B", {0, 0}, "70\n100000\n71\n100000\n"))),
      "more than 300000 entities");
}

TEST(Dxf, MillionsOfEntitiesAreRefusedAtOnce) {
  std::string many;
  const std::string point = dxf_point("1", {1, 2});
  for (int i = 0; i < 400'000; ++i) many += point;
  EXPECT_HOLDS(dxf_error(dxf_file("", many)), "more than 300000 entities");
}

TEST(Dxf, DamagedFilesAreReadOrRefusedButNeverCrash) {
  std::mt19937 random(7);
  const std::vector<std::string> files = {drawing("r12.dxf"), drawing("r2013.dxf")};
  int refused = 0;
  for (int i = 0; i < 600; ++i) {
    std::string text = files[random() % files.size()];
    const std::size_t at = random() % text.size();
    switch (random() % 4) {
      case 0:
        text.resize(at);
        break;
      case 1:
        for (int k = 0; k < 6; ++k)
          text[random() % text.size()] ^= static_cast<char>(1 << random() % 8);
        break;
      case 2:
        text.erase(at, random() % 40);
        break;
      default:
        text.insert(at, "1e308\n-1\n\n0\n");
    }
    try {
      parse_dxf(text, "a.dxf");
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 200);
}

TEST(Dxf, IsToldByItsBeginning) {
  EXPECT_TRUE(looks_like_dxf("  0\r\nSECTION\r\n"));
  EXPECT_TRUE(looks_like_dxf("999\nmade by hand\n"));
  EXPECT_TRUE(looks_like_dxf("AutoCAD Binary DXF\r\n"));
  EXPECT_FALSE(looks_like_dxf("{\"pattern\": 0}"));
  EXPECT_FALSE(looks_like_dxf("0\nhello\n"));
}

}  // namespace dxf_test
}  // namespace toile
