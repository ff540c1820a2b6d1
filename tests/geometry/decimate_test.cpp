#include "geometry/decimate.h"

#include <gtest/gtest.h>

#include "geometry/closed_surface.h"
#include "geometry/surface_distance.h"
#include "tests/support/shapes.h"

namespace toile {
namespace decimate_test {

TEST(Decimate, KeepsTheShapeAndTheTopology) {
  const TriangleMesh fine = test::sphere(0.5, 6);  // 32768 triangles
  const TriangleMesh light = decimate(fine, 2000);
  EXPECT_LE(light.triangles.size(), 2000u);
  EXPECT_GT(light.triangles.size(), 1900u);
  EXPECT_EQ(closed_surface_defect(light), "");
  // 2000 triangles of a sphere stand off it by some edge²/8R: 3 mm.
  const SurfaceDistance exact(fine);
  for (const Vec3& p : light.points) EXPECT_LT(std::abs(exact.closest_point(p).distance), 0.004);
  EXPECT_EQ(static_cast<int>(light.points.size()) - static_cast<int>(light.triangles.size()) / 2, 2)
      << "Euler's number of a sphere";
}

TEST(Decimate, LeavesAloneWhatIsSmallOrNoManifold) {
  EXPECT_EQ(decimate(test::cube(), 12).triangles, test::cube().triangles);
  TriangleMesh fins;
  fins.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  fins.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  EXPECT_EQ(decimate(fins, 1).triangles, fins.triangles);
}

}  // namespace decimate_test
}  // namespace toile
