#include "geometry/closed_surface.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace toile {
namespace closed_surface_test {

const Vec3 low(0, 0, 0);
const Vec3 high(1, 1, 1);

TEST(ClosedSurface, BoxesAndSpheresAreClosed) {
  EXPECT_EQ(closed_surface_defect(test::box(low, high)), "");
  EXPECT_EQ(closed_surface_defect(test::sphere(0.1, 2)), "");
}

TEST(ClosedSurface, AMissingTriangleLeavesThreeBorderEdges) {
  TriangleMesh mesh = test::box(low, high);
  mesh.triangles.pop_back();
  EXPECT_EQ(closed_surface_defect(mesh), "has 3 border edges");
}

TEST(ClosedSurface, ATurnedTriangleIsFound) {
  TriangleMesh mesh = test::box(low, high);
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  EXPECT_EQ(closed_surface_defect(mesh), "has 3 edges whose triangles face opposite sides");
}

TEST(ClosedSurface, AFinIsFound) {
  TriangleMesh mesh = test::box(low, high);
  mesh.triangles.push_back(mesh.triangles[0]);
  EXPECT_EQ(closed_surface_defect(mesh), "has 3 edges with more than two triangles");
}

TEST(ClosedSurface, InsideOutIsFoundFarFromTheOriginToo) {
  const Vec3 far(50, 0, 0);
  const TriangleMesh box = test::box(far, far + Vec3(0.1, 0.1, 0.1));
  EXPECT_EQ(closed_surface_defect(box), "");
  EXPECT_EQ(closed_surface_defect(test::inside_out(box)), "is inside out or encloses nothing");
  EXPECT_EQ(closed_surface_defect({}), "has no triangles");
}

}  // namespace closed_surface_test
}  // namespace toile
