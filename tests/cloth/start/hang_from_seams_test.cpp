#include "cloth/start/hang_from_seams.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "cloth/start/resolve_intersections.h"
#include "geometry/intersections.h"
#include "tests/cloth/figure.h"
#include "tests/cloth/panels.h"

namespace toile {
namespace hang_from_seams_test {

using test::pi;

constexpr int columns = 16;

/// Points of the lowest or highest row of a grid() panel, from left to right.
std::vector<int> row(const MeshedPanel& panel, int of) {
  std::vector<int> points;
  for (int i = 0; i <= columns; ++i) points.push_back(panel.first_point + of * (columns + 1) + i);
  return points;
}

/// A ring of some degrees, whose inner edge is 40 cm long and up. It is `depth` metres deep.
PlanarMesh ring(double degrees, double depth, int rows) {
  PlanarMesh mesh = test::grid(1, 1, columns, rows);
  const double opening = degrees * pi / 180;
  for (Vec2& p : mesh.points) {
    const double angle = opening * (p.x() - 0.5);
    const double radius = 0.4 / opening + (1 - p.y()) * depth;
    p = radius * Vec2(std::sin(angle), -std::cos(angle));
  }
  return mesh;
}

Vec3 drawn_below(const Vec2& p) { return {p.x() + 0.3, p.y() - 0.6, 0.2}; }

/// A waistband of 40 cm, a skirt of `degrees`, and a frill of 5 m along its hem. Skirt and frill
/// are drawn in one place, below the waistband.
PanelMesh skirt_with_frill(double degrees) {
  PanelMesh garment;
  test::add_panel(garment, "waistband_front", test::grid(0.4, 0.05, columns, 1),
                  [](const Vec2& p) { return Vec3(p.x() - 0.2, p.y() + 1, 0.2); });
  test::add_panel(garment, "skirt_front", ring(degrees, 0.5, 6), drawn_below);
  test::add_panel(garment, "skirt_frill_front", test::grid(5, 0.08, columns, 2), drawn_below);
  const auto& panels = garment.panels;
  garment.seams = {test::seam("waist", row(panels[0], 0), row(panels[1], 6)),
                   test::seam("frill", row(panels[1], 0), row(panels[2], 2))};
  return garment;
}

double widest_gap(const PanelMesh& garment) {
  double gap = 0;
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      gap = std::max(gap, (garment.placed[seam.a[i]] - garment.placed[seam.b[i]]).norm());
    }
  }
  return gap;
}

/// Whether each triangle faces the viewer, and none crosses another.
bool lies_smooth(const PanelMesh& garment) {
  for (const auto& [a, b, c] : garment.triangles) {
    const auto& at = garment.placed;
    if ((at[b] - at[a]).cross(at[c] - at[a]).z() <= 0) return false;
  }
  if (!crossing_panels(garment, garment.placed).empty()) return false;
  return std::ranges::all_of(garment.panels, [&](const MeshedPanel& panel) {
    const auto first = garment.triangles.begin() + panel.first_triangle;
    return self_intersections({garment.placed, {first, first + panel.triangles}}).empty();
  });
}

TEST(HangFromSeams, SkirtAndFrillStartClosedAndSmooth) {
  for (const double degrees : {20, 90, 180, 330}) {
    PanelMesh garment = skirt_with_frill(degrees);
    const std::vector<Vec3> drawn = garment.placed;
    hang_from_seams({}, garment);
    EXPECT_LT(widest_gap(garment), 1e-12) << degrees;
    EXPECT_TRUE(lies_smooth(garment)) << degrees;
    // The waistband is no part of the skirt. The hem's middle is as far below it as it is cut.
    for (int p = 0; p < garment.panels[0].points; ++p) EXPECT_EQ(garment.placed[p], drawn[p]);
    const int hem = row(garment.panels[1], 0)[columns / 2];
    EXPECT_NEAR(garment.placed[hem].y(), 0.5, 1e-3) << degrees;
  }
}

TEST(HangFromSeams, APanelThatFitsItsSeamKeepsItsShape) {
  PanelMesh garment = skirt_with_frill(90);
  hang_from_seams({}, garment);
  // A quarter of a ring opens by as much from a straight edge. Its sides are as long as they are
  // cut.
  const MeshedPanel& skirt = garment.panels[1];
  const int waist = row(skirt, 6).front();
  const int hem = row(skirt, 0).front();
  EXPECT_NEAR((garment.placed[waist] - garment.placed[hem]).norm(), 0.5, 1e-9);
  const Vec3 side = garment.placed[hem] - garment.placed[waist];
  EXPECT_NEAR(std::atan2(-side.x(), -side.y()), pi / 4, 0.05);
}

TEST(HangFromSeams, WhatWouldComeToLieUponOthersStays) {
  const auto stays = [](PanelMesh garment, std::size_t panel) {
    const MeshedPanel& of = garment.panels[panel];
    const std::vector<Vec3> before = garment.placed;
    hang_from_seams({}, garment);
    return std::equal(before.begin() + of.first_point, before.begin() + of.first_point + of.points,
                      garment.placed.begin() + of.first_point);
  };
  PanelMesh twisted = skirt_with_frill(90);
  std::ranges::reverse(twisted.seams[0].b);
  EXPECT_TRUE(stays(twisted, 1));
  // Two gores beside each other hang as the pattern places them.
  PanelMesh gores = skirt_with_frill(20);
  const PlanarMesh gore = ring(20, 0.5, 6);
  test::add_panel(gores, "skirt_side_front", gore, drawn_below);
  gores.seams.push_back(test::seam("side", test::side(gores.panels[1], columns, 6, true),
                                   test::side(gores.panels[3], columns, 6, false)));
  gores.seams.push_back(test::seam("waist", row(gores.panels[0], 0), row(gores.panels[3], 6)));
  EXPECT_TRUE(stays(gores, 1));
  // One that is placed the wrong way up stays so, for the judge to see.
  PanelMesh upside_down = skirt_with_frill(90);
  const MeshedPanel& skirt = upside_down.panels[1];
  for (int p = skirt.first_point; p < skirt.first_point + skirt.points; ++p) {
    Vec3& at = upside_down.placed[p];
    at = Vec3(-at.x(), -at.y(), at.z());
  }
  EXPECT_TRUE(stays(upside_down, 1));
  // A waistband that the skeleton rolls is not yet where it holds.
  PanelMesh rolled = skirt_with_frill(90);
  rolled.panels[0].placement.around = 360;
  rolled.panels[0].placement.at = "waist";
  ASSERT_TRUE(rolled.panels[0].placement.by_part());
  EXPECT_TRUE(stays(rolled, 1));
  // What is no skirt, such as a bodice, stays.
  PanelMesh bodice = skirt_with_frill(90);
  test::name_panel(bodice.panels[1], "bodice_front");
  EXPECT_TRUE(stays(bodice, 1));
  EXPECT_FALSE(stays(bodice, 2));
}

}  // namespace hang_from_seams_test
}  // namespace toile
