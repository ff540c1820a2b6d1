#include "cloth/start/flat_layout.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/cloth/figure.h"

namespace toile {
namespace flat_layout_test {

std::vector<int> all_panels(const PanelMesh& garment) {
  std::vector<int> panels;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) panels.push_back(static_cast<int>(p));
  return panels;
}

FlatLayout laid(const PanelMesh& garment) {
  return lay_flat(garment, all_panels(garment),
                  std::vector<std::optional<bool>>(garment.panels.size()));
}

/// Metres: the largest distance between sewn points in the picture.
double largest_gap(const PanelMesh& garment, const FlatLayout& layout) {
  const std::vector<int> panel_of = panel_of_points(garment);
  double largest = 0;
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      const Vec2 a = layout.picture(panel_of[seam.a[i]], garment.flat[seam.a[i]]);
      const Vec2 b = layout.picture(panel_of[seam.b[i]], garment.flat[seam.b[i]]);
      largest = std::max(largest, (a - b).norm());
    }
  }
  return largest;
}

/// Gores of a skirt, each narrower at the top, drawn upright and counter-clockwise.
PanelMesh gores(int count, double top, double bottom, double height) {
  PanelMesh garment;
  constexpr int columns = 4, rows = 8;
  for (int g = 0; g < count; ++g) {
    PlanarMesh mesh = test::grid(1, height, columns, rows);
    for (Vec2& p : mesh.points) {
      p.x() = (p.x() - 0.5) * (bottom + (top - bottom) * p.y() / height);
    }
    test::add_panel(garment, "gore" + std::to_string(g), mesh,
                    [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); });
  }
  for (int g = 0; g < count; ++g) {
    MeshedSeam sewn =
        test::seam("s" + std::to_string(g), test::side(garment.panels[g], columns, rows, true),
                   test::side(garment.panels[(g + 1) % count], columns, rows, false));
    sewn.length_a = sewn.length_b = std::hypot(height, (bottom - top) / 2);
    garment.seams.push_back(sewn);
  }
  return garment;
}

TEST(FlatLayout, TwoHalvesOfATubeLieUponEachOther) {
  PanelMesh garment = test::tube();
  for (MeshedSeam& seam : garment.seams) seam.length_a = seam.length_b = 0.6;
  const FlatLayout layout = laid(garment);
  EXPECT_NE(layout.back[0], layout.back[1]);
  EXPECT_LT(largest_gap(garment, layout), 1e-6);
  EXPECT_NEAR(layout.turn[0].real(), 1, 1e-9);  // upright as drawn
}

TEST(FlatLayout, AGivenFaceIsKept) {
  PanelMesh garment = test::tube();
  for (MeshedSeam& seam : garment.seams) seam.length_a = seam.length_b = 0.6;
  for (const bool back : {false, true}) {
    const FlatLayout layout = lay_flat(garment, {0, 1}, {back, std::nullopt});
    EXPECT_EQ(layout.back[0] != 0, back);
    EXPECT_EQ(layout.back[1] != 0, !back);
  }
}

TEST(FlatLayout, TurnedDrawingsAreTurnedBackToMeet) {
  PanelMesh garment = test::tube();
  for (MeshedSeam& seam : garment.seams) seam.length_a = seam.length_b = 0.6;
  const MeshedPanel& back = garment.panels[1];
  const Eigen::Rotation2Dd turn(0.7);
  for (int p = back.first_point; p < back.first_point + back.points; ++p) {
    garment.flat[p] = turn * garment.flat[p] + Vec2(3, -2);
  }
  EXPECT_LT(largest_gap(garment, laid(garment)), 1e-6);
}

/// Of a round skirt half of the gores lie before the body, side by side, as of a narrow one.
TEST(FlatLayout, GoresAreSharedByBothFacesInOneRun) {
  for (const double bottom : {0.14, 0.5}) {
    const PanelMesh garment = gores(12, 0.07, bottom, 0.7);
    const FlatLayout layout = laid(garment);
    const auto in_back = std::ranges::count_if(layout.back, [](char b) { return b != 0; });
    EXPECT_GE(in_back, 5);
    EXPECT_LE(in_back, 7);
    int changes = 0;
    for (int g = 0; g < 12; ++g) changes += layout.back[g] != layout.back[(g + 1) % 12];
    EXPECT_EQ(changes, 2) << bottom;
  }
}

TEST(FlatLayout, SeenFromBehindLeftIsRight) {
  PanelMesh garment = test::tube();
  for (MeshedSeam& seam : garment.seams) seam.length_a = seam.length_b = 0.6;
  FlatLayout layout = laid(garment);
  const Vec2 before = layout.picture(0, garment.flat[5]);
  const char face = layout.back[0];
  layout.change_faces();
  EXPECT_NE(layout.back[0], face);
  EXPECT_LT((layout.picture(0, garment.flat[5]) - Vec2(-before.x(), before.y())).norm(), 1e-12);
}

}  // namespace flat_layout_test
}  // namespace toile
