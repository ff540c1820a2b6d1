#include "pattern/import/imported_pattern.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "io/output_file.h"
#include "pattern/file/pattern_file.h"
#include "pattern/import/dxf_pieces.h"
#include "pattern/import/join_paths.h"
#include "tests/pattern/import/dxf_samples.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace imported_pattern_test {

using namespace samples;

struct Imported {
  ImportedPattern made;
  Pattern read;  ///< what was written, read again
  std::string remarks;
};

Imported import_text(const std::string& text, const ImportOptions& options = {},
                     const DrawingOptions& drawn = {}) {
  Imported result;
  std::vector<Remark> remarks;
  result.made =
      import_pieces(dxf_pieces(parse_dxf(text, "a.dxf"), "a.dxf", drawn), options, remarks);
  for (const Remark& remark : remarks) result.remarks += remark.text + "\n";
  std::vector<Remark> later;
  result.read = parse_pattern(readable_json(pattern_json(result.made)), "a.json", later);
  return result;
}

std::vector<Vec2> outline_of(const PatternPanel& panel) {
  std::vector<Vec2> points;
  for (const OutlineStep& step : panel.outline) {
    std::vector<Vec2> more = panel.edges[static_cast<std::size_t>(step.edge)].curve.sample(200);
    if (!step.forward) std::reverse(more.begin(), more.end());
    points.insert(points.end(), more.begin(), more.end() - 1);
  }
  return points;
}

double farthest_from(const std::vector<Vec2>& points, const std::vector<Vec2>& loop) {
  double most = 0;
  for (const Vec2& point : points) {
    double least = 1e9;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      least = std::min(least, distance_to_segment(point, loop[i], loop[(i + 1) % loop.size()]));
    }
    most = std::max(most, least);
  }
  return most;
}

const std::string square = dxf_polyline("1", rectangle(0, 0, 300, 400));

TEST(ImportedPattern, ASquareIsFourStraightEdges) {
  const Imported result =
      import_text(dxf_file(dxf_block("FRONT", square + dxf_segment("7", {10, 10}, {10, 60})), ""));
  ASSERT_EQ(result.read.panels.size(), 1u);
  const PatternPanel& panel = result.read.panels[0];
  EXPECT_EQ(panel.name, "FRONT");
  ASSERT_EQ(panel.edges.size(), 4u);
  for (const PatternEdge& edge : panel.edges) EXPECT_TRUE(edge.curve.straight());
  EXPECT_NEAR(signed_area(outline_of(panel)), 0.12, 1e-9);
  EXPECT_NEAR(panel.grain, 0, 1e-6);
}

TEST(ImportedPattern, NotchesCutEdgesAndAreKept) {
  const Imported result = import_text(
      dxf_file(dxf_block("FRONT", square + dxf_point("4", {300, 150}, "50\n180\n") +
                                      dxf_point("4", {299, 399}) + dxf_point("4", {150, 200})),
               ""));
  const PatternPanel& panel = result.read.panels[0];
  ASSERT_EQ(panel.edges.size(), 5u);
  ASSERT_EQ(panel.notches.size(), 2u);
  EXPECT_TRUE(panel.notches[0].at.isApprox(Vec2(0.3, 0.15), 1e-9));
  EXPECT_NEAR(panel.notches[0].angle.value(), std::numbers::pi, 1e-6);
  EXPECT_TRUE(panel.notches[1].at.isApprox(Vec2(0.3, 0.4), 1e-9));
  EXPECT_HOLDS(result.remarks, "1 notches are more than 6 cm from its outline");
}

TEST(ImportedPattern, AHalfIsUnfolded) {
  // Half a front: its neck is a quarter circle of radius 100 about (0, 600).
  std::vector<Vec2> half = {{0, 0}, {250, 0}, {250, 600}, {100, 600}};
  for (int i = 1; i <= 45; ++i) {
    const double angle = -i * std::numbers::pi / 90;
    half.emplace_back(100 * std::cos(angle), 600 + 100 * std::sin(angle));
  }
  const Imported result = import_text(
      dxf_file(dxf_block("FRONT", dxf_polyline("1", half) + dxf_segment("6", {0, 0}, {0, 500}) +
                                      dxf_point("4", {250, 300}) + dxf_point("13", {50, 50})),
               ""));
  const PatternPanel& panel = result.read.panels[0];
  const double expected = 0.5 * 0.6 - std::numbers::pi * 0.01 / 2;
  EXPECT_NEAR(signed_area(outline_of(panel)), expected, 1e-3 * expected);
  // The neck and the hem are one edge each; each side is cut at its notch.
  EXPECT_EQ(panel.edges.size(), 8u);
  EXPECT_EQ(panel.notches.size(), 2u);
  EXPECT_EQ(panel.drill_holes.size(), 2u);
  double neck = 0;
  for (const PatternEdge& edge : panel.edges) {
    if (!edge.curve.straight()) neck = edge.curve.length();
  }
  EXPECT_NEAR(neck, std::numbers::pi * 0.1, 2e-4);
}

