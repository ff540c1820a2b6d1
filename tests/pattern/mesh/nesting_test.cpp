#include "pattern/mesh/nesting.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/pattern/samples.h"

namespace toile {
namespace nesting_test {

PanelMesh bag(int subdivisions) {
  std::vector<Remark> remarks;
  return mesh_panels(samples::parse(samples::bag), {0.02, subdivisions}, remarks);
}

TEST(Nesting, HoldsForWhatMeshPanelsMakes) {
  for (int n = 0; n <= 3; ++n) EXPECT_EQ(nesting_problem(bag(n)), std::nullopt);
}

TEST(Nesting, AClaimOfMoreLevelsThanThereAreIsFound) {
  PanelMesh garment = bag(1);
  garment.subdivisions = 2;
  EXPECT_NE(nesting_problem(garment), std::nullopt);
  garment.subdivisions = 400;
  EXPECT_NE(nesting_problem(garment), std::nullopt);
  garment = bag(0);
  garment.subdivisions = 1;
  EXPECT_NE(nesting_problem(garment), std::nullopt);
}

TEST(Nesting, AnotherOrderOfTrianglesOrCornersIsFound) {
  PanelMesh swapped = bag(2);
  std::swap(swapped.triangles[0], swapped.triangles[1]);
  EXPECT_NE(nesting_problem(swapped), std::nullopt);
  PanelMesh turned = bag(2);
  std::rotate(turned.triangles[5].begin(), turned.triangles[5].begin() + 1,
              turned.triangles[5].end());
  EXPECT_NE(nesting_problem(turned), std::nullopt);
}

TEST(Nesting, AnotherOrderOfPointsIsFound) {
  PanelMesh garment = bag(1);
  // The first and last point of the first panel change names: coarse and fine are mixed.
  const int last = garment.panels[0].points - 1;
  const auto renamed = [&](int i) { return i == 0 ? last : i == last ? 0 : i; };
  for (Triangle& triangle : garment.triangles) {
    for (int& corner : triangle) corner = renamed(corner);
  }
  for (MeshedSeam& seam : garment.seams) {
    for (int& point : seam.a) point = renamed(point);
    for (int& point : seam.b) point = renamed(point);
  }
  const auto problem = nesting_problem(garment);
  ASSERT_TRUE(problem);
  EXPECT_HOLDS(*problem, "finer level before coarser");
}

TEST(Nesting, ASeamOutOfStepIsFound) {
  PanelMesh garment = bag(1);
  garment.seams[0].a.pop_back();
  garment.seams[0].b.pop_back();
  const auto problem = nesting_problem(garment);
  ASSERT_TRUE(problem);
  EXPECT_HOLDS(*problem, "seam 'front.1-back.2'");
}

TEST(Nesting, AnElasticOutOfStepIsFound) {
  PanelMesh garment = bag(1);
  garment.elastics = {{"front.1", garment.seams[0].a, 0.5, 20}};
  EXPECT_FALSE(nesting_problem(garment));
  garment.elastics[0].points.pop_back();
  const auto problem = nesting_problem(garment);
  ASSERT_TRUE(problem);
  EXPECT_HOLDS(*problem, "elastic 'front.1'");
}

TEST(Nesting, AnAttachmentOutOfStepIsFound) {
  PanelMesh garment = bag(1);
  const std::vector<int> along = garment.seams[0].a;
  garment.attachments = {{"front.1", along, {}}, {"front.v1", {along.front()}, {}}};
  EXPECT_FALSE(nesting_problem(garment));
  garment.attachments[1].points = {along[1]};
  const auto problem = nesting_problem(garment);
  ASSERT_TRUE(problem);
  EXPECT_HOLDS(*problem, "attachment 'front.v1'");
}

}  // namespace nesting_test
}  // namespace toile
