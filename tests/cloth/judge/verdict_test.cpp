#include "cloth/judge/verdict.h"

#include <gtest/gtest.h>

#include "tests/cloth/figure.h"
#include "tests/support/shapes.h"
#include "tests/support/tubes.h"

namespace toile {
namespace {

using test::figure;
using test::tube;
using test::tube_columns;
using test::tube_radius;
using test::tube_rows;

TEST(Judge, TheVerdictNamesTheFirstThingWrong) {
  const PanelMesh garment = tube();
  const Skeleton skeleton = figure();
  const TriangleMesh thin = test::closed_tube(0.15, 0.15, 1.7, 60);
  const TriangleMesh thick = test::closed_tube(0.21, 0.15, 1.7, 60);
  const DressedGarment sewn = test::as_dressed(garment, garment.placed);
  std::vector<Vec3> gaping = garment.placed;
  gaping[garment.seams[0].a[3]].x() += 0.001;
  const DressedGarment open = test::as_dressed(garment, gaping, false);

  Judgement judgement = judge(garment, sewn, thin, &skeleton, true);
  EXPECT_EQ(judgement.verdict, Verdict::sewn);
  EXPECT_EQ(judgement.body_intersections, 0);
  EXPECT_EQ(judgement.self_intersections, 0);
  EXPECT_NEAR(judgement.wraps.at(0).fraction, 1, 1e-3);
  EXPECT_TRUE(judge(garment, sewn, thin, nullptr, true).wraps.empty());

  EXPECT_EQ(judge(garment, sewn, thin, &skeleton, false).verdict, Verdict::unconverged);
  judgement = judge(garment, sewn, thick, &skeleton, false);
  EXPECT_EQ(judgement.verdict, Verdict::intersecting);
  EXPECT_GT(judgement.body_intersections, 4 * tube_rows);
  EXPECT_EQ(judgement.self_intersections, 0);
  judgement = judge(garment, open, thick, &skeleton, false);
  EXPECT_EQ(judgement.verdict, Verdict::unsewable);
  ASSERT_EQ(judgement.garment.seams.open_seams.size(), 1u);
  EXPECT_EQ(judgement.garment.seams.open_seams[0].name, "left");
}

TEST(Judge, ClothThroughALowerLayerIsFound) {
  const PanelMesh garment = tube();
  const DressedGarment sewn = test::as_dressed(garment, garment.placed);
  const TriangleMesh body = test::closed_tube(0.15, 0.15, 1.7, 60);
  for (const double x : {0.19, 0.21}) {
    const DressedGarment below = test::cloth_tube(x, 0.19, 0.9, 1.3, 60, 10);
    const TriangleMesh layer{below.points, below.triangles};
    const Judgement judgement = judge(garment, sewn, body, nullptr, true, &layer);
    EXPECT_EQ(judgement.body_intersections + judgement.self_intersections, 0);
    EXPECT_EQ(judgement.layer_intersections > 40, x > tube_radius);
    EXPECT_EQ(judgement.verdict, x > tube_radius ? Verdict::intersecting : Verdict::sewn);
  }
}

TEST(Judge, ClothThroughItselfIsFound) {
  const PanelMesh garment = tube();
  std::vector<Vec3> points = garment.placed;
  // A fold of the front pushed through the back.
  const int middle = 10 * (tube_columns + 1) + tube_columns / 2;
  points[middle].z() = -tube_radius - 0.01;
  const Judgement judgement = judge(garment, test::as_dressed(garment, points),
                                    test::box({5, 0, 5}, {6, 1, 6}), nullptr, true);
  EXPECT_GT(judgement.self_intersections, 0);
  EXPECT_EQ(judgement.body_intersections, 0);
  EXPECT_EQ(judgement.verdict, Verdict::intersecting);
}

}  // namespace
}  // namespace toile
