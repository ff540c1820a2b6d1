#include "geometry/body/skin_cores.h"

#include <gtest/gtest.h>

#include "geometry/body/mannequin/mannequin.h"

namespace toile {
namespace skin_cores_test {

int core_near(const Mannequin& made, const SkinCores& cores, const Vec3& place) {
  int nearest = 0;
  for (int i = 0; i < static_cast<int>(made.surface.points.size()); ++i) {
    if ((made.surface.points[i] - place).norm() < (made.surface.points[nearest] - place).norm()) {
      nearest = i;
    }
  }
  return cores.bone_of[nearest];
}

TEST(SkinCores, AreWhereTheBonesAreAndLeaveTheJointsFree) {
  const Mannequin made = make_mannequin({.edge_length = 0.014});
  const SkinCores cores = skin_cores(made.surface, made.skeleton, "mannequin");
  for (const bool left : {true, false}) {
    const std::string side = left ? "left_" : "right_";
    const auto between = [&](const std::string& from, const std::string& to, double share) {
      const Vec3& a = made.skeleton.joint(side + from);
      return Vec3(a + share * (made.skeleton.joint(side + to) - a));
    };
    const auto core_at = [&](const std::string& from, const std::string& to, double share) {
      return core_near(made, cores, between(from, to, share));
    };
    EXPECT_EQ(core_at("shoulder", "elbow", 0.6), bone_index(Bone::upper_arm, left));
    EXPECT_EQ(core_at("elbow", "wrist", 0.7), bone_index(Bone::forearm, left));
    EXPECT_EQ(core_at("hip", "knee", 0.55), bone_index(Bone::thigh, left));
    EXPECT_EQ(core_at("knee", "ankle", 0.5), bone_index(Bone::shin, left));
    for (const std::string joint : {"shoulder", "elbow", "hip", "knee"}) {
      EXPECT_EQ(core_near(made, cores, made.skeleton.joint(side + joint)), SkinCores::no_bone)
          << joint;
    }
    const FootShape& foot = cores.feet[left ? 0 : 1];
    EXPECT_GT(foot.along.z(), 0.95);
    const Vec3 ankle = made.skeleton.joint(side + "ankle");
    EXPECT_EQ(core_near(made, cores, Vec3(ankle.x(), 0, ankle.z())), bone_index(Bone::foot, left));
    EXPECT_EQ(core_near(made, cores, foot.ball + 0.05 * foot.along), bone_index(Bone::toes, left));
  }
  for (const std::string joint : {"head", "neck", "waist"}) {
    EXPECT_EQ(core_near(made, cores, made.skeleton.joint(joint)), bone_index(Bone::trunk, true))
        << joint;
  }
}

}  // namespace skin_cores_test
}  // namespace toile
