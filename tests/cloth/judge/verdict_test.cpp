#include "cloth/judge/verdict.h"

#include <gtest/gtest.h>

#include <optional>
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
  bool flat = false;     ///< it is a sheet in front of the body, said to be a top
  bool converged = true;
  std::optional<bool> stays = {};  ///< when it is let go

  Judgement judgement() const {
    PanelMesh garment = tube();
    if (flat) {
      garment = PanelMesh();
      test::add_half(garment, "bodice", -test::pi / 2);
    }
    std::vector<Vec3> points = garment.placed;
    if (flat) {
      for (Vec3& p : points) p.z() = 0.25;
    }
    if (open) points[garment.seams[0].a[3]].x() += 0.001;
    if (slipped) {
      for (Vec3& p : points) p.x() += 0.5;
    }
    const Skeleton skeleton = figure();
    const TriangleMesh body =
        test::closed_tube(thick ? (slipped ? 0.4 : 0.21) : 0.15, 0.15, 1.7, 60);
    std::vector<TightSeam> seams;
    if (tight) seams.push_back({"right", 400, 3});
    return judge(garment, test::as_dressed(garment, points, !open), body, &skeleton,
                 {converged, stays, seams});
  }
};

TEST(Judge, NothingIsWrongWithATubeAroundItsBody) {
  const Judgement judgement = Dressing().judgement();
  EXPECT_EQ(judgement.verdict, Verdict::sewn);
  EXPECT_EQ(judgement.body_intersections, 0);
  EXPECT_EQ(judgement.self_intersections, 0);
  EXPECT_TRUE(judgement.worn.is_checked);
  EXPECT_FALSE(judgement.worn.misplaced);
  EXPECT_TRUE(judgement.worn.unwrapped.empty());
  EXPECT_EQ(to_string(judgement.fit), "ok");
  EXPECT_NEAR(judgement.wraps.at(0).fraction, 1, 1e-3);
  const PanelMesh garment = tube();
  const TriangleMesh body = test::closed_tube(0.15, 0.15, 1.7, 60);
  const DressedGarment sewn = test::as_dressed(garment, garment.placed);
  const Judgement without_joints = judge(garment, sewn, body, nullptr, {});
  EXPECT_EQ(without_joints.verdict, Verdict::sewn);
  EXPECT_TRUE(without_joints.wraps.empty());
  EXPECT_FALSE(without_joints.worn.is_checked);
  EXPECT_EQ(to_string(without_joints.fit), "not_checked");
}

TEST(Judge, UnconvergedWhenItDidNotComeToRest) {
  EXPECT_EQ(Dressing{.converged = false}.judgement().verdict, Verdict::unconverged);
}

TEST(Judge, UnstableWhenItDoesNotStayThoughItCameToRest) {
  EXPECT_EQ(Dressing{.stays = true}.judgement().verdict, Verdict::sewn);
  EXPECT_EQ(Dressing{.stays = false}.judgement().verdict, Verdict::unstable);
  EXPECT_EQ((Dressing{.converged = false, .stays = false}.judgement().verdict),
            Verdict::unconverged);
}

TEST(Judge, MisplacedWhenATubeGoesAroundNothing) {
  const Judgement judgement = Dressing{.slipped = true}.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::misplaced);
  ASSERT_TRUE(judgement.worn.misplaced);
  EXPECT_EQ(judgement.worn.misplaced->part, BodyPart::torso);
  EXPECT_EQ(judgement.body_intersections, 0);
}

TEST(Judge, UnwrappedWhenATopLiesInFrontOfTheTrunk) {
  const Judgement judgement = Dressing{.flat = true}.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::unwrapped);
  EXPECT_EQ(judgement.worn.unwrapped, std::vector{BodyPart::torso});
}

TEST(Judge, IntersectingWhenTheBodyIsThickerThanTheTube) {
  const Judgement judgement = Dressing{.thick = true}.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::intersecting);
  EXPECT_GT(judgement.body_intersections, 4 * tube_rows);
  EXPECT_EQ(judgement.self_intersections, 0);
}

TEST(Judge, UnsewableWhenASeamIsOpen) {
  const Judgement judgement = Dressing{.open = true}.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::unsewable);
  const std::vector<OpenSeam>& open = judgement.garment.seams.open_seams;
  ASSERT_EQ(open.size(), 1u);
  EXPECT_EQ(open[0].name, "left");
  EXPECT_NEAR(open[0].gap, 0.001, 1e-11);
}

TEST(Judge, TooTightWhenASeamWasClosedByForce) {
  EXPECT_EQ(Dressing{.tight = true}.judgement().verdict, Verdict::too_tight);
}

TEST(Judge, TheVerdictNamesTheFirstThingWrong) {
  // From step to step one more thing is wrong, and it comes before the others.
  Dressing dressing{.tight = true};
  EXPECT_EQ(dressing.judgement().verdict, Verdict::too_tight);
  dressing.stays = false;
  EXPECT_EQ(dressing.judgement().verdict, Verdict::unstable);
  dressing.converged = false;
  EXPECT_EQ(dressing.judgement().verdict, Verdict::unconverged);
  dressing.slipped = true;
  EXPECT_EQ(dressing.judgement().verdict, Verdict::misplaced);
  dressing.thick = true;
  const Judgement judgement = dressing.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::intersecting);
  EXPECT_TRUE(judgement.worn.misplaced);
  dressing.open = true;
  EXPECT_EQ(dressing.judgement().verdict, Verdict::unsewable);
}

TEST(Judge, VerdictsHaveWords) {
  EXPECT_EQ(to_string(Verdict::unsewable), "unsewable");
  EXPECT_EQ(to_string(Verdict::intersecting), "intersecting");
  EXPECT_EQ(to_string(Verdict::misplaced), "misplaced");
  EXPECT_EQ(to_string(Verdict::unwrapped), "unwrapped");
  EXPECT_EQ(to_string(Verdict::unconverged), "unconverged");
  EXPECT_EQ(to_string(Verdict::unstable), "unstable");
  EXPECT_EQ(to_string(Verdict::too_tight), "too_tight");
  EXPECT_EQ(to_string(Verdict::sewn), "sewn");
}

TEST(Judge, ClothThroughALowerLayerIsFound) {
  const PanelMesh garment = tube();
  const DressedGarment sewn = test::as_dressed(garment, garment.placed);
  const TriangleMesh body = test::closed_tube(0.15, 0.15, 1.7, 60);
  for (const double x : {0.19, 0.21}) {
    const DressedGarment below = test::cloth_tube(x, 0.19, 0.9, 1.3, 60, 10);
    const TriangleMesh layer{below.points, below.triangles};
    const Judgement judgement = judge(garment, sewn, body, nullptr, {}, &layer);
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
                                    test::box({5, 0, 5}, {6, 1, 6}), nullptr, {});
  EXPECT_GT(judgement.self_intersections, 0);
  EXPECT_EQ(judgement.body_intersections, 0);
  EXPECT_EQ(judgement.verdict, Verdict::intersecting);
}

}  // namespace verdict_test
}  // namespace toile
