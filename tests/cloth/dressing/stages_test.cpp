#include "cloth/dressing/stages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "cloth/dressing/constants.h"
#include "cloth/scene/collider.h"
#include "geometry/intersections.h"
#include "tests/cloth/panels.h"
#include "tests/support/tubes.h"

namespace toile {
namespace stages_test {

/// A run that stopped with a residual of whole patches.
StageReport stopped_at(double wide) {
  StageReport report;
  report.converged = false;
  report.residual = {0.0005, 0.001, 0.1, wide};
  return report;
}

TEST(IsAtRest, ByWhatIsAskedForThoughAReleaseTriesForLess) {
  DressOptions wanted;
  const double between = 0.5 * (releasable_residual + wanted.stop_wide);
  ASSERT_LT(releasable_residual, wanted.stop_wide);
  for (const double seconds : {0.0, 1.0}) {
    wanted.release_seconds = seconds;
    EXPECT_TRUE(is_at_rest(stopped_at(between), wanted)) << seconds;
    EXPECT_FALSE(is_at_rest(stopped_at(1.1 * wanted.stop_wide), wanted)) << seconds;
  }
  RelaxOptions options;
  ask_for_rest(wanted, options);
  EXPECT_EQ(options.stop_wide, releasable_residual);
  wanted.release_seconds = 0;
  ask_for_rest(wanted, options);
  EXPECT_EQ(options.stop_wide, wanted.stop_wide);
}

// A tube half as wide as the body stands around it, widened, and gets its own width back.
TEST(Shrink, ClothFarTooSmallForTheBodyStaysAroundIt) {
  constexpr int columns = 12;
  constexpr int rows = 4;
  constexpr double around = 0.3;
  const TriangleMesh body = test::closed_tube(0.1, 0.1, 2, 64);
  const Collider collider(body);
  PanelMesh garment;
  for (const int half : {0, 1}) {
    test::add_panel(garment, half == 0 ? "front" : "back",
                    test::grid(around / 2, 0.15, columns, rows), [&](const Vec2& p) {
                      const double angle = std::numbers::pi * (half + 2 * p.x() / around);
                      return Vec3(0.11 * std::sin(angle), 1 + p.y(), 0.11 * std::cos(angle));
                    });
  }
  garment.seams = test::side_seams(garment, columns, rows);
  Scene scene;
  scene.collider = &collider;
  const Level level = compiled_level(garment, 0, closing_scene(scene), garment.placed, 0.002);
  const Widening wide(level.model.stretch.size(), {2.3, 1, 0});
  Staged staged;
  staged.state.nodes = level.model.start;
  Journal journal({});
  staged = shrink(level, std::move(staged), wide, closing_pull, journal);
  EXPECT_TRUE(intersections({staged.state.nodes, level.model.node_triangles}, body).empty());
  // 24 chords, at least 2 mm off the skin: it pulled itself to the body.
  for (const Vec3& p : staged.state.nodes) EXPECT_NEAR(std::hypot(p.x(), p.z()), 0.102, 0.002);
  // Nothing is done with cloth that closed in its own width.
  const std::vector<Vec3> before = staged.state.nodes;
  staged = shrink(level, std::move(staged), {}, closing_pull, journal);
  EXPECT_EQ(staged.state.nodes, before);
}

}  // namespace stages_test
}  // namespace toile
