#include "tests/figures/paper_dressing.h"

#include <gtest/gtest.h>

#include <iostream>

namespace toile::figures {
namespace paper_dressing_test {

TEST(PaperDressing, StrainIsGatheredByPanelAndNearestJoint) {
  const Skeleton skeleton{{{"waist", {0, 1, 0}}, {"left_knee", {0, 0.5, 0}}}, {}};
  PanelMesh garment;
  garment.flat = {{0, 0}, {0.1, 0}, {0, 0.1}, {0.1, 0.1}};
  garment.triangles = {{0, 1, 2}, {1, 3, 2}};
  garment.panels.emplace_back();
  garment.panels[0].name = "front";
  garment.panels[0].points = 4;
  garment.panels[0].triangles = 2;
  const auto at = [](double u, double v) { return Vec3(u, 0.55 + v, 0); };
  // The upper edge is 5 % longer, what ends there slants by less than half of that.
  const std::vector<Vec3> points = {at(0, 0), at(0.1, 0), at(0, 0.1), at(0.105, 0.1)};
  const auto places = strained_places(garment, points, skeleton, 0.01);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].panel, "front");
  EXPECT_EQ(places[0].joint, "left knee");
  EXPECT_EQ(places[0].edges, 1);
  EXPECT_NEAR(places[0].largest, 0.05, 1e-12);
  EXPECT_TRUE(places[0].longer);
  EXPECT_NEAR(places[0].at.y(), 0.65, 1e-12);
}

TEST(PaperDressing, TheSmallBandIsUnsewableAndTheLargerOneSews) {
  const Wearer wearer(standing_pose());
  const PaperDressing small = dress_by_paper("small", sample_garment("band_small", 0.03), wearer);
  EXPECT_EQ(small.judgement.verdict, Verdict::unsewable);
  ASSERT_EQ(small.judgement.garment.seams.open_seams.size(), 2U);
  double missing = 0;
  for (const OpenSeam& seam : small.judgement.garment.seams.open_seams) missing += 100 * seam.gap;
  // Its upper edge lacks 7.1 cm of the waist, its lower one 9.8 of the hips.
  std::cout << "missing: " << missing << " cm\n";
  EXPECT_GT(missing, 5);
  EXPECT_LT(missing, 14);
  const PaperDressing large = dress_by_paper("large", sample_garment("band", 0.03), wearer);
  EXPECT_EQ(large.judgement.garment.seams.open, 0);
  EXPECT_EQ(large.judgement.self_intersections, 0);
  ASSERT_EQ(large.judgement.wraps.size(), 1U);
  EXPECT_GT(large.judgement.wraps[0].fraction, 0.95);
  EXPECT_LT(large.max_area(), 1.44);
  EXPECT_LT(large.max_perimeter(), 0.87);
}

}  // namespace paper_dressing_test
}  // namespace toile::figures
