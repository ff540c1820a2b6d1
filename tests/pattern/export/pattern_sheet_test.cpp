#include "pattern/export/pattern_sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/polygon.h"
#include "io/dxf.h"
#include "io/svg.h"
#include "pattern/file/pattern_file.h"
#include "pattern/import/dxf_pieces.h"
#include "pattern/import/join_paths.h"
#include "pattern/import/svg_pieces.h"
#include "pattern/mesh/outline_polygon.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace pattern_sheet_test {

const std::vector<std::string> all_samples = {
    "band",   "band_small", "bodice_dress", "elastic_skirt", "fitted_tshirt", "gathered_skirt",
    "jacket", "trousers",   "tshirt",       "tube_top",      "walking_dress"};

Pattern sample(const std::string& name) {
  std::vector<Remark> remarks;
  return read_pattern(std::filesystem::path(TOILE_SOURCE_DIR) / "samples" / (name + ".json"),
                      remarks);
}

/// Points all along a panel's outline, its lower left corner at the origin.
std::vector<Vec2> at_origin(std::vector<Vec2> points) {
  Vec2 low = points.front();
  for (const Vec2& point : points) low = low.cwiseMin(point);
  for (Vec2& point : points) point -= low;
  return points;
}

std::vector<Vec2> outline_of(const PatternPanel& panel) {
  std::vector<Vec2> points;
  for (const OutlineStep& step : panel.outline) {
    const EdgeCurve& curve = panel.edges[static_cast<std::size_t>(step.edge)].curve;
    for (int i = 0; i < 400; ++i) {
      points.push_back(curve.at(step.forward ? i / 400.0 : 1 - i / 400.0));
    }
  }
  return at_origin(points);
}

/// Metres: how far points lie from a polygon at most.
double farthest(const std::vector<Vec2>& points, const std::vector<Vec2>& polygon) {
  double most = 0;
  for (const Vec2& point : points) {
    double least = 1e9;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      least = std::min(least,
                       distance_to_segment(point, polygon[i], polygon[(i + 1) % polygon.size()]));
    }
    most = std::max(most, least);
  }
  return most;
}

/// That the pieces are the panels: by name, outline within `tolerance` metres, and grain.
void expect_same(const Pattern& pattern, const PieceDrawing& drawing, double tolerance) {
  ASSERT_EQ(drawing.pieces.size(), pattern.panels.size());
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const PatternPanel& panel = pattern.panels[p];
    const Piece& piece = drawing.pieces[p];
    EXPECT_EQ(piece.name, panel.name);
    EXPECT_FALSE(piece.is_cut_line);
    const auto drawn = outline_of(panel);
    const auto read = at_origin(loop_points(piece.outline, 1e-6));
    EXPECT_LT(farthest(drawn, read), tolerance) << panel.name;
    EXPECT_LT(farthest(read, drawn), tolerance) << panel.name;
    ASSERT_TRUE(piece.grain) << panel.name;
    const Vec2 run = piece.grain->to - piece.grain->from;
    const double turn = std::atan2(-run.x(), run.y()) - panel.grain;
    EXPECT_NEAR(std::sin(turn), 0, 1e-3) << panel.name;
    EXPECT_EQ(piece.quantity, panel.quantity);
  }
}

class PatternSheet : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Samples, PatternSheet, testing::ValuesIn(all_samples));

TEST_P(PatternSheet, SvgComesBackAsItWas) {
  const Pattern pattern = sample(GetParam());
  for (const double allowance : {0.0, 0.01}) {
    const std::string text = sheet_svg(pattern_sheet(pattern, {allowance}));
    expect_same(pattern, svg_pieces(text, "out.svg", {}), 2e-5);
  }
}

TEST_P(PatternSheet, DxfComesBackAsItWas) {
  const Pattern pattern = sample(GetParam());
  for (const double allowance : {0.0, 0.01}) {
    const std::string text = sheet_dxf(pattern_sheet(pattern, {allowance}));
    expect_same(pattern, dxf_pieces(parse_dxf(text, "out.dxf"), "out.dxf", {}), 2e-5);
  }
}

TEST_P(PatternSheet, PanelsLieApart) {
  const Sheet sheet = pattern_sheet(sample(GetParam()), {0.01});
  std::vector<Vec2> lows, highs;
  for (const SheetPart& part : sheet.parts) {
    Vec2 low(1e9, 1e9), high(-1e9, -1e9);
    for (const SheetPath& path : part.paths) {
      for (const Vec2& point : path_vertices(path.path, 1e-4)) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
      }
    }
    EXPECT_GE(low.minCoeff(), 0.0199);
    EXPECT_LE((high - sheet.size).maxCoeff(), -0.0199);
    for (std::size_t k = 0; k < lows.size(); ++k) {
      EXPECT_GE((lows[k] - high).cwiseMax(low - highs[k]).maxCoeff(), 0.0199);
    }
    lows.push_back(low);
    highs.push_back(high);
  }
}

