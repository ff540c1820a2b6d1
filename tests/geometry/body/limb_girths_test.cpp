#include "geometry/body/limb_girths.h"

#include <gtest/gtest.h>

#include "geometry/body/mannequin/mannequin.h"

namespace toile {
namespace limb_girths_test {

TEST(LimbGirths, GrowWithTheBodyAndAreTheMannequins) {
  const Mannequin made = make_mannequin({.edge_length = 0.014});
  TriangleMesh larger = made.surface;
  for (Vec3& p : larger.points) p *= 1.1;
  Skeleton joints = made.skeleton;
  for (auto& [name, joint] : joints.joints) joint *= 1.1;
  const std::vector<LimbGirth> girths = limb_girths(made.surface, made.skeleton, larger, joints);
  ASSERT_EQ(girths.size(), 28u);
  for (const LimbGirth& girth : girths) {
    EXPECT_NEAR(girth.posed / girth.standing, 1.1, 1e-9) << girth.name;
    if (girth.name == "left knee") {
      EXPECT_NEAR(girth.standing, 0.353, 0.006);
    }
    if (girth.name == "right elbow") {
      EXPECT_NEAR(girth.standing, 0.25, 0.01);
    }
  }
}

}  // namespace limb_girths_test
}  // namespace toile
