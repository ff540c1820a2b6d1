#include "cloth/judge/verdict.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cloth/figure.h"
#include "tests/support/shapes.h"
#include "tests/support/tubes.h"

namespace toile {
namespace verdict_test {

using test::figure;
using test::tube;
using test::tube_columns;
using test::tube_radius;
using test::tube_rows;

/// A tube around a body of 30 cm, judged with some things wrong.
struct Dressing {
  bool open = false;     ///< a seam gapes by 1 mm
  bool tight = false;    ///< a seam was closed by force
  bool thick = false;    ///< the body is too thick for the tube
  bool slipped = false;  ///< the tube is beside the body
  bool converged = true;

  Judgement judgement() const {
    const PanelMesh garment = tube();
    std::vector<Vec3> points = garment.placed;
    if (open) points[garment.seams[0].a[3]].x() += 0.001;
    if (slipped) {
      for (Vec3& p : points) p.x() += 0.5;
    }
    const Skeleton skeleton = figure();
    const TriangleMesh body =
        test::closed_tube(thick ? (slipped ? 0.4 : 0.21) : 0.15, 0.15, 1.7, 60);
    std::vector<TightSeam> seams;
    if (tight) seams.push_back({"right", 400, 3});
    return judge(garment, test::as_dressed(garment, points, !open), body, &skeleton, converged,
                 nullptr, seams);
  }
};

TEST(Judge, NothingIsWrongWithATubeAroundItsBody) {
  const Judgement judgement = Dressing().judgement();
  EXPECT_EQ(judgement.verdict, Verdict::sewn);
  EXPECT_EQ(judgement.body_intersections, 0);
  EXPECT_EQ(judgement.self_intersections, 0);
  EXPECT_TRUE(judgement.unsewable_seams.empty());
  EXPECT_TRUE(judgement.unwrapped.empty());
  EXPECT_NEAR(judgement.wraps.at(0).fraction, 1, 1e-3);
  const PanelMesh garment = tube();
  const TriangleMesh body = test::closed_tube(0.15, 0.15, 1.7, 60);
  const DressedGarment sewn = test::as_dressed(garment, garment.placed);
  EXPECT_TRUE(judge(garment, sewn, body, nullptr, true).wraps.empty());
}

TEST(Judge, UnconvergedWhenItDidNotComeToRest) {
  EXPECT_EQ(Dressing{.converged = false}.judgement().verdict, Verdict::unconverged);
}

TEST(Judge, UnwrappedWhenATubeDoesNotGoAroundItsPart) {
  const Judgement judgement = Dressing{.slipped = true}.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::unwrapped);
  EXPECT_EQ(judgement.unwrapped, std::vector<std::string>{"torso"});
  EXPECT_EQ(judgement.body_intersections, 0);
}

TEST(Judge, IntersectingWhenTheBodyIsThickerThanTheTube) {
  const Judgement judgement = Dressing{.thick = true}.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::intersecting);
  EXPECT_GT(judgement.body_intersections, 4 * tube_rows);
  EXPECT_EQ(judgement.self_intersections, 0);
}

TEST(Judge, UnsewableWhenASeamIsOpenOrWasClosedByForce) {
  Judgement judgement = Dressing{.open = true}.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::unsewable);
  ASSERT_EQ(judgement.unsewable_seams.size(), 1u);
  EXPECT_EQ(judgement.unsewable_seams[0].name, "left");
  EXPECT_NEAR(judgement.unsewable_seams[0].missing_cm, 0.1, 1e-9);

  judgement = Dressing{.tight = true}.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::unsewable);
  EXPECT_TRUE(judgement.garment.seams.open_seams.empty());
  ASSERT_EQ(judgement.unsewable_seams.size(), 1u);
  EXPECT_EQ(judgement.unsewable_seams[0].name, "right");
  EXPECT_EQ(judgement.unsewable_seams[0].missing_cm, 3);
}

TEST(Judge, TheVerdictNamesTheFirstThingWrong) {
  // From step to step one more thing is wrong, and it comes before the others.
  Dressing dressing{.converged = false};
  EXPECT_EQ(dressing.judgement().verdict, Verdict::unconverged);
  dressing.slipped = true;
  EXPECT_EQ(dressing.judgement().verdict, Verdict::unwrapped);
  dressing.thick = true;
  Judgement judgement = dressing.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::intersecting);
  EXPECT_FALSE(judgement.unwrapped.empty());
  dressing.tight = true;
  judgement = dressing.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::unsewable);
  EXPECT_GT(judgement.body_intersections, 0);
  dressing.tight = false;
  dressing.open = true;
  EXPECT_EQ(dressing.judgement().verdict, Verdict::unsewable);
}

TEST(Judge, VerdictsHaveWords) {
  EXPECT_EQ(to_string(Verdict::unsewable), "unsewable");
  EXPECT_EQ(to_string(Verdict::intersecting), "intersecting");
  EXPECT_EQ(to_string(Verdict::unwrapped), "unwrapped");
  EXPECT_EQ(to_string(Verdict::unconverged), "unconverged");
  EXPECT_EQ(to_string(Verdict::sewn), "sewn");
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

}  // namespace verdict_test
}  // namespace toile
