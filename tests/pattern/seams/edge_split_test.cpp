#include "pattern/seams/edge_split.h"

#include <gtest/gtest.h>

#include "geometry/polygon.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace edge_split_test {

using namespace samples;

std::vector<Vec2> outline_of(const PatternPanel& panel) {
  std::vector<Vec2> points;
  for (const OutlineStep& step : panel.outline) {
    std::vector<Vec2> more = panel.edges[step.edge].curve.sample(400);
    if (!step.forward) std::reverse(more.begin(), more.end());
    points.insert(points.end(), more.begin(), more.end() - 1);
  }
  return points;
}

/// Cuts edge 2 at 0.3 of its length; looks at lengths, area and the place of the cut.
void expect_same_shape(const std::string& text) {
  const Pattern whole = parse(text);
  EdgeSplit split{{0, 2}, 0.3, 4};
  const Pattern cut = parse(with_split_edge(text, whole, split));
  const PatternPanel& before = whole.panels[0];
  const PatternPanel& after = cut.panels[0];
  ASSERT_EQ(after.edges.size(), 5u);
  const EdgeCurve& drawn = before.edges[2].curve;
  EXPECT_NEAR(after.edges[2].curve.length(), 0.3 * drawn.length(), 1e-6);
  EXPECT_NEAR(after.edges[4].curve.length(), 0.7 * drawn.length(), 1e-6);
  for (const double share : {0.0, 0.4, 1.0}) {
    EXPECT_NEAR((after.edges[2].curve.at(share) - drawn.at(0.3 * share)).norm(), 0, 1e-6);
    EXPECT_NEAR((after.edges[4].curve.at(share) - drawn.at(0.3 + 0.7 * share)).norm(), 0, 1e-6);
  }
  EXPECT_NEAR(signed_area(outline_of(after)), signed_area(outline_of(before)), 5e-7);
}

TEST(EdgeSplit, KeepsTheShapeOfEveryCurve) {
  for (
      const char* curvature :
      {R"({"type": "quadratic", "params": [[0.4, 0.3]]})", "[0.4, 0.3]",
       R"({"type": "cubic", "params": [[0.2, 0.3], [0.7, -0.2]]})",
       R"({"type": "cubics", "params": [[0.1, 0.2], [0.3, 0.2], [0.5, 0], [0.7, -0.2], [0.8, 0.1]]})",
       R"({"type": "circle", "params": [12, 0, 1]})",
       R"({"type": "circle", "params": [11, 1, 0]})"}) {
    SCOPED_TRACE(curvature);
    expect_same_shape(file(curved(curvature)));
  }
  expect_same_shape(file(polygon("straight", "[0,0],[20,0],[21,20],[0,20]")));
}

TEST(EdgeSplit, CurvesInAbsoluteCoordinatesStayAbsolute) {
  expect_same_shape(file(curved(R"({"type": "cubic", "params": [[16, 26], [6, 17]]})"), "",
                         R"("curvature_coords": "absolute", "units_in_meter": 100)"));
}

TEST(EdgeSplit, KeepsAllElse) {
  const std::string text = file(polygon("a", "[0,0],[20,0],[20,20],[0,20]", R"("grain": 30)"));
  const Pattern cut = parse(with_split_edge(text, parse(text), {{0, 1}, 0.5, 4}));
  EXPECT_NEAR(cut.panels[0].grain, M_PI / 6, 1e-9);
  EXPECT_TRUE(cut.panels[0].edges[1].curve.end().isApprox(Vec2(0.2, 0.1), 1e-9));
}

}  // namespace edge_split_test
}  // namespace toile
