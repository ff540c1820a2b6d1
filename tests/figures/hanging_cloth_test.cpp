#include "tests/figures/hanging_cloth.h"

#include <gtest/gtest.h>

#include <iostream>

namespace toile::figures {
namespace hanging_cloth_test {

HangingCloth hang(const char* name, const HangingClothOptions& options) {
  HangingCloth cloth = hang_cloth(options);
  std::cout << name << ", step " << 1e3 * options.dt << " ms: corners "
            << 100 * cloth.strain.corners << " %, max " << 100 * cloth.strain.max << " %, p99 "
            << 100 * cloth.strain.p99 << " %, on the way " << 100 * cloth.max_during << " %; "
            << cloth.passes << " passes a step; fastest " << cloth.fastest << " m/s after "
            << cloth.seconds << " s\n";
  EXPECT_FALSE(cloth.blew_up);
  return cloth;
}

TEST(HangingCloth, WithoutControlItsCornersAreSuperElastic) {
  const HangingCloth cloth = hang("none", {});
  EXPECT_TRUE(cloth.at_rest);
  EXPECT_GT(cloth.strain.corners, 0.2);
  EXPECT_EQ(cloth.strain.corners, cloth.strain.max);
}

TEST(HangingCloth, PositionsAreHeldTo10PercentOnlyBySweepingUntilTheyAre) {
  HangingClothOptions options;
  options.scheme = StrainScheme::position;
  options.control = provot_options();
  options.dt = 0.0005;
  options.seconds_max = 1.5;
  const HangingCloth once = hang("positions, one sweep", options);
  EXPECT_LT(once.strain.corners, 0.22);
  EXPECT_GT(once.strain.corners, 0.12);
  options.control.passes = 1000;
  options.control.tolerance = 0.001;
  const HangingCloth converged = hang("positions, to 0.1 %", options);
  EXPECT_LE(converged.strain.max, 0.101);
}

TEST(HangingCloth, ThreePassesHoldOnePercentAsTheStepShrinks) {
  HangingClothOptions options;
  options.scheme = StrainScheme::velocity;
  options.seconds_max = 1.5;
  double excess = 1;
  for (const double dt : {0.0005, 0.00025, 0.000125}) {
    options.dt = dt;
    const HangingCloth cloth = hang("velocities, three passes", options);
    const double now = cloth.strain.max - 0.01;
    EXPECT_LT(now, excess / 2);
    excess = now;
  }
  EXPECT_LT(excess, 0.003);
}

TEST(HangingCloth, SweepingInOrderHoldsOnePercentAtAnyStep) {
  HangingClothOptions options;
  options.scheme = StrainScheme::velocity;
  options.seconds_max = 1.5;
  options.control.sweep = StrainSweep::in_order;
  options.control.mean_of_passes = false;
  options.control.passes = 1000;
  options.control.tolerance = 0.001;
  for (const double dt : {0.002, 0.001}) {
    options.dt = dt;
    const HangingCloth cloth = hang("velocities, in order to 0.1 %", options);
    EXPECT_LE(cloth.max_during, 0.011);
  }
}

}  // namespace hanging_cloth_test
}  // namespace toile::figures