TEST(ImportedPattern, ACurveThatLeavesTheFoldGentlyIsKept) {
  // A half circle on a square of 200 mm: its start runs along the fold at first.
  std::vector<Vec2> half = {{0, 0}, {200, 0}};
  for (int i = 0; i <= 180; ++i) {
    const double angle = i * std::numbers::pi / 180;
    half.emplace_back(100 + 100 * std::cos(angle), 200 + 100 * std::sin(angle));
  }
  const Imported result = import_text(
      dxf_file(dxf_block("F", dxf_polyline("1", half) + dxf_segment("6", {0, 0}, {0, 200})), ""));
  const double expected = 2 * (0.04 + std::numbers::pi * 0.01 / 2);
  EXPECT_NEAR(signed_area(outline_of(result.read.panels[0])), expected, 3e-4 * expected);
}

TEST(ImportedPattern, AWholePieceWithAMirrorLineStaysWhole) {
  const Imported result =
      import_text(dxf_file(dxf_block("F", square + dxf_segment("6", {150, 0}, {150, 400})), ""));
  EXPECT_NEAR(signed_area(outline_of(result.read.panels[0])), 0.12, 1e-9);
  EXPECT_HOLDS(result.remarks, "lies on both sides of its mirror line");
  EXPECT_HOLDS(
      error_of([&] {
        import_text(dxf_file(dxf_block("F", square + dxf_segment("6", {-50, 0}, {-50, 400})), ""));
      }),
      "does not run along its mirror line");
}

TEST(ImportedPattern, APairIsLeftAndRight) {
  const std::string sleeve = dxf_polyline("1", {{0, 0}, {300, 0}, {250, 400}, {0, 400}});
  const Imported result =
      import_text(dxf_file(dxf_block("SLEEVE", sleeve + dxf_label("Quantity: 1,1") +
                                                   dxf_segment("7", {100, 0}, {200, 300})),
                           ""));
  ASSERT_EQ(result.read.panels.size(), 2u);
  const PatternPanel& left = result.read.panels[0];
  const PatternPanel& right = result.read.panels[1];
  EXPECT_EQ(left.name, "left_SLEEVE");
  EXPECT_EQ(right.name, "right_SLEEVE");
  EXPECT_EQ(left.quantity, 1);
  EXPECT_NEAR(signed_area(outline_of(left)), signed_area(outline_of(right)), 1e-9);
  EXPECT_NEAR(left.grain, 0, 1e-6);
  EXPECT_NEAR(right.grain, 0, 1e-6);
  EXPECT_NEAR(result.made.panels[0].turned, std::atan2(100, 300), 1e-9);
}

TEST(ImportedPattern, ACountOfTwoIsAPairWhereTheShapeIsOneSided) {
  const std::string sleeve = dxf_polyline("1", {{0, 0}, {300, 0}, {250, 400}, {0, 400}});
  const auto panels = [](const std::string& name, const std::string& outline,
                         const std::string& texts, const ImportOptions& options = {}) {
    const std::string block = dxf_block(name, outline + texts);
    return import_text(dxf_file(block, ""), options).read.panels.size();
  };
  const std::string two = dxf_label("Quantity: 2");
  EXPECT_EQ(panels("S", sleeve, two), 2u);
  EXPECT_EQ(panels("S", sleeve, dxf_label("Quantity: 3")), 1u);
  EXPECT_EQ(panels("S", sleeve, dxf_label("Quantity: 2,0")), 1u);
  EXPECT_EQ(panels("left_S", sleeve, two), 1u);
  ImportOptions single;
  single.singles = {"S"};
  EXPECT_EQ(panels("S", sleeve, two, single), 1u);
  // Of its own mirror image it is one what is said of mirroring.
  for (const char* count : {"Quantity: 2", "Quantity: 2,0", "Quantity: 1,1"}) {
    EXPECT_EQ(panels("cuff", square, dxf_label(count)), 2u) << count;
    EXPECT_EQ(panels("K7", square, dxf_label(count) + dxf_label("Category: collar")), 1u) << count;
  }
}

