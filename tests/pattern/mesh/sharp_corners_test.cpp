#include "pattern/mesh/sharp_corners.h"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/triangulate.h"
#include "pattern/constants.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace sharp_corners_test {

using samples::error_of;
using samples::file;

/// Half a front whose neck, of `radius` cm, ends at the shoulder. At 15.354 cm it runs along it.
std::string front(const std::string& radius, bool clockwise = false) {
  const std::string neck =
      R"({"type": "circle", "params": [)" + radius + ", 0, " + (clockwise ? "1" : "0") + "]}";
  const std::string x = clockwise ? "" : "-";
  return file(R"("front": {"vertices": [[0,0], [0,15.914], [)" + x + "5.34,45.684], [" + x +
              "17.069,41.021], [" + x + R"(25,0]], "edges": [{"endpoints": [0,1]},
              {"endpoints": [1,2], "curvature": )" +
              neck + R"(}, {"endpoints": [2,3]}, {"endpoints": [3,4]}, {"endpoints": [4,0]}]})");
}

struct Meshed {
  std::vector<Remark> remarks;
  double sharpest = 0;  ///< degrees
};

Meshed meshed(const std::string& text, double edge_length) {
  Meshed result;
  const Pattern pattern = parse_pattern(text, "test.json", result.remarks);
  check_pattern(pattern, result.remarks);
  const PanelMesh garment = mesh_panels(pattern, {edge_length}, result.remarks);
  result.sharpest = smallest_angle(garment.flat, garment.triangles) * 180 / std::numbers::pi;
  return result;
}

// Needles before, at 15 mm: the neck crosses the shoulder 7 mm beside the corner.
TEST(OpenSharpCorners, ANeckThatRunsAlongTheShoulderIsMeshed) {
  for (const double edge_length : {0.01, 0.015, 0.025}) {
    for (const bool clockwise : {false, true}) {
      const auto [remarks, sharpest] = meshed(front("15.354", clockwise), edge_length);
      EXPECT_GT(sharpest, 4) << edge_length;
      ASSERT_EQ(remarks.size(), 1u);
      EXPECT_TRUE(remarks[0].warning);
      EXPECT_EQ(remarks[0].text,
                "test.json: panel 'front', edge 1 meets edge 2 too sharply to mesh; curves are "
                "straight over 36 mm there, which moves them by 1.1 mm");
    }
  }
}

TEST(OpenSharpCorners, TheCurveKeepsItsEndsAndItsShapeElsewhere) {
  const Pattern pattern = samples::parse(front("15.354"));
  const EdgeCurve& opened = pattern.panels[0].edges[1].curve;
  const EdgeCurve drawn = EdgeCurve::arc({0, 0.15914}, {-0.0534, 0.45684}, 0.15354, false, false);
  EXPECT_NEAR((opened.start() - drawn.start()).norm(), 0, 1e-15);
  EXPECT_NEAR((opened.end() - drawn.end()).norm(), 0, 1e-15);
  EXPECT_LT(opened.length(), drawn.length());
  EXPECT_GT(opened.length(), drawn.length() - 1e-3);
  for (const double metres : {0.1, 0.2, 0.3}) {
    EXPECT_NEAR((opened.at(metres / opened.length()) - drawn.at(metres / drawn.length())).norm(), 0,
                1e-12);
  }
  for (const double fraction : {0.93, 0.95, 0.97}) {
    const double off = (opened.at(fraction) - drawn.at(fraction)).norm();
    EXPECT_GT(off, 1e-4);
    EXPECT_LT(off, max_outline_shift);
  }
}

TEST(OpenSharpCorners, WiderCornersStay) {
  std::vector<Remark> remarks;
  const Pattern pattern = parse_pattern(front("17"), "test.json", remarks);
  EXPECT_TRUE(remarks.empty());
  const EdgeCurve drawn = EdgeCurve::arc({0, 0.15914}, {-0.0534, 0.45684}, 0.17, false, false);
  EXPECT_NEAR((pattern.panels[0].edges[1].curve.at(0.95) - drawn.at(0.95)).norm(), 0, 1e-15);
}

TEST(OpenSharpCorners, ANeckThatCutsTheShoulderIsRefused) {
  EXPECT_EQ(error_of([] { meshed(front("15.13"), 0.015); }),
            "test.json: panel 'front', edge 1: crosses or touches edge 2; an outline must not meet "
            "itself; correct the vertices or the curvature");
}

// A slit that opens along a curve: its corner is sharp where there is no cloth.
TEST(OpenSharpCorners, ASlitStays) {
  std::vector<Remark> remarks;
  parse_pattern(
      R"({"pattern": {"panels": {"p": {
            "vertices": [[0,0], [20,0], [20,20], [10.5,20], [10,5], [9.5,20], [0,20]],
            "edges": [{"endpoints": [0,1]}, {"endpoints": [1,2]}, {"endpoints": [2,3]},
                      {"endpoints": [3,4], "curvature": [0.5,0.02]}, {"endpoints": [4,5]},
                      {"endpoints": [5,6]}, {"endpoints": [6,0]}]}}},
          "properties": {"units_in_meter": 100}})",
      "test.json", remarks);
  EXPECT_TRUE(remarks.empty());
}

}  // namespace sharp_corners_test
}  // namespace toile
