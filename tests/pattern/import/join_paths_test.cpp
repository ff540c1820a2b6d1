#include "pattern/import/join_paths.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "geometry/polygon.h"

namespace toile {
namespace join_paths_test {

PiecePath line(double x0, double y0, double x1, double y1) {
  return {EdgeCurve::line({x0, y0}, {x1, y1})};
}

TEST(JoinPaths, LinesInAnyOrderAndDirectionBecomeALoop) {
  const JoinedPaths joined =
      join_paths({line(0, 0, 1, 0), line(0, 1, 1, 1), line(0, 1, 0, 0), line(1, 1, 1, 0.0004)});
  ASSERT_EQ(joined.closed.size(), 1u);
  EXPECT_TRUE(joined.open.empty());
  EXPECT_NEAR(joined.widest_closed_gap, 4e-4, 1e-12);
  EXPECT_NEAR(std::abs(signed_area(loop_points(joined.closed[0], 1e-5))), 1, 1e-3);
  for (std::size_t i = 1; i < joined.closed[0].size(); ++i) {
    EXPECT_EQ(joined.closed[0][i].start(), joined.closed[0][i - 1].end());
  }
  EXPECT_EQ(joined.closed[0].front().start(), joined.closed[0].back().end());
}

TEST(JoinPaths, SaysWhereALoopIsOpen) {
  const JoinedPaths joined =
      join_paths({line(0, 0, 1, 0), line(1, 0, 1, 1), line(1, 1, 0, 1), line(0, 1, 0, 0.01)});
  EXPECT_TRUE(joined.closed.empty());
  ASSERT_EQ(joined.gaps.size(), 1u);
  EXPECT_NEAR(joined.gaps[0].size, 0.01, 1e-12);
  EXPECT_TRUE(joined.gaps[0].at.isApprox(Vec2(0, 0.005)));
}

TEST(JoinPaths, LoopsBesideEachOtherStayApart) {
  const auto square = [](double x) -> std::vector<PiecePath> {
    return {line(x, 0, x + 1, 0), line(x + 1, 0, x + 1, 1), line(x + 1, 1, x, 1), line(x, 1, x, 0)};
  };
  std::vector<PiecePath> both = square(0);
  for (const PiecePath& path : square(5)) both.push_back(path);
  EXPECT_EQ(join_paths(both).closed.size(), 2u);
}

TEST(JoinPaths, ThousandsOfEndsInOnePointTakeNoLongerThanApart) {
  constexpr int lines = 60000;
  const auto seconds_of = [](double apart) {
    std::vector<PiecePath> paths;
    for (int i = 0; i < lines; ++i) paths.push_back(line(apart * i, 0, 1 + apart * i, 1 + i));
    const auto start = std::chrono::steady_clock::now();
    const JoinedPaths joined = join_paths(paths);
    EXPECT_EQ(joined.open.size(), apart > 0 ? lines : lines / 2);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  // Where each search looks at all ends in the point, it is a hundred times.
  EXPECT_LT(seconds_of(0), 10 * seconds_of(2));
}

TEST(JoinPaths, PointsFollowCurvesToTheTolerance) {
  const PiecePath arc = {EdgeCurve::arc({1, 0}, {-1, 0}, 1, false, true)};
  for (const double tolerance : {1e-3, 1e-5}) {
    const std::vector<Vec2> points = path_points(arc, tolerance);
    for (std::size_t i = 1; i < points.size(); ++i) {
      EXPECT_LT(1 - ((points[i] + points[i - 1]) / 2).norm(), tolerance);
    }
  }
  EXPECT_LT(path_points(arc, 1e-3).size(), 100u);
}

}  // namespace join_paths_test
}  // namespace toile