TEST(ImportedPattern, TwoAlikeLayersAcrossTheMiddleAreOnePanel) {
  const auto piece = [](const std::string& name, const std::string& outline) {
    return dxf_file(dxf_block(name, outline + dxf_label("Quantity: 1,1")), "");
  };
  const std::string slanted = dxf_polyline("1", {{0, 0}, {300, 0}, {320, 90}, {0, 100}});
  const Imported yoke = import_text(piece("backYoke", square));
  ASSERT_EQ(yoke.made.panels.size(), 1u);
  EXPECT_EQ(yoke.made.panels[0].name, "backYoke");
  EXPECT_EQ(yoke.made.panels[0].quantity, 2);
  EXPECT_NE(yoke.remarks.find("cut 2 times: its layers are drawn as one panel"), std::string::npos);
  for (const char* name : {"Hemdkragen", "hoodCenter"}) {
    EXPECT_EQ(import_text(piece(name, square)).made.panels.size(), 1u) << name;
  }
  ImportOptions asked;
  asked.pairs = {"backYoke"};
  for (const Imported& pair :
       {import_text(piece("backYoke", square), asked), import_text(piece("cuff", square)),
        import_text(piece("frontYoke", slanted)), import_text(piece("hoodSide", slanted))}) {
    ASSERT_EQ(pair.made.panels.size(), 2u);
    EXPECT_EQ(pair.made.panels[0].name.substr(0, 5), "left_");
    EXPECT_EQ(pair.remarks.find("layers"), std::string::npos);
  }
}

TEST(ImportedPattern, SeamAllowanceIsTakenOff) {
  ImportOptions options;
  options.seam_allowance = 0.01;
  const Imported result =
      import_text(dxf_file(dxf_block("F", square + dxf_point("4", {300, 150})), ""), options);
  const PatternPanel& panel = result.read.panels[0];
  EXPECT_NEAR(signed_area(outline_of(panel)), 0.28 * 0.38, 1e-9);
  EXPECT_EQ(panel.edges.size(), 5u);
  EXPECT_NEAR(panel.notches[0].at.x(), 0.29, 1e-9);
  options.seam_allowance = 0.2;
  EXPECT_HOLDS(error_of([&] { import_text(dxf_file(dxf_block("F", square), ""), options); }),
               "nothing is left of it without its seam allowance");
}

TEST(ImportedPattern, PointsOfOtherLinesAreNoCorners) {
  // The right side is hollow: it turns by 15 degrees at half its height.
  const std::vector<Vec2> outline = {{0, 0}, {300, 0}, {273.7, 200}, {300, 400}, {0, 400}};
  std::string drawn =
      dxf_polyline("1", outline) + dxf_polyline("7", {{100, 100}, {100, 300}}, false);
  for (const Vec2& corner : outline) drawn += dxf_point("2", corner);
  // The ends of a stripe, of a grain line and of a line for stitches beside the hem.
  for (const Vec2& end : {Vec2(0, 250), Vec2(286, 250), Vec2(150, 380), Vec2(100, 12)}) {
    drawn += dxf_point("2", end);
  }
  const std::string text = dxf_file(dxf_block("F", drawn), "");
  ImportOptions options;
  EXPECT_EQ(import_text(text, options).read.panels[0].edges.size(), 5u);
  options.seam_allowance = 0.01;
  const PatternPanel panel = import_text(text, options).read.panels[0];
  EXPECT_EQ(panel.edges.size(), 5u);
  EXPECT_TRUE(std::any_of(panel.edges.begin(), panel.edges.end(), [](const PatternEdge& edge) {
    return (edge.curve.start() - Vec2(0.2636, 0.2)).norm() < 1e-4;
  }));
}

