#include "geometry/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

#include "geometry/closest_points.h"
#include "tests/support/shapes.h"

namespace toile {
namespace triangle_tree_test {

/// Triangles of random sizes and places, some of them without area.
TriangleMesh loose(int count, double scale, const Vec3& middle) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  TriangleMesh mesh;
  for (int t = 0; t < count; ++t) {
    const Vec3 at = middle + scale * Vec3(unit(random), unit(random), unit(random));
    const double size = scale * std::array{0.5, 0.02, 0.0}[static_cast<std::size_t>(t % 17 % 3)];
    for (int i = 0; i < 3; ++i) {
      mesh.points.push_back(at + size * Vec3(unit(random), unit(random), unit(random)));
    }
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

double distance(const TriangleMesh& mesh, int triangle, const Vec3& p) {
  const Triangle& t = mesh.triangles[triangle];
  const Vec3 w = closest_on_triangle(p, mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  return (w[0] * mesh.points[t[0]] + w[1] * mesh.points[t[1]] + w[2] * mesh.points[t[2]] - p)
      .norm();
}

TEST(TriangleTree, FindsWhatLookingAtEveryTriangleFinds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const int count : {1, 2, 7, 8, 9, 64, 65, 600}) {
    // Some trees are far from the origin, where single precision is coarse.
    for (const Vec3& middle : {Vec3(0, 0, 0), Vec3(700, -300, 2000)}) {
      const TriangleMesh mesh = loose(count, 0.3, middle);
      const TriangleTree tree(mesh);
      std::vector<int> found;
      for (int i = 0; i < 60; ++i) {
        const double off = std::array{0.3, 2.0, 1e-3}[static_cast<std::size_t>(i % 3)];
        const Vec3 p = mesh.points[random() % mesh.points.size()] +
                       off * Vec3(unit(random), unit(random), unit(random));
        double least = 1e9;
        for (int t = 0; t < count; ++t) least = std::min(least, distance(mesh, t, p));
        EXPECT_EQ(distance(mesh, tree.closest_triangle(p), p), least);
        EXPECT_EQ(distance(mesh, tree.closest_triangle(p, i % count), p), least);
        found.clear();
        const Vec3 reach = Vec3::Constant(1.2 * least + 0.01);
        tree.meeting(p - reach, p + reach, found);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
        for (int t = 0; t < count; ++t) {
          const bool listed = std::binary_search(found.begin(), found.end(), t);
          EXPECT_TRUE(listed || distance(mesh, t, p) > 1.2 * least + 0.01);
        }
      }
    }
  }
}

TEST(TriangleTree, FindsForPointsTogetherWhatItFindsForEach) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<TriangleMesh> meshes = {test::sphere(0.1, 4), test::box({-1, -1, -1}, {1, 1, 1})};
  for (const int count : {1, 9, 600}) {
    meshes.push_back(loose(count, 0.3, {0, 0, 0}));
    meshes.push_back(loose(count, 0.3, {70, -30, 20}));
  }
  for (const TriangleMesh& mesh : meshes) {
    const TriangleTree tree(mesh);
    for (int i = 0; i < 200; ++i) {
      // In and about the mesh; now and then in a corner of it.
      const double off = std::array{0.3, 0.01, 0.0}[static_cast<std::size_t>(i % 3)];
      const double apart = std::array{0.01, 0.1, 1e-6, 0.0}[static_cast<std::size_t>(i % 4)];
      const Vec3 middle = mesh.points[random() % mesh.points.size()] +
                          off * Vec3(unit(random), unit(random), unit(random));
      std::vector<Vec3> points(1 + i % TriangleTree::most_points, middle);
      for (Vec3& p : points) p += apart * Vec3(unit(random), unit(random), unit(random));
      std::vector<int> found(points.size());
      tree.closest_triangles(points, i % static_cast<int>(mesh.triangles.size()), found.data());
      for (std::size_t k = 0; k < points.size(); ++k) {
        ASSERT_EQ(found[k], tree.closest_triangle(points[k]));
      }
    }
  }
}

// Otherwise the values of a distance grid would depend on the order in which it is filled.
TEST(TriangleTree, AHintChangesNoAnswerThoughSeveralAreAsNear) {
  TriangleMesh mesh = test::box({-1, -1, -1}, {1, 1, 1});
  const int count = static_cast<int>(mesh.triangles.size());
  const std::vector<Triangle> once = mesh.triangles;
  mesh.triangles.insert(mesh.triangles.end(), once.rbegin(), once.rend());
  const TriangleTree tree(mesh);
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(2, 2, 2), Vec3(0, 3, 0), Vec3(0.2, -0.3, 5)}) {
    double least = 1e9;
    int first = 0;
    for (int t = 0; t < 2 * count; ++t) {
      if (distance(mesh, t, p) >= least) continue;
      least = distance(mesh, t, p);
      first = t;
    }
    EXPECT_EQ(tree.closest_triangle(p), first) << p.transpose();
    for (int hint = 0; hint < 2 * count; ++hint)
      EXPECT_EQ(tree.closest_triangle(p, hint), first) << hint;
  }
}

TEST(TriangleTree, FindsWhatMeetsABox) {
  const TriangleMesh mesh = test::sphere(0.1, 4);
  const TriangleTree tree(mesh);
  std::vector<int> found;
  tree.meeting({0, 0, 0}, {0.2, 0.2, 0.2}, found);
  std::sort(found.begin(), found.end());
  int corners_inside = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const bool listed = std::binary_search(found.begin(), found.end(), t);
    bool has_corner = false;
    for (const int corner : mesh.triangles[t]) {
      has_corner = has_corner || mesh.points[corner].minCoeff() >= 0;
    }
    corners_inside += has_corner;
    EXPECT_TRUE(listed || !has_corner);
  }
  EXPECT_LT(static_cast<int>(found.size()), 1.2 * corners_inside);
  EXPECT_GT(corners_inside, 0);
}

TEST(TriangleTree, AnswersWhateverItIsAsked) {
  const TriangleMesh mesh = test::sphere(0.1, 3);
  const TriangleTree tree(mesh);
  for (const double odd : {std::nan(""), HUGE_VAL, 1e30, -1e300}) {
    const int found = tree.closest_triangle({odd, 0, 0});
    EXPECT_GE(found, 0);
    EXPECT_LT(found, static_cast<int>(mesh.triangles.size()));
  }
}

}  // namespace triangle_tree_test
}  // namespace toile
