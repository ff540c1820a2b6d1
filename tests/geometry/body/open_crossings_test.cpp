#include "geometry/body/open_crossings.h"

#include <gtest/gtest.h>

#include "geometry/intersections.h"
#include "tests/support/shapes.h"

namespace toile {
namespace open_crossings_test {

TEST(OpenCrossings, ACreaseIsOpenedAndTheRestStays) {
  TriangleMesh ball = test::sphere(0.1, 4);
  // Two points near the top change places, so that the skin between them folds over.
  const auto nearest = [&ball](const Vec3& place) {
    int found = 0;
    for (int i = 0; i < static_cast<int>(ball.points.size()); ++i) {
      if ((ball.points[i] - place).norm() < (ball.points[found] - place).norm()) found = i;
    }
    return found;
  };
  std::swap(ball.points[nearest(Vec3(0, 0.1, 0))], ball.points[nearest(Vec3(0.014, 0.099, 0))]);
  const TriangleMesh before = ball;
  const int crossing = static_cast<int>(self_intersections(ball).size());
  ASSERT_GT(crossing, 0);
  const OpenedCrossings opened = open_crossings(ball);
  EXPECT_EQ(opened.pairs_before, crossing);
  EXPECT_EQ(opened.pairs_left, 0);
  EXPECT_TRUE(self_intersections(ball).empty());
  EXPECT_LE(opened.largest_move, max_crease_move);
  EXPECT_GT(opened.largest_move, 0.001);
  for (std::size_t i = 0; i < ball.points.size(); ++i) {
    if (before.points[i].y() < 0) {
      EXPECT_EQ(ball.points[i], before.points[i]);
    }
  }
}

TEST(OpenCrossings, PartsThatGoThroughEachOtherStay) {
  TriangleMesh two = test::sphere(0.1, 3);
  TriangleMesh other = test::sphere(0.1, 3);
  for (Vec3& p : other.points) p.x() += 0.1;
  append(two, other);
  const std::vector<Vec3> before = two.points;
  const OpenedCrossings opened = open_crossings(two);
  EXPECT_GT(opened.pairs_left, 0);
  EXPECT_EQ(opened.pairs_left, opened.pairs_before);
  EXPECT_EQ(opened.largest_move, 0);
  EXPECT_EQ(two.points, before);
}

}  // namespace open_crossings_test
}  // namespace toile
