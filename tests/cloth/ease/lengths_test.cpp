#include "cloth/ease/lengths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cloth/ease/garment_levels.h"
#include "tests/support/standing_figure.h"
#include "tests/support/tubes.h"

namespace toile {
namespace lengths_test {

const GarmentLength* length(const std::vector<GarmentLength>& lengths, const std::string& name) {
  const auto found = std::ranges::find(lengths, name, &GarmentLength::name);
  return found == lengths.end() ? nullptr : &*found;
}

TEST(Lengths, ASleeveEndsBetweenElbowAndWrist) {
  // 10 rows of 1 cm on the flat, worn from x = 0.2 to 0.6; the elbow is at 0.45, the wrist at 0.7.
  DressedGarment sleeve = test::cloth_tube(0.08, 0.08, 0.2, 0.6, 40, 10);
  sleeve.panels = {"sleeve_front", "sleeve_back"};
  for (Vec3& p : sleeve.points) p = Vec3(p.y(), 1.3 - p.x(), p.z() + 0.001);
  const auto lengths = measure_lengths(sleeve, test::figure(), {}, worn_as(sleeve.panels), {});
  ASSERT_EQ(lengths.size(), 1U);
  EXPECT_EQ(lengths[0].name, "left sleeve");
  EXPECT_NEAR(lengths[0].as_cut.value(), 0.10, 1e-3);
  EXPECT_NEAR(lengths[0].worn, 0.40, 1e-6);
  EXPECT_FALSE(lengths[0].body);
  ASSERT_EQ(lengths[0].ends.size(), 2U);
  EXPECT_EQ(lengths[0].ends[0].place, "left elbow");
  EXPECT_NEAR(lengths[0].ends[0].by, 0.15, 1e-6);
  EXPECT_EQ(lengths[0].ends[1].place, "left wrist");
  EXPECT_NEAR(lengths[0].ends[1].by, -0.10, 1e-6);
}

TEST(Lengths, CentreFrontAndBackToSeamAndHem) {
  DressedGarment dress = test::cloth_tube(0.2, 0.2, 0.5, 1.2, 40, 14);
  for (Vec3& p : dress.points) p.x() += 0.001;
  dress.panels = {"bodice", "bodice_back", "skirt"};
  for (std::size_t t = 0; t < dress.triangles.size(); ++t) {
    double height = 0;
    for (const int p : dress.triangles[t]) height += dress.points[p].y() / 3;
    if (height < 1.0) dress.panel_of_triangle[t] = 2;
  }
  const auto lengths = measure_lengths(dress, test::figure(), {}, worn_as(dress.panels), {});
  for (const std::string side : {"centre front", "centre back"}) {
    const GarmentLength* whole = length(lengths, side);
    ASSERT_NE(whole, nullptr);
    EXPECT_NEAR(whole->as_cut.value(), 0.14, 1e-3);  // 14 rows of 1 cm
    EXPECT_NEAR(whole->worn, 0.70, 1e-9);
    EXPECT_NEAR(whole->ends.at(0).by, 0.5, 1e-9);
    EXPECT_EQ(whole->ends.at(1).place, "knee");
    EXPECT_NEAR(whole->ends.at(1).by, -0.05, 1e-9);  // knees are at 0.45
    const GarmentLength* top = length(lengths, side + " to waist seam");
    ASSERT_NE(top, nullptr);
    EXPECT_NEAR(top->as_cut.value(), 0.04, 1e-3);
  }
}

/// Two strips of cloth, each 5 cm wide, sewn together in the middle: down the front, under the
/// crotch, up the back. Front and back meet 1 cm higher than the lowest point, which is 5 cm
/// farther back. On the flat both turn a right angle. Panels are left and right front, left and
/// right back.
DressedGarment crotch_strips() {
  struct Turn {
    Vec2 worn;  // z, y
    Vec2 flat;
    bool is_back;  // up to here
  };
  const std::vector<Turn> turns = {
      {{0.10, 1.10}, {0, 0.30}, false}, {{0.10, 0.80}, {0, 0}, false},
      {{0.05, 0.80}, {0.05, 0}, false}, {{0.00, 0.79}, {0.10, 0}, true},
      {{-0.10, 0.80}, {0.20, 0}, true}, {{-0.10, 1.10}, {0.20, 0.30}, true}};
  DressedGarment strips;
  strips.panels = {"left_front", "right_front", "left_back", "right_back"};
  const auto add_row = [&](const Vec2& worn, const Vec2& flat) {
    for (const double x : {-0.05, 0.0, 0.05}) {
      strips.points.emplace_back(x, worn.y(), worn.x());
      strips.flat.emplace_back(flat + Vec2(x, 0));
    }
  };
  add_row(turns[0].worn, turns[0].flat);
  for (std::size_t i = 1; i < turns.size(); ++i) {
    const double length = (turns[i].flat - turns[i - 1].flat).norm();
    const auto rows = static_cast<int>(std::lround(length / 0.05));
    for (int row = 1; row <= rows; ++row) {
      const double share = static_cast<double>(row) / rows;
      add_row((1 - share) * turns[i - 1].worn + share * turns[i].worn,
              (1 - share) * turns[i - 1].flat + share * turns[i].flat);
      const int last = static_cast<int>(strips.points.size()) - 6;
      for (const int column : {0, 1}) {
        const int p = last + column;
        strips.triangles.push_back({p, p + 1, p + 4});
        strips.triangles.push_back({p, p + 4, p + 3});
        const int panel = (turns[i].is_back ? 2 : 0) + (column == 0 ? 1 : 0);
        strips.panel_of_triangle.insert(strips.panel_of_triangle.end(), 2, panel);
      }
    }
  }
  strips.flat_triangles = strips.triangles;
  return strips;
}

TEST(Lengths, CrotchLengthRunsAlongTheSeamAndItsRisesMeetWhereFrontMeetsBack) {
  DressedGarment strips = crotch_strips();
  std::vector<PanelRole> roles(4, PanelRole::trousers);
  BodyMeasures of_body;
  of_body.lengths["crotch_length"] = 0.70;
  const auto lengths = measure_lengths(strips, test::figure(), of_body, roles, {});
  const GarmentLength* whole = length(lengths, "crotch length");
  ASSERT_NE(whole, nullptr);
  const double under = std::hypot(0.01, 0.05) + std::hypot(0.01, 0.10);
  EXPECT_NEAR(whole->as_cut.value(), 0.80, 1e-9);
  EXPECT_NEAR(whole->worn, 0.35 + under + 0.30, 1e-9);
  EXPECT_EQ(whole->body, 0.70);
  EXPECT_NEAR(length(lengths, "front rise")->as_cut.value(), 0.35, 1e-9);
  EXPECT_NEAR(length(lengths, "back rise")->as_cut.value(), 0.45, 1e-9);
  EXPECT_FALSE(length(lengths, "front rise")->body);

  // A waistband on the upper 5 cm of the front counts as well.
  DressedGarment banded = strips;
  banded.panels.emplace_back("waistband");
  for (int t = 0; t < 4; ++t) banded.panel_of_triangle[t] = 4;
  roles.push_back(PanelRole::waistband);
  const auto with_band = measure_lengths(banded, test::figure(), {}, roles, {});
  EXPECT_NEAR(length(with_band, "front rise")->as_cut.value(), 0.35, 1e-9);
  EXPECT_NEAR(length(with_band, "crotch length")->as_cut.value(), 0.80, 1e-9);

  // One panel a leg shows no seam to the back: the lowest point parts it.
  for (int& panel : strips.panel_of_triangle) panel %= 2;
  const auto through = measure_lengths(strips, test::figure(), {}, roles, {});
  EXPECT_NEAR(length(through, "front rise")->as_cut.value(), 0.40, 1e-9);
  EXPECT_NEAR(length(through, "back rise")->as_cut.value(), 0.40, 1e-9);

  // One panel for both legs has no seam to follow.
  strips.panel_of_triangle.assign(strips.triangles.size(), 0);
  EXPECT_EQ(length(measure_lengths(strips, test::figure(), {}, roles, {}), "crotch length"),
            nullptr);
}

TEST(Lengths, AcrossShoulderRunsOverTheCentreBack) {
  DressedGarment top = test::cloth_tube(0.2, 0.2, 1.2, 1.4, 40, 2);
  for (Vec3& p : top.points) p.x() += 0.0001;
  // The back is twice as wide on the flat: 40 cm from side to side, and the front 20.
  for (std::size_t p = top.flat.size() / 2; p < top.flat.size(); ++p) top.flat[p].x() *= 2;
  std::vector<GarmentLevel> armholes(2);
  armholes[0].name = "left armhole";
  armholes[0].nodes = {20, 60};  // x = 0.2, at 1.2 and 1.3
  armholes[1].name = "right armhole";
  armholes[1].nodes = {0, 40};
  BodyMeasures of_body;
  of_body.lengths["left_back_across_shoulder"] = 0.17;
  of_body.lengths["right_back_across_shoulder"] = 0.18;
  const auto lengths = measure_lengths(top, test::figure(), of_body, worn_as(top.panels), armholes);
  const GarmentLength* across = length(lengths, "across shoulder");
  ASSERT_NE(across, nullptr);
  EXPECT_NEAR(across->as_cut.value(), 0.40, 1e-3);
  // Straight from (0.2, 0) to (0, -0.2), and on.
  EXPECT_NEAR(across->worn, 2 * 0.2 * std::numbers::sqrt2, 1e-3);
  EXPECT_NEAR(across->body.value(), 0.35, 1e-12);

  DressedGarment with_yoke = top;
  with_yoke.panels[1] = "yoke";
  EXPECT_EQ(
      length(measure_lengths(with_yoke, test::figure(), {}, worn_as(with_yoke.panels), armholes),
             "across shoulder"),
      nullptr);
  armholes.pop_back();
  EXPECT_EQ(length(measure_lengths(top, test::figure(), {}, worn_as(top.panels), armholes),
                   "across shoulder"),
            nullptr);
}

TEST(Lengths, NeckDropIsTheHeightOfTheNecksSidesOverTheCentre) {
  DressedGarment top = test::cloth_tube(0.2, 0.2, 1.0, 1.4, 40, 10);
  // At the centre the front hangs 10 cm lower than at the sides, the back 2. On the flat it is 8.
  for (Vec3& p : top.points) {
    p.y() -= p.z() > 0 ? p.z() / 2 : -p.z() / 10;
    p.x() += 0.0001;
  }
  for (std::size_t p = 0; p < top.flat.size() / 2; ++p) {
    top.flat[p].y() -= 0.08 - 0.8 * std::abs(top.flat[p].x() - 0.1);
  }
  std::vector<GarmentLevel> levels(1);
  levels[0].name = "neckline";
  for (int i = 400; i < 440; ++i) levels[0].nodes.push_back(i);
  auto lengths = measure_lengths(top, test::figure(), {}, worn_as(top.panels), levels);
  ASSERT_NE(length(lengths, "front neck drop"), nullptr);
  EXPECT_NEAR(length(lengths, "front neck drop")->worn, 0.10, 1e-3);
  EXPECT_NEAR(length(lengths, "front neck drop")->as_cut.value(), 0.08, 1e-3);
  EXPECT_NEAR(length(lengths, "back neck drop")->worn, 0.02, 1e-3);
  EXPECT_NEAR(length(lengths, "back neck drop")->as_cut.value(), 0, 1e-3);

  // The edge of a collar is no neckline.
  top.panels = {"collar_front", "collar_back"};
  lengths = measure_lengths(top, test::figure(), {}, worn_as(top.panels), levels);
  EXPECT_EQ(length(lengths, "front neck drop"), nullptr);

  // A yoke over the shoulders parts the sides of the neck from the front.
  top.panels = {"front", "back", "yoke"};
  for (std::size_t t = 0; t < top.triangles.size(); ++t) {
    if (std::abs(top.points[top.triangles[t][0]].x()) > 0.1) top.panel_of_triangle[t] = 2;
  }
  lengths = measure_lengths(top, test::figure(), {}, worn_as(top.panels), levels);
  EXPECT_EQ(length(lengths, "front neck drop"), nullptr);
}

TEST(Lengths, FoldsOfThePathDoNotCount) {
  const ClothPath path = {{0, {0, 0, 0}, {0, 1, 0}, {0, 0}, {0, 1}},
                          {0, {0, 1, 0}, {1, 1, 0}, {0, 1}, {0.5, 1}},
                          {1, {1, 1, 0}, {1, 2, 0}, {5, 5}, {5, 6}}};
  EXPECT_NEAR(flat_length(path), std::hypot(1, 0.5) + 1, 1e-12);
  EXPECT_NEAR(worn_length(path), 3, 1e-12);
  EXPECT_NEAR(flat_length(reversed(path)), flat_length(path), 1e-12);
}

}  // namespace lengths_test
}  // namespace toile
