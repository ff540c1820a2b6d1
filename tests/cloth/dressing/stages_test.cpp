#include "cloth/dressing/stages.h"

#include <gtest/gtest.h>

#include "cloth/dressing/constants.h"

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

}  // namespace stages_test
}  // namespace toile
