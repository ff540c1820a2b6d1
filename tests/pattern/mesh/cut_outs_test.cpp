#include "pattern/mesh/cut_outs.h"

#include <cmath>
#include <numbers>

#include "geometry/polygon.h"
#include "pattern/mesh/nesting.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace cut_outs_test {

std::string circle(double x, double y, double radius) {
  std::string text = "[";
  for (int i = 0; i < 48; ++i) {
    const double angle = i * std::numbers::pi / 24;
    text += (i > 0 ? ",[" : "[") + std::to_string(x + radius * std::cos(angle)) + "," +
            std::to_string(y + radius * std::sin(angle)) + "]";
  }
  return text + "]";
}

std::string panel(const std::string& cut_outs) {
  return samples::file(
      samples::polygon("front", "[0,0],[40,0],[40,40],[0,40]", "\"cut_outs\": [" + cut_outs + "]"));
}

double area_of(const PanelMesh& garment) {
  double area = 0;
  for (const auto& [a, b, c] : garment.triangles) {
    const Vec2 u = garment.flat[b] - garment.flat[a];
    const Vec2 v = garment.flat[c] - garment.flat[a];
    area += (u.x() * v.y() - u.y() * v.x()) / 2;
  }
  return area;
}

TEST(CutOuts, AreHolesOfTheMeshWithTheirArea) {
  const Pattern pattern =
      samples::parse(panel("[[10,10],[16,10],[16,18],[10,18]]," + circle(28, 26, 5)));
  for (const double edge_length : {0.005, 0.01, 0.02}) {
    std::vector<Remark> remarks;
    const PanelMesh garment = mesh_panels(pattern, {edge_length, -1}, remarks);
    EXPECT_TRUE(remarks.empty());
    EXPECT_EQ(nesting_problem(garment), std::nullopt);
    const double circle_area = 24 * std::sin(std::numbers::pi / 24) * 0.05 * 0.05;
    EXPECT_NEAR(area_of(garment), 0.16 - 0.06 * 0.08 - circle_area, 2e-4) << edge_length;
    ASSERT_EQ(garment.cut_outs.size(), 2U);
    EXPECT_EQ(garment.cut_outs[0].name, "front.cut_out.0");
    for (const int p : garment.cut_outs[1].points) {
      EXPECT_NEAR((garment.flat[p] - Vec2(0.28, 0.26)).norm(), 0.05, 2e-4);
    }
    std::vector<Vec2> corners;
    for (const int p : garment.cut_outs[0].points) corners.push_back(garment.flat[p]);
    for (const Vec2& corner : {Vec2(0.1, 0.1), Vec2(0.16, 0.1), Vec2(0.16, 0.18)}) {
      EXPECT_TRUE(
          std::ranges::any_of(corners, [&](const Vec2& p) { return (p - corner).norm() < 1e-9; }));
    }
  }
}

TEST(CutOuts, ThatNoMeshCanShowAreNamed) {
  const auto warning = [](const std::string& cut_outs) {
    std::vector<Remark> remarks;
    const PanelMesh garment = mesh_panels(samples::parse(panel(cut_outs)), {0.01, -1}, remarks);
    EXPECT_NEAR(area_of(garment), 0.16, 1e-9) << cut_outs;
    return remarks.size() == 1 && remarks[0].warning ? remarks[0].text : "none";
  };
  EXPECT_HOLDS(warning(circle(20, 20, 0.2)), "front', cut-out 0 is smaller than a triangle");
  EXPECT_HOLDS(warning("[[10,10],[30,10],[30,10.2],[10,10.2]]"), "narrower than a quarter");
  EXPECT_HOLDS(warning(circle(39, 20, 3)), "crosses the outline");
  EXPECT_HOLDS(warning(circle(50, 20, 3)), "lies outside");
  EXPECT_HOLDS(warning("[[10,10],[20,20],[20,10],[10,20]]"), "crosses itself");
  EXPECT_HOLDS(warning("[[10,10],[10,10],[10,10]]"), "has no area");
}

TEST(CutOuts, TheFirstOfTwoThatMeetIsCut) {
  std::vector<Remark> remarks;
  const PanelMesh garment = mesh_panels(
      samples::parse(panel(circle(20, 20, 5) + "," + circle(20, 20, 2) + "," + circle(26, 20, 4))),
      {0.01, -1}, remarks);
  ASSERT_EQ(remarks.size(), 2U);
  EXPECT_HOLDS(remarks[0].text, "cut-out 1 meets another");
  EXPECT_HOLDS(remarks[1].text, "cut-out 2 meets another");
  ASSERT_EQ(garment.cut_outs.size(), 1U);
  EXPECT_EQ(garment.cut_outs[0].name, "front.cut_out.0");
}

}  // namespace cut_outs_test
}  // namespace toile
