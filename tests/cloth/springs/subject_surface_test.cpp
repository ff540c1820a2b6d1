#include "cloth/springs/subject_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <random>

#include "tests/cloth/springs/collision_scene.h"
#include "tests/support/shapes.h"

namespace toile {
namespace subject_surface_test {

int ridges(const SubjectSurface& surface) {
  int count = 0;
  for (int t = 0; t < static_cast<int>(surface.mesh().triangles.size()); ++t) {
    for (int side = 0; side < 3; ++side) {
      if (!surface.owns_edge(t, side)) continue;
      count += surface.edge(surface.facet_edges(t)[side]).ridge ? 1 : 0;
    }
  }
  return count;
}

int tips(const SubjectSurface& surface) {
  int count = 0;
  for (int v = 0; v < static_cast<int>(surface.mesh().points.size()); ++v) {
    count += surface.is_tip(v) ? 1 : 0;
  }
  return count;
}

TEST(SubjectSurface, OnlyWhatCanBeTouchedFirstIsLookedAfter) {
  const SubjectSurface cube(test::cube());
  EXPECT_EQ(ridges(cube), 12);  // not the diagonals of its sides
  EXPECT_EQ(tips(cube), 8);
  const SubjectSurface hollow(test::inside_out(test::cube()));
  EXPECT_EQ(ridges(hollow), 0);
  EXPECT_EQ(tips(hollow), 0);
  const SubjectSurface sheet(test::level_sheet(3, 3, 1, 0));
  EXPECT_EQ(ridges(sheet), 12);  // its border
  for (int v = 0; v < 16; ++v) {
    const bool inside = v == 5 || v == 6 || v == 9 || v == 10;
    EXPECT_EQ(sheet.on_rim(v), !inside);
  }
}

TEST(SubjectSurface, NearestOfAllFacetsIsTheBodysSignedDistance) {
  const TriangleMesh ball = test::sphere(0.1, 2);
  const TriangleMesh mesh = test::together(ball, test::box({0.2, 0, 0}, {0.3, 0.01, 0.2}));
  const SubjectSurface surface(mesh);
  const SurfaceDistance body(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> some(-0.3, 0.3);
  double error = 0;
  double turned = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p(some(random), some(random), some(random));
    std::optional<SubjectNearest> nearest;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      const SubjectNearest found = surface.nearest(p, t);
      if (!nearest || std::abs(found.distance) < std::abs(nearest->distance)) nearest = found;
    }
    const SurfacePoint expected = body.closest_point(p);
    error = std::max(error, std::abs(nearest->distance - expected.distance));
    EXPECT_TRUE(nearest->local);
    // The point lies `distance` along the direction from the surface, on either side.
    turned = std::max(turned, (nearest->point + nearest->distance * nearest->direction - p).norm());
  }
  EXPECT_LT(error, 1e-12);
  EXPECT_LT(turned, 1e-12);
  std::cout << "signed distance within " << error << " m of the body's\n";
}

TEST(SubjectSurface, FacetsInABoxAreAllThatMeetIt) {
  const TriangleMesh mesh = test::sphere(0.1, 3);
  const SubjectSurface surface(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> some(-0.1, 0.1);
  std::vector<int> found;
  for (int i = 0; i < 200; ++i) {
    const Vec3 middle(some(random), some(random), some(random));
    const Vec3 half = Vec3::Constant(0.02);
    surface.facets_in_box(middle - half, middle + half, found);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      const double distance = std::abs(surface.nearest(middle, t).distance);
      const bool listed = std::binary_search(found.begin(), found.end(), t);
      EXPECT_TRUE(listed || distance > 0.02);
      EXPECT_FALSE(listed && distance > 0.02 * std::sqrt(3.0));
    }
  }
}

TEST(SubjectSurface, BordersHaveNoInside) {
  const SubjectSurface sheet(test::level_sheet(1, 1, 0.1, 0));
  // Beyond the border and below: in front of the border all the same. Below the sheet: behind.
  const SubjectNearest beyond = sheet.nearest({0.2, -0.01, 0.2}, 1);
  EXPECT_NEAR(beyond.distance, std::hypot(0.15, 0.15, 0.01), 1e-15);
  EXPECT_TRUE(beyond.local);
  for (const int facet : {0, 1}) {
    const SubjectNearest below = sheet.nearest({facet == 0 ? -0.02 : 0.02, -0.01, 0}, facet);
    EXPECT_NEAR(below.distance, -0.01, 1e-15);
    EXPECT_NEAR(below.direction.y(), 1, 1e-15);
  }
}

}  // namespace subject_surface_test
}  // namespace toile
