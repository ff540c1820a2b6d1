#include "pattern/mesh/panel_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "geometry/angles.h"
#include "geometry/polygon.h"
#include "geometry/triangulate.h"
#include "pattern/mesh/nesting.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace panel_marks_test {

/// A square of 40 cm at 10 mm edges, marked.
struct Marked {
  PanelMesh garment;
  std::vector<Remark> remarks;
  std::set<std::array<int, 2>> edges;

  explicit Marked(const std::string& keys) {
    garment = mesh_panels(samples::parse(samples::file(
                              samples::polygon("front", "[0,0],[40,0],[40,40],[0,40]", keys))),
                          {0.01, -1}, remarks);
    for (const Triangle& t : garment.triangles) {
      for (int k = 0; k < 3; ++k) {
        edges.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
      }
    }
  }

  /// Expects the mark's points to be joined by edges and to lie on the line, centimetres.
  void expect_on(const MeshedMark& mark, const std::vector<Vec2>& line) const {
    for (std::size_t i = 0; i < mark.points.size(); ++i) {
      double off = 1;
      for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        off = std::min(off, distance_to_segment(garment.flat[mark.points[i]], line[k] / 100,
                                                line[k + 1] / 100));
      }
      EXPECT_LT(off, 1e-9) << mark.name << ", point " << i;
      if (i == 0) continue;
      const auto [a, b] = std::minmax(mark.points[i - 1], mark.points[i]);
      EXPECT_TRUE(edges.contains({a, b})) << mark.name << ", point " << i;
    }
  }
  Vec2 first(int mark) const { return 100 * garment.flat[garment.marks[mark].points.front()]; }
  Vec2 last(int mark) const { return 100 * garment.flat[garment.marks[mark].points.back()]; }
};

TEST(PanelMarks, DrillHolesArePoints) {
  const Marked marked(R"("drill_holes": [[10, 10], [12.3, 31.7], [13.1, 31.2]])");
  EXPECT_TRUE(marked.remarks.empty());
  ASSERT_EQ(marked.garment.marks.size(), 3U);
  EXPECT_EQ(marked.garment.marks[1].name, "front.drill_hole.1");
  EXPECT_LT((marked.first(0) - Vec2(10, 10)).norm(), 1e-9);
  EXPECT_LT((marked.first(1) - Vec2(12.3, 31.7)).norm(), 1e-9);
  EXPECT_LT((marked.first(2) - Vec2(13.1, 31.2)).norm(), 1e-9);
  EXPECT_EQ(nesting_problem(marked.garment), std::nullopt);
}

TEST(PanelMarks, LinesAreEdgesAtEveryAngle) {
  for (int degrees = 0; degrees < 180; degrees += 7) {
    const double angle = to_radians(degrees);
    const Vec2 run = 14 * Vec2(std::cos(angle), std::sin(angle));
    const Vec2 from = Vec2(20.3, 19.6) - run;
    const Vec2 to = Vec2(20.3, 19.6) + run;
    const auto text = [](const Vec2& p) {
      return "[" + std::to_string(p.x()) + "," + std::to_string(p.y()) + "]";
    };
    const Marked marked("\"internal_lines\": [[" + text(from) + "," + text(to) + "]]");
    ASSERT_EQ(marked.garment.marks.size(), 1U) << degrees;
    // Six digits are written.
    EXPECT_LT((marked.first(0) - from).norm(), 1e-5);
    EXPECT_LT((marked.last(0) - to).norm(), 1e-5);
    marked.expect_on(marked.garment.marks[0], {marked.first(0), marked.last(0)});
    EXPECT_GT(smallest_angle(marked.garment.flat, marked.garment.triangles), to_radians(15));
  }
}

TEST(PanelMarks, LinesKeepTheirCornersAndMeetWhereTheyCross) {
  const Marked marked(R"("internal_lines": [[[5,35],[25,22],[33,6]], [[8,12],[30,35]]])");
  EXPECT_TRUE(marked.remarks.empty());
  ASSERT_EQ(marked.garment.marks.size(), 2U);
  marked.expect_on(marked.garment.marks[0], {{5, 35}, {25, 22}, {33, 6}});
  marked.expect_on(marked.garment.marks[1], {{8, 12}, {30, 35}});
  const std::vector<int>& bent = marked.garment.marks[0].points;
  const std::vector<int>& straight = marked.garment.marks[1].points;
  EXPECT_TRUE(std::ranges::any_of(
      bent, [&](int p) { return (100 * marked.garment.flat[p] - Vec2(25, 22)).norm() < 1e-9; }));
  EXPECT_EQ(std::ranges::count_if(
                bent, [&](int p) { return std::ranges::find(straight, p) != straight.end(); }),
            1);
}

TEST(PanelMarks, ALineEndsAtTheOutlineAndLeavesOutWhatIsBeyond) {
  const Marked marked(R"("internal_lines": [[[15,-2],[15,20]]])");
  ASSERT_EQ(marked.garment.marks.size(), 1U);
  EXPECT_EQ(marked.first(0).y(), 0);
  EXPECT_NEAR(marked.first(0).x(), 15, 0.5);
  EXPECT_LT((marked.last(0) - Vec2(15, 20)).norm(), 1e-9);
}

TEST(PanelMarks, OfAMirroredPanelAreMirrored) {
  // Both panels face outwards, so one of them shows the back of its drawing.
  const std::string square = "[0,0],[40,0],[40,40],[0,40]";
  std::vector<Remark> remarks;
  const PanelMesh garment = mesh_panels(
      samples::parse(samples::file(
          samples::polygon("front", square, R"("translation": [0,0,20], "drill_holes": [[5,10]])") +
              "," +
              samples::polygon("back", square,
                               R"("translation": [0,0,-20], "drill_holes": [[5,10]])"),
          R"([{"panel": "front", "edge": 1}, {"panel": "back", "edge": 1}],
             [{"panel": "front", "edge": 3}, {"panel": "back", "edge": 3}])")),
      {0.01, -1}, remarks);
  ASSERT_EQ(garment.marks.size(), 2U);
  const double front = garment.flat[garment.marks[0].points[0]].x();
  const double back = garment.flat[garment.marks[1].points[0]].x();
  EXPECT_NEAR(front * back, -0.05 * 0.05, 1e-12);
  for (const MeshedMark& mark : garment.marks) {
    EXPECT_NEAR(garment.placed[mark.points[0]].x(), 0.05, 1e-12);
  }
}

TEST(PanelMarks, ThatFindNoRoomAreNamedAndChangeNothing) {
  const Marked plain("\"grain\": 0");
  const Marked marked(
      R"("internal_lines": [[[0.02,5],[0.02,35]], [[50,5],[50,35]]], "drill_holes": [[20,39.99]])");
  ASSERT_EQ(marked.remarks.size(), 1U);
  EXPECT_FALSE(marked.remarks[0].warning);
  EXPECT_HOLDS(marked.remarks[0].text, "panel 'front', internal lines 0, 1, drill hole 0: not");
  EXPECT_TRUE(marked.garment.marks.empty());
  EXPECT_EQ(marked.garment.flat, plain.garment.flat);
}

}  // namespace panel_marks_test
}  // namespace toile
