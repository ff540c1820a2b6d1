#include "cloth/judge/openings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/cloth/figure.h"
#include "tests/support/shapes.h"
#include "tests/support/tubes.h"

namespace toile {
namespace openings_test {

/// Openings of a sack from under the arms over the head, whose mouth stands before the face.
/// `mouth`: metres, height of the middle of the mouth, 10 cm in radius.
std::vector<Opening> openings_of_sack(double mouth) {
  PanelMesh garment;
  const int around = 24;
  const int along = 12;
  const double girth = 2 * test::pi * 0.2;
  // From the hem, level and about the trunk, to the mouth, upright and before the face.
  const auto place = [&](const Vec2& p) {
    const double angle = 2 * test::pi * p.x() / girth;
    const double t = p.y() / 0.8;
    const double turn = t * test::pi / 2;
    const double radius = 0.25 - 0.15 * t;
    const Vec3 middle(0, 1.1 + t * (mouth - 1.1), 0.3 * t * t);
    const Vec3 up(0, std::sin(turn), -std::cos(turn));
    return Vec3(middle + radius * (std::cos(angle) * Vec3::UnitX() + std::sin(angle) * up));
  };
  MeshedPanel& panel =
      test::add_panel(garment, "hood", test::grid(girth, 0.8, around, along), place);
  garment.seams.push_back(test::seam("back", test::side(panel, around, along, false),
                                     test::side(panel, around, along, true)));
  return find_openings(garment, test::as_dressed(garment, garment.placed), test::figure());
}

/// How many openings of the sack the limbs pass through.
std::ptrdiff_t count(const std::vector<Opening>& openings, const LimbsThrough& limbs) {
  return std::ranges::count_if(openings, [&](const Opening& o) { return o.limbs == limbs; });
}

TEST(Openings, AHoodsOpeningIsANeckline) {
  const std::vector<Opening> openings = openings_of_sack(1.58);
  ASSERT_EQ(openings.size(), 2U);
  EXPECT_EQ(count(openings, through_hem), 1);
  EXPECT_EQ(count(openings, through_neckline), 1);
}

TEST(Openings, AFaceLooksOutBelowAHoodThatHangsOverTheEyes) {
  // The eyes are at about 1.6 m, and the mouth of the sack ends at 1.57 m.
  const std::vector<Opening> openings = openings_of_sack(1.47);
  EXPECT_EQ(count(openings, through_hem), 1);
  EXPECT_EQ(count(openings, through_neckline), 1);
}

TEST(Openings, AnOpeningBelowTheFaceHasNothingInIt) {
  const std::vector<Opening> openings = openings_of_sack(1.28);
  EXPECT_EQ(count(openings, LimbsThrough{}), 1);
}

/// A body 34 cm across up to 1.1 m, and 20 cm above.
TriangleMesh pear() {
  TriangleMesh upper = test::closed_tube(0.1, 0.1, 0.7, 60);
  for (Vec3& p : upper.points) p.y() += 1.1;
  return test::together(test::closed_tube(0.17, 0.17, 1.1, 60), upper);
}

/// The girth that has to pass a ring around the trunk that lies at one height and was drafted to
/// lie at another.
double passes(double lies, double drafted, const LimbsThrough& limbs = through_hem) {
  std::vector<Opening> openings(1);
  openings[0].limbs = limbs;
  openings[0].middle = {0, lies, 0};
  openings[0].drafted = drafted;
  measure_passing(openings, pear(), test::figure());
  return openings[0].passes;
}

TEST(Openings, ARingThatRodeUpHasToPassWhereItWasDraftedToLie) {
  const double wide = 2 * test::pi * 0.17;
  const double slim = 2 * test::pi * 0.1;
  EXPECT_NEAR(passes(1.15, 1.18), slim, 0.01);
  EXPECT_NEAR(passes(1.15, 1.0), wide, 0.01);
  EXPECT_NEAR(passes(1.0, 1.15), wide, 0.01);
  // Above the armpits and below the crotch there is no trunk.
  EXPECT_EQ(passes(1.25, 1.3), 0);
  EXPECT_EQ(passes(0.7, 0.5), 0);
}

TEST(Openings, AHeadHasToPassANeckline) {
  Opening neckline;
  neckline.passes = passes(1.4, 1.4, through_neckline);
  EXPECT_NEAR(neckline.passes, 2 * test::pi * 0.1, 0.01);
  // Cloth stretches by a quarter.
  EXPECT_TRUE(is_too_small(neckline, 0.79 * neckline.passes));
  EXPECT_FALSE(is_too_small(neckline, 0.81 * neckline.passes));
  // An armhole has no such girth.
  EXPECT_FALSE(is_too_small(Opening{}, 0.01));
}

}  // namespace openings_test
}  // namespace toile