TEST(ImportedPattern, TakesTheSizeThatIsAskedFor) {
  std::string blocks;
  for (const int size : {36, 38, 40}) {
    blocks +=
        dxf_block("F" + std::to_string(size), dxf_polyline("1", rectangle(0, 0, 5 * size, 400)) +
                                                  dxf_label("Piece Name: F") +
                                                  dxf_label("Size: " + std::to_string(size)));
  }
  const std::string text = dxf_file(blocks, dxf_label("Sample Size: 38"));
  const Imported base = import_text(text);
  ASSERT_EQ(base.read.panels.size(), 1u);
  EXPECT_NEAR(signed_area(outline_of(base.read.panels[0])), 0.19 * 0.4, 1e-9);
  EXPECT_HOLDS(base.remarks, "size '38' is taken, the base size of 36, 38, 40");
  ImportOptions options;
  options.size = "40";
  EXPECT_NEAR(signed_area(outline_of(import_text(text, options).read.panels[0])), 0.2 * 0.4, 1e-9);
  options.size = "XL";
  EXPECT_HOLDS(error_of([&] { import_text(text, options); }),
               "has no size 'XL'; its sizes are 36, 38, 40");
}

TEST(ImportedPattern, APieceThatCannotBeAPanelIsLeftOut) {
  const std::string bow =
      dxf_block("BOW", dxf_polyline("1", {{0, 0}, {300, 300}, {300, 0}, {0, 300}}));
  const std::string open = dxf_block("OPEN", dxf_polyline("1", rectangle(0, 0, 200, 300), false));
  const std::string small = dxf_block("SMALL", dxf_polyline("1", rectangle(0, 0, 200, 15)));
  const std::string text = dxf_file(bow + dxf_block("FRONT", square) + open + small, "");
  ImportOptions options;
  options.seam_allowance = 0.01;
  const Imported result = import_text(text, options);
  ASSERT_EQ(result.read.panels.size(), 1u);
  EXPECT_EQ(result.read.panels[0].name, "FRONT");
  std::vector<std::string> names;
  for (const LeftOutPiece& piece : result.made.left_out) names.push_back(piece.name);
  EXPECT_EQ(names, (std::vector<std::string>{"OPEN", "BOW", "SMALL"}));
  EXPECT_HOLDS(result.remarks, "piece 'OPEN': its boundary is open: a gap of 300 mm");
  EXPECT_HOLDS(result.remarks, "piece 'BOW': its outline crosses or touches itself");
  EXPECT_HOLDS(result.remarks, "piece 'SMALL': nothing is left of it without its seam allowance");
  // What nobody wants is not missed.
  options.without = {"OPEN", "BOW", "SMALL"};
  EXPECT_TRUE(import_text(text, options).made.left_out.empty());
  options.without = {"FRONT"};
  EXPECT_HOLDS(error_of([&] { import_text(text, options); }), "a gap of 300 mm");
  options.without = {"BACK"};
  EXPECT_HOLDS(error_of([&] { import_text(text, options); }), "--without 'BACK': names no piece");
  EXPECT_HOLDS(error_of([&] { import_text(dxf_file(bow, "")); }), "crosses or touches itself");
}

TEST(ImportedPattern, AnOutlineThatAllButTouchesItselfIsNoEndlessSkeleton) {
  // A corner 1e-9 mm from the left side: turned by 30 degrees, it may lie on either side of it.
  ImportOptions options;
  options.seam_allowance = 0.008;
  for (int i = 0; i < 20; ++i) {
    const std::vector<Vec2> outline = {{0, 0}, {300, 0}, {1e-6, 111.1 + i}, {300, 400}, {0, 400}};
    const std::string text = dxf_file(
        dxf_block("F", dxf_polyline("1", outline) + dxf_segment("7", {100, 100}, {150, 187})), "");
    try {
      EXPECT_FALSE(first_crossing(outline_of(import_text(text, options).read.panels.at(0))));
    } catch (const Error& error) {
      EXPECT_HOLDS(error.what(), "piece 'F'");
    }
  }
}