TEST_P(PatternSheet, BothSidesOfASeamBearItsNumber) {
  const Pattern pattern = sample(GetParam());
  const Sheet sheet = pattern_sheet(pattern, {});
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const std::string number = std::to_string(s + 1);
    for (const EdgeRef& side : {pattern.stitches[s].a, pattern.stitches[s].b}) {
      const auto& texts = sheet.parts[static_cast<std::size_t>(side.panel)].texts;
      EXPECT_TRUE(std::any_of(texts.begin(), texts.end(), [&](const SheetText& text) {
        return text.text == number || text.text.starts_with(number + " ");
      })) << number;
    }
  }
}

TEST(PatternSheet, SeamAllowanceIsAsWideAsAskedFor) {
  const Pattern pattern = sample("tshirt");
  const Sheet sheet = pattern_sheet(pattern, {0.01});
  for (const SheetPart& part : sheet.parts) {
    const auto cut = path_vertices(part.paths.at(0).path, 1e-6);
    const auto seam = path_vertices(part.paths.at(1).path, 1e-6);
    EXPECT_EQ(sheet.styles[static_cast<std::size_t>(part.paths[0].style)].css_class, "fabric sa");
    double least = 1;
    for (const Vec2& point : seam) {
      double distance = 1;
      for (std::size_t i = 0; i + 1 < cut.size(); ++i) {
        distance = std::min(distance, distance_to_segment(point, cut[i], cut[i + 1]));
      }
      least = std::min(least, distance);
      EXPECT_LT(distance, 0.01 + 2e-5);
    }
    EXPECT_NEAR(least, 0.01, 2e-5);
  }
}

TEST(PatternSheet, NamesAndMarksOfAnyKind) {
  const std::string name = "le <script>\\\"&' \xC3\xA9t\xC3\xA9";
  Pattern pattern = samples::parse(samples::bag);
  PatternPanel& panel = pattern.panels[0];
  panel.name = name;
  panel.quantity = 2;
  panel.material = "Denim";
  panel.grain = 0.5;
  const Vec2 corner = panel.edges[1].curve.start();
  panel.notches = {{1, corner, {}}, {2, panel.edges[1].curve.end(), 3.0}};
  panel.internal_lines = {{{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.15}}};
  panel.cut_outs = {{{0.05, 0.2}, {0.1, 0.2}, {0.1, 0.25}, {0.05, 0.25}}};
  panel.drill_holes = {{0.25, 0.3}};
  const Sheet sheet = pattern_sheet(pattern, {});
  const std::string svg = sheet_svg(sheet);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  const PieceDrawing as_svg = svg_pieces(svg, "out.svg", {});
  const PieceDrawing as_dxf = dxf_pieces(parse_dxf(sheet_dxf(sheet), "o.dxf"), "o.dxf", {});
  for (const PieceDrawing* drawing : {&as_svg, &as_dxf}) {
    ASSERT_EQ(drawing->pieces.size(), 2u);
    const Piece& piece = drawing->pieces[0];
    EXPECT_EQ(piece.name, name);
    EXPECT_EQ(piece.quantity, 2);
    EXPECT_EQ(piece.material, "Denim");
    EXPECT_EQ(piece.notches.size(), 2u);
    EXPECT_EQ(piece.internal_lines.size(), 1u);
    EXPECT_EQ(piece.cut_outs.size(), 1u);
    EXPECT_EQ(piece.drill_holes.size(), 1u);
    ASSERT_EQ(piece.notches.size(), 2u);
    // Where the notches are, against the outline that was read.
    for (const PieceNotch& notch : piece.notches) {
      EXPECT_LT(farthest({notch.at}, loop_points(piece.outline, 1e-6)), 2e-5);
      EXPECT_TRUE(notch.angle);
    }
    EXPECT_NEAR(std::remainder(*piece.notches[1].angle - 3.0, 2 * std::numbers::pi), 0, 1e-3);
  }
}

TEST(PatternSheet, PdfIsOnePageOfTheSheetsSize) {
  const Sheet sheet = pattern_sheet(sample("tshirt"), {});
  const std::string pdf = sheet_pdf(sheet);
  EXPECT_EQ(pdf, sheet_pdf(sheet));
  const std::size_t box = pdf.find("/MediaBox [ 0 0 ");
  ASSERT_NE(box, std::string::npos);
  double width = 0, height = 0;
  ASSERT_EQ(std::sscanf(pdf.c_str() + box, "/MediaBox [ 0 0 %lf %lf", &width, &height), 2);
  EXPECT_NEAR(width / 72 * 0.0254, sheet.size.x(), 1e-5);
  EXPECT_NEAR(height / 72 * 0.0254, sheet.size.y(), 1e-5);
  Sheet huge = sheet;
  huge.size = {6, 1};
  EXPECT_NE(samples::error_of([&] { sheet_pdf(huge); }).find("5.08 m"), std::string::npos);
}

}  // namespace pattern_sheet_test
}  // namespace toile
