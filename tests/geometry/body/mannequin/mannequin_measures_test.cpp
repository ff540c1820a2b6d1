#include "geometry/body/mannequin/mannequin_measures.h"

#include <gtest/gtest.h>

#include "geometry/body/mannequin/mannequin_build.h"

namespace toile {
namespace mannequin_measures_test {

Mannequin meshed(const MannequinBuild& build) {
  MannequinOptions options;
  options.edge_length = 0.015;
  return mesh_mannequin(built_mannequin(build), options);
}

double section_of_upper_arm(const Mannequin& mannequin) {
  for (const MannequinGirth& girth : mannequin.girths) {
    if (girth.name == "upper arm") return girth.measured;
  }
  return 0;
}

TEST(MannequinMeasures, AnArmThatTouchesTheTrunkIsNotMeasuredWithIt) {
  MannequinBuild large;
  for (const BuildPart part : {BuildPart::chest, BuildPart::underbust, BuildPart::waist,
                               BuildPart::abdomen, BuildPart::hip, BuildPart::upper_arm}) {
    large[part] = 1.4;
  }
  const Mannequin made = meshed(large);
  ASSERT_GT(section_of_upper_arm(made), 1);  // it does hold the trunk
  const MeasureValues measures = mannequin_measures(made);
  ASSERT_TRUE(measures.contains("upper_arm"));
  // Nearer to the elbow, where the arm is free, it is a little thinner.
  const double whole = 1.4 * section_of_upper_arm(meshed({}));
  EXPECT_LT(measures.at("upper_arm"), whole + 0.01);
  EXPECT_GT(measures.at("upper_arm"), 0.85 * whole);
}

}  // namespace mannequin_measures_test
}  // namespace toile
