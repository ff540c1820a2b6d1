#include "cloth/ease/lengths.h"

#include <gtest/gtest.h>

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
  const auto lengths = measure_lengths(sleeve, test::figure(), {}, worn_as(sleeve.panels));
  ASSERT_EQ(lengths.size(), 1U);
  EXPECT_EQ(lengths[0].name, "left sleeve");
  EXPECT_NEAR(lengths[0].as_cut, 0.10, 1e-3);
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
  const auto lengths = measure_lengths(dress, test::figure(), {}, worn_as(dress.panels));
  for (const std::string side : {"centre front", "centre back"}) {
    const GarmentLength* whole = length(lengths, side);
    ASSERT_NE(whole, nullptr);
    EXPECT_NEAR(whole->as_cut, 0.14, 1e-3);  // 14 rows of 1 cm
    EXPECT_NEAR(whole->worn, 0.70, 1e-9);
    EXPECT_NEAR(whole->ends.at(0).by, 0.5, 1e-9);
    const GarmentLength* top = length(lengths, side + " to waist seam");
    ASSERT_NE(top, nullptr);
    EXPECT_NEAR(top->as_cut, 0.04, 1e-3);
  }
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
