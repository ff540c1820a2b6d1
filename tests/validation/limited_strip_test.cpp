// The hanging strip whose strain is limited to 1 %: springs and control together.
#include <gtest/gtest.h>

#include <iostream>

#include "cloth/springs/strain_control.h"
#include "tests/support/spring_motion.h"

namespace toile {
namespace limited_strip_test {

constexpr double areal_density = 0.2;  // kg/m²
constexpr double stretch = 65.4;       // N/m
constexpr double drag_rate = 40;       // 1/s

struct Hung {
  double total;  ///< elongation, m
  double max;    ///< strain
  double passes;
  double fastest;
};

Hung hang(int links, double dt, const StrainControlOptions& options) {
  const test::HangingChain chain = test::hanging_chain(links, areal_density, stretch);
  test::SpringMotion motion(chain.springs, chain.x, chain.mass, drag_rate, {0, -9.81, 0});
  StrainControl control(chain.springs, links + 1);
  long passes = 0;
  const int steps = static_cast<int>(2 / dt);
  for (int n = 0; n < steps; ++n) {
    motion.step(dt, [&] {
      passes +=
          control.adjust_velocities(motion.x, motion.inverse_mass, dt, options, motion.v).passes;
    });
  }
  Hung hung{-motion.x.back().y() - 1, 0, double(passes) / steps, motion.fastest()};
  for (const Spring& s : chain.springs) {
    hung.max = std::max(hung.max, (motion.x[s.b] - motion.x[s.a]).norm() / s.rest - 1);
  }
  return hung;
}

TEST(LimitedStrip, SweepingInOrderGivesTheLimitedElongation) {
  const struct {
    int links;
    double total;  // reference case 3, half end mass
  } rows[] = {{4, 0.0084375}, {16, 0.00833984375}};
  StrainControlOptions options;
  options.sweep = StrainSweep::in_order;
  options.mean_of_passes = false;
  options.passes = 10000;
  options.tolerance = 1e-6;
  for (const auto& row : rows) {
    const Hung hung = hang(row.links, 0.001, options);
    std::cout << row.links << " links: elongation off by " << hung.total / row.total - 1
              << " of it, strain over the limit " << hung.max - 0.01 << ", " << hung.passes
              << " sweeps a step, fastest " << hung.fastest << " m/s\n";
    EXPECT_NEAR(hung.total / row.total, 1, 1e-4);  // the tolerance over 1 %
    EXPECT_LT(hung.max, 0.01 + 1.01e-6);
  }
}

TEST(LimitedStrip, ThreePassesActAsASpringThatTheStepMakesStiff) {
  // Take a spring with two moving ends, each with one more spring beyond the limit. A pass takes a
  // quarter of its excess times m/dt²; the mean of three passes takes half. So beyond the limit the
  // strip is as if its springs were stiffer by m/(2 dt²), no more.
  const int links = 16;
  const double h = 1.0 / links;
  for (const double dt : {0.002, 0.001, 0.0005, 0.00025}) {
    const Hung hung = hang(links, dt, {});
    const double stiffness = areal_density * h / (2 * dt * dt);
    const double load = areal_density * 9.81 * h * (links - 1.5);  // of the second spring
    const double expected = (load - 0.01 * stretch) / (stretch / h + stiffness) / h;
    const double excess = hung.max - 0.01;
    std::cout << "step " << 1e3 * dt << " ms: excess " << 100 * excess << " %, expected "
              << 100 * expected << " %, elongation " << hung.total / 0.00833984375 - 1
              << " of it too long, fastest " << hung.fastest << " m/s\n";
    EXPECT_NEAR(excess / expected, 1, dt > 0.0005 ? 0.1 : 0.01);
  }
}

}  // namespace limited_strip_test
}  // namespace toile
