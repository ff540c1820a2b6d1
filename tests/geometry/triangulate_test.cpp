#include "geometry/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "geometry/angles.h"
#include "geometry/error.h"

namespace toile {
namespace triangulate_test {

const std::vector<Vec2> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(Triangulate, ASquareAndItsMiddle) {
  EXPECT_EQ(triangulate(square, {}).size(), 2u);
  const std::vector<Triangle> fan = triangulate(square, {{0.4, 0.5}});
  EXPECT_EQ(fan, (std::vector<Triangle>{{0, 1, 4}, {0, 4, 3}, {1, 2, 4}, {2, 3, 4}}));
}

TEST(Triangulate, KeepsEverySegmentOfANotchedOutline) {
  const std::vector<Vec2> notch = {{0, 0}, {4, 0}, {4, 4}, {2, 0.1}, {0, 4}};
  const std::vector<Triangle> triangles = triangulate(notch, {{0.5, 1}, {3.5, 1}});
  ASSERT_EQ(triangles.size(), 5u + 4u - 2u);
  std::set<std::array<int, 2>> edges;
  std::vector<Vec2> points = notch;
  points.insert(points.end(), {{0.5, 1}, {3.5, 1}});
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    edges.insert({{a, b}, {b, c}, {c, a}});
    const Vec2 u = points[static_cast<std::size_t>(b)] - points[static_cast<std::size_t>(a)];
    const Vec2 v = points[static_cast<std::size_t>(c)] - points[static_cast<std::size_t>(a)];
    area += (u.x() * v.y() - u.y() * v.x()) / 2;
  }
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(edges.count({i, (i + 1) % 5}));
  EXPECT_NEAR(area, 16 - 0.5 * 4 * 3.9, 1e-12);
}

TEST(Triangulate, HolesStayEmpty) {
  const std::vector<Vec2> hole = {{0.3, 0.3}, {0.6, 0.3}, {0.3, 0.6}};
  // Four corners, three of the hole, two inner points.
  EXPECT_EQ(triangulate(square, {{0.1, 0.5}, {0.8, 0.8}}, {hole}).size(), 7u + 2u * 2u);
  EXPECT_EQ(triangulate(square, {}, {hole, {{0.7, 0.7}, {0.8, 0.7}, {0.7, 0.8}}}).size(), 12u);
  EXPECT_THROW(triangulate(square, {{0.35, 0.35}}, {hole}), Error) << "a point in the hole";
  EXPECT_THROW(triangulate(square, {}, {{{0.5, 0.5}, {1.5, 0.5}, {0.5, 0.7}}}), Error);
  EXPECT_THROW(triangulate(square, {}, {{{2, 2}, {3, 2}, {2, 3}}}), Error) << "outside";
}

TEST(Triangulate, RefusesWhatHasNoInside) {
  EXPECT_THROW(triangulate({{0, 0}, {1, 0}}, {}), Error);
  EXPECT_THROW(triangulate({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}), Error);
  EXPECT_THROW(triangulate(square, {{0.5, 0.5}, {0.5, 0.5}}), Error);
  EXPECT_THROW(triangulate(square, {{0.5, 0}}), Error);
  EXPECT_THROW(triangulate(square, {{2, 0.5}}), Error);
}

TEST(Triangulate, SmallestAngleIsNegativeForATurnedTriangle) {
  EXPECT_NEAR(smallest_angle({0, 0}, {1, 0}, {0, 1}), to_radians(45), 1e-15);
  EXPECT_NEAR(smallest_angle({0, 0}, {0, 1}, {1, 0}), to_radians(-45), 1e-15);
  EXPECT_LE(smallest_angle({0, 0}, {1, 0}, {2, 0}), 0);
  EXPECT_NEAR(smallest_angle(square, {{0, 1, 2}, {0, 2, 3}}), to_radians(45), 1e-15);
}

}  // namespace triangulate_test
}  // namespace toile