TEST(ImportedPattern, RibbingStretchesAlongItsLongerSide) {
  const auto imported = [](const std::string& material, double width, double height) {
    PieceDrawing drawing;
    drawing.source = "a";
    Piece piece;
    piece.name = "cuff";
    piece.material = material;
    const Vec2 corners[] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    for (int i = 0; i < 4; ++i) {
      piece.outline.push_back(EdgeCurve::line(corners[i], corners[(i + 1) % 4]));
    }
    drawing.pieces = {piece};
    std::vector<Remark> remarks;
    return import_pieces(drawing, {}, remarks).panels.at(0);
  };
  const ImportedPanel upright = imported("ribbing", 0.1, 0.3);
  EXPECT_EQ(upright.fabric, "jersey");
  EXPECT_NEAR(upright.grain.value(), std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(imported("Bündchenware", 0.3, 0.1).grain.value(), 0, 1e-12);
  EXPECT_EQ(imported("fabric", 0.1, 0.3).fabric, "");
  EXPECT_FALSE(imported("fabric", 0.1, 0.3).grain);
}

TEST(ImportedPattern, PanelsOfOneNameAreToldApartAndLaidOut) {
  const Imported result =
      import_text(dxf_file(dxf_block("D#1\\x", square) + dxf_block("D#1\\x", square), ""));
  ASSERT_EQ(result.read.panels.size(), 2u);
  EXPECT_EQ(result.read.panels[0].name, "D_1_x");
  EXPECT_EQ(result.read.panels[1].name, "D_1_x_2");
  const std::vector<Vec2> first = outline_of(result.read.panels[0]);
  const std::vector<Vec2> second = outline_of(result.read.panels[1]);
  double right = 0;
  double left = 1e9;
  for (const Vec2& point : first) right = std::max(right, point.x());
  for (const Vec2& point : second) left = std::min(left, point.x());
  EXPECT_GT(left, right);
}

TEST(ImportedPattern, InnerLinesAreWrittenAndRead) {
  const Imported result = import_text(dxf_file(
      dxf_block("F", square + dxf_segment("8", {10, 10}, {50, 60}) + dxf_point("13", {30, 40}) +
                         dxf_polyline("11", rectangle(100, 100, 20, 30)) +
                         dxf_label("Material: Twill") + dxf_label("Quantity: 3")),
      ""));
  const PatternPanel& panel = result.read.panels[0];
  ASSERT_EQ(panel.internal_lines.size(), 1u);
  EXPECT_TRUE(panel.internal_lines[0][1].isApprox(Vec2(0.05, 0.06), 1e-9));
  ASSERT_EQ(panel.cut_outs.size(), 1u);
  EXPECT_NEAR(std::abs(signed_area(panel.cut_outs[0])), 6e-4, 1e-12);
  EXPECT_EQ(panel.drill_holes.size(), 1u);
  EXPECT_EQ(panel.material, "Twill");
  EXPECT_EQ(panel.quantity, 3);
}

TEST(ImportedPattern, EveryVersionOfDxfGivesThePieceThatWasDrawn) {
  const double expected = 0.3 * 0.6 - 0.01 - std::numbers::pi * 0.01 / 4;
  for (const char* name : {"r12.dxf", "r2000.dxf", "r2007.dxf", "r2013.dxf"}) {
    const Imported result = import_text(
        read_file(std::filesystem::path(TOILE_SOURCE_DIR) / "tests/io/drawings" / name));
    ASSERT_EQ(result.read.panels.size(), 1u) << name;
    const PatternPanel& panel = result.read.panels[0];
    EXPECT_EQ(panel.name, "Vorderteil Gr\u00f6\u00dfe");
    EXPECT_EQ(panel.material, "K\u00f6per");
    EXPECT_NEAR(signed_area(outline_of(panel)), expected, 1e-3 * expected);
    // The arc runs into the line above it without a corner.
    EXPECT_EQ(panel.edges.size(), 6u) << "five corners and a notch";
    // Inserted turned by 30 degrees, and its grain line is upright in the block.
    EXPECT_NEAR(result.made.panels[0].turned, -std::numbers::pi / 6, 1e-6);
    EXPECT_NEAR(panel.grain, 0, 1e-6);
    EXPECT_EQ(panel.cut_outs.size(), 1u);
  }
}

/// A drawing as Valentina writes it: halves of front and back, and no word of the fold.
Imported import_halves(const ImportOptions& options) {
  return import_text(
      read_file(std::filesystem::path(TOILE_SOURCE_DIR) / "tests/io/drawings/halves.dxf"), options);
}

TEST(ImportedPattern, HalvesWithoutAFoldAreNamedAndStayHalves) {
  const Imported result = import_halves({});
  EXPECT_EQ(result.read.panels.size(), 5u);
  for (const char* half : {"--unfold Detail_2:5", "--unfold Detail_3:5", "--unfold Detail_4:3"}) {
    EXPECT_HOLDS(result.remarks, half);
  }
  EXPECT_EQ(result.remarks.find("--unfold Detail:"), std::string::npos) << "the sleeve is whole";
  EXPECT_EQ(result.remarks.find("--unfold Detail_5"), std::string::npos) << "a band is whole";
}

TEST(ImportedPattern, HalvesAreUnfoldedPairedAndRenamedAsAsked) {
  const Imported plain = import_halves({});
  ImportOptions options;
  options.unfold = {"Detail_2", "Detail_3:5"};
  options.pairs = {"Detail"};
  options.names = {"Detail=sleeve", "Detail_2=front"};
  const Imported result = import_halves(options);
  std::vector<std::string> names;
  for (const PatternPanel& panel : result.read.panels) names.push_back(panel.name);
  EXPECT_EQ(names, (std::vector<std::string>{"left_sleeve", "right_sleeve", "front", "Detail_3",
                                             "Detail_4", "Detail_5"}));
  for (const auto& [whole, half] : {std::pair{2, 1}, std::pair{3, 2}}) {
    const std::vector<Vec2> outline = outline_of(result.read.panels[whole]);
    EXPECT_NEAR(signed_area(outline), 2 * signed_area(outline_of(plain.read.panels[half])), 1e-5);
    double low = 1e9;
    double high = -1e9;
    for (const Vec2& point : outline) {
      low = std::min(low, point.x());
      high = std::max(high, point.x());
    }
    EXPECT_NEAR(high - low, 0.52, 1e-6) << "twice the width of the half";
  }
  EXPECT_EQ(result.read.panels[0].quantity, 1);
  EXPECT_EQ(result.remarks.find("--unfold Detail_2"), std::string::npos);
}

TEST(ImportedPattern, WhatCannotBeUnfoldedIsNamed) {
  const auto message = [](const std::string& unfold, const std::string& pair = "",
                          const std::string& name = "") {
    ImportOptions options;
    if (!unfold.empty()) options.unfold = {unfold};
    if (!pair.empty()) options.pairs = {pair};
    if (!name.empty()) options.names = {name};
    return error_of([&] { import_halves(options); });
  };
  EXPECT_HOLDS(message("Detail_9"), "names no piece");
  EXPECT_HOLDS(message("Detail_2:9"), "has no edge 9");
  EXPECT_HOLDS(message("Detail_2:2"), "is curved");
  EXPECT_HOLDS(message("Detail"), "no straight edge along its grain");
  ImportOptions inner;
  inner.unfold = {"L:3"};
  const std::vector<Vec2> corner = {{0, 0}, {300, 0}, {300, 100}, {100, 100}, {100, 400}, {0, 400}};
  EXPECT_HOLDS(error_of([&] {
                 import_text(dxf_file(dxf_block("L", dxf_polyline("1", corner)), ""), inner);
               }),
               "lies on both sides of its edge 3");
  EXPECT_HOLDS(message("", "Detail:1"), "names an edge");
  EXPECT_HOLDS(message("", "", "front"), "names no piece and its new name");
}

TEST(ImportedPattern, ValentinasOutlinesAreKeptToATenthOfAMillimetre) {
  for (const char* name :
       {"bodice_block_aama_r12.dxf", "tshirt_aama_r12_sheet.dxf", "tshirt_aama_r14_details.dxf"}) {
    const auto path = real_pattern(std::string("../valentina/") + name);
    if (!path) GTEST_SKIP() << name << " is not in ../shared/data or TOILE_DATA";
    const std::string text = read_file(*path);
    const PieceDrawing drawing = dxf_pieces(parse_dxf(text, name), name, {});
    ImportOptions options;
    options.singles = {"BackPanel2", "BackPanel1"};  // both are cut twice
    if (drawing.pieces.size() > 2) options.singles.clear();
    const Imported result = import_text(text, options);
    ASSERT_EQ(result.read.panels.size(), drawing.pieces.size());
    for (std::size_t i = 0; i < drawing.pieces.size(); ++i) {
      std::vector<Vec2> drawn = loop_points(drawing.pieces[i].outline, 1e-6);
      const Eigen::Rotation2Dd turn(result.made.panels[i].turned);
      for (Vec2& point : drawn) point = turn * point + result.made.panels[i].moved;
      const std::vector<Vec2> made = outline_of(result.read.panels[i]);
      EXPECT_LT(farthest_from(drawn, made), 1e-4) << name << " " << i;
      EXPECT_LT(farthest_from(made, drawn), 1e-4) << name << " " << i;
      EXPECT_NEAR(signed_area(made), std::abs(signed_area(drawn)), 1e-3 * signed_area(made));
    }
  }
}

}  // namespace imported_pattern_test
}  // namespace toile
