#include "cloth/springs/spring_forces.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <iostream>
#include <numbers>
#include <random>

#include "geometry/error.h"
#include "tests/support/spring_energy.h"
#include "tests/support/spring_motion.h"

namespace toile {
namespace spring_forces_test {

using test::SpringMotion;

class RandomSprings : public testing::Test {
 protected:
  RandomSprings() {
    test::SpringGridOptions options;
    options.columns = options.rows = 50;  // more than one chunk of nodes
    options.shear = 30;
    options.bending = 5;
    options.damping = 0.3;
    grid = test::spring_grid(options);
    springs = grid.all();
    x = grid.x;
    for (Vec3& p : x) p += random_vector(0.02);
    for (std::size_t n = 0; n < x.size(); ++n) v.push_back(random_vector(1));
  }

  Vec3 random_vector(double size) { return size * Vec3(unit(random), unit(random), unit(random)); }

  std::vector<Vec3> forces(const std::vector<Vec3>& speeds) const {
    std::vector<Vec3> force(x.size(), Vec3::Zero());
    SpringForces(springs, static_cast<int>(x.size())).add(x, speeds, force);
    return force;
  }

  std::mt19937 random{3};
  std::uniform_real_distribution<double> unit{-1, 1};
  test::SpringGrid grid;
  std::vector<Spring> springs;
  std::vector<Vec3> x;
  std::vector<Vec3> v;
};

TEST_F(RandomSprings, ForcesAreMinusTheGradientOfTheEnergy) {
  const std::vector<Vec3> force = forces(std::vector<Vec3>(x.size(), Vec3::Zero()));
  double worst = 0;
  for (const std::size_t n : {0, 49, 1234, 2499}) {
    for (int k = 0; k < 3; ++k) {
      const double h = 1e-5;
      std::vector<Vec3> moved = x;
      moved[n][k] += h;
      const double above = spring_energy(springs, moved);
      moved[n][k] -= 2 * h;
      const double below = spring_energy(springs, moved);
      worst = std::max(worst, std::abs(force[n][k] + (above - below) / (2 * h)) / force[n].norm());
    }
  }
  std::cout << "force against the energy's differences: relative error " << worst << "\n";
  EXPECT_LT(worst, 1e-5);
}

TEST_F(RandomSprings, DampingTakesTheEnergyItShould) {
  const std::vector<Vec3> still = forces(std::vector<Vec3>(x.size(), Vec3::Zero()));
  const std::vector<Vec3> moving = forces(v);
  double power = 0;
  for (std::size_t n = 0; n < x.size(); ++n) power += (moving[n] - still[n]).dot(v[n]);
  double expected = 0;
  for (const Spring& s : springs) {
    const double rate = (x[s.b] - x[s.a]).normalized().dot(v[s.b] - v[s.a]);
    expected -= s.damping * rate * rate;
  }
  EXPECT_LT(expected, 0);
  EXPECT_NEAR(power / expected, 1, 1e-12);
}

TEST_F(RandomSprings, MomentumAndAngularMomentumAreKept) {
  const std::vector<Vec3> force = forces(v);
  Vec3 sum = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  double size = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    sum += force[n];
    torque += x[n].cross(force[n]);
    size += force[n].norm();
  }
  std::cout << "sum of forces " << sum.norm() / size << ", of torques " << torque.norm() / size
            << " m, as shares of the forces\n";
  EXPECT_LT(sum.norm() / size, 1e-14);
  EXPECT_LT(torque.norm() / size, 1e-14);
}

TEST_F(RandomSprings, SameBitsForAnyNumberOfThreads) {
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return forces(v);
  };
  EXPECT_EQ(with_threads(1), with_threads(4));
}

TEST(SpringForces, RefusesWhatIsNoSpring) {
  const auto build = [](const Spring& spring) { SpringForces(std::vector{spring}, 2); };
  EXPECT_NO_THROW(build({0, 1, 0.1, 1, 0}));
  EXPECT_THROW(build({0, 2, 0.1, 1, 0}), Error);
  EXPECT_THROW(build({1, 1, 0.1, 1, 0}), Error);
  EXPECT_THROW(build({0, 1, 0, 1, 0}), Error);
  EXPECT_THROW(build({0, 1, NAN, 1, 0}), Error);
}

TEST(SpringForces, EndsOnOnePlaceGetNothing) {
  const std::vector<Vec3> x(2, Vec3::Zero());
  std::vector<Vec3> force(2, Vec3::Zero());
  SpringForces(test::spring_chain(1, 1, 1, 1), 2).add(x, x, force);
  EXPECT_EQ(force[0], Vec3::Zero());
}

/// One mass on a spring, let go 1 % too long.
SpringMotion oscillator(double stiffness, double mass_a, double mass_b) {
  return {test::spring_chain(1, 1, stiffness),
          {{0, 0, 0}, {1.01, 0, 0}},
          {mass_a, mass_b},
          0,
          Vec3::Zero()};
}

TEST(SpringForces, OscillatorsKeepPhaseAndEnergyAsSymplecticEulerDoes) {
  // Reference case 10: energy after 1000 steps, lowest and highest over the energy at the start.
  const struct {
    double z, last, lowest, highest;
  } rows[] = {{0.05, 1.0125205541297, 0.975609770217253, 1.02564102312434},
              {0.1, 1.04264217322333, 0.952380964912588, 1.05263132566421},
              {0.5, 1.22142128658297, 0.800000238742537, 1.33333201071635},
              {1.9, 8.17810896642384, 0.512821128126986, 19.9997954156411}};
  const double omega = std::sqrt(10.0);
  double worst_energy = 0;
  double worst_phase = 0;
  for (const auto& row : rows) {
    SpringMotion motion = oscillator(10, 0, 1);
    const double dt = row.z / omega;
    const auto energy = [&] {
      return (10 * std::pow(motion.x[1].x() - 1, 2) + motion.v[1].squaredNorm()) / (10 * 1e-4);
    };
    double lowest = 1;
    double highest = 1;
    const double angle = 2 * std::asin(row.z / 2);
    for (int n = 1; n <= 1000; ++n) {
      motion.step(dt);
      lowest = std::min(lowest, energy());
      highest = std::max(highest, energy());
      const double expected =
          std::cos(n * angle) - row.z * row.z / 2 / std::sin(angle) * std::sin(n * angle);
      worst_phase = std::max(worst_phase, std::abs((motion.x[1].x() - 1) / 0.01 - expected));
    }
    for (const double error : {energy() / row.last, lowest / row.lowest, highest / row.highest}) {
      worst_energy = std::max(worst_energy, std::abs(error - 1));
    }
  }
  std::cout << "1000 steps: energy ratios to " << worst_energy
            << ", displacement over amplitude to " << worst_phase << "\n";
  EXPECT_LT(worst_energy, 1e-8);
  EXPECT_LT(worst_phase, 1e-8);
}

TEST(SpringForces, PeriodsAreThoseOfTheReducedMass) {
  const struct {
    double a, b, period;  // reference case 10, stiffness 10 N/m
  } rows[] = {{0, 0.01, 0.198691765315922},
              {0, 1, 1.98691765315922},
              {0.01, 0.01, 0.140496294620815},
              {1, 0.01, 0.197705695877818}};
  for (const auto& row : rows) {
    SpringMotion motion = oscillator(10, row.a, row.b);
    const double z = 2 * std::numbers::pi / 500;
    const double dt = z * row.period / (2 * std::numbers::pi);
    double first = -1;
    double last = -1;
    int crossings = 0;
    double before = 0.01;
    for (int n = 1; n <= 5200; ++n) {
      motion.step(dt);
      const double now = (motion.x[1] - motion.x[0]).norm() - 1;
      if ((now < 0) != (before < 0)) {
        last = (n - now / (now - before)) * dt;
        if (crossings++ == 0) first = last;
      }
      before = now;
    }
    const double period = 2 * (last - first) / (crossings - 1);
    const double expected = row.period * z / (2 * std::asin(z / 2));
    std::cout << "period " << period << " s: " << period / row.period - 1 << " off, of which "
              << expected / row.period - 1 << " is the step's\n";
    EXPECT_NEAR(period / expected, 1, 1e-7);
  }
}

/// Largest ω² of a chain from its matrix.
double largest_square(const std::vector<Spring>& springs, const std::vector<double>& inverse_mass) {
  const auto n = static_cast<Eigen::Index>(inverse_mass.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (const Spring& s : springs) {
    const double a = std::sqrt(inverse_mass[s.a]);
    const double b = std::sqrt(inverse_mass[s.b]);
    matrix(s.a, s.a) += s.stiffness * a * a;
    matrix(s.b, s.b) += s.stiffness * b * b;
    matrix(s.a, s.b) -= s.stiffness * a * b;
    matrix(s.b, s.a) -= s.stiffness * a * b;
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().maxCoeff();
}

TEST(StableStep, IsTheExactOneForALongChainAndNeverMore) {
  for (const int links : {1, 4, 16, 64}) {
    const std::vector<Spring> springs = test::spring_chain(links, 1.0 / links, 10);
    std::vector<double> inverse_mass(links + 1, 100);
    inverse_mass[0] = 0;
    const double exact = 2 / std::sqrt(largest_square(springs, inverse_mass));
    const double bound = stable_step(springs, inverse_mass);
    std::cout << links << " links: step bound over the exact one " << bound / exact << "\n";
    EXPECT_LE(bound, exact * (1 + 1e-12));
    EXPECT_GT(bound, exact * (links < 16 ? 0.9 : 0.99));
  }
  std::mt19937 random(5);
  std::uniform_real_distribution<double> factor(0.1, 10);
  std::vector<Spring> springs = test::spring_chain(40, 1, 1);
  std::vector<double> inverse_mass(41);
  for (Spring& s : springs) s.stiffness = factor(random);
  for (double& w : inverse_mass) w = factor(random);
  const double exact = 2 / std::sqrt(largest_square(springs, inverse_mass));
  const double bound = stable_step(springs, inverse_mass);
  std::cout << "uneven chain: " << bound / exact << "\n";
  EXPECT_LE(bound, exact);
  EXPECT_GT(bound, 0.5 * exact);
}

TEST(StableStep, MotionStaysBelowItAndGrowsAbove) {
  // One mass: the bound is exact, also with damping of the spring and of the air.
  for (const double damping : {0.0, 0.5, 5.0}) {
    for (const double drag : {0.0, 2.0}) {
      const std::vector<Spring> springs = test::spring_chain(1, 1, 10, damping);
      const double bound = stable_step(springs, std::vector{0.0, 2.0}, drag);
      const auto swing = [&](double dt) {
        SpringMotion motion(springs, {{0, 0, 0}, {1.001, 0, 0}}, {0, 0.5}, drag, Vec3::Zero());
        for (int n = 0; n < 2000; ++n) motion.step(dt);
        return std::abs(motion.x[1].x() - 1) / 0.001;
      };
      EXPECT_LT(swing(0.999 * bound), damping + drag > 0 ? 1 : 40);
      EXPECT_GT(swing(1.002 * bound), 40);
    }
  }
}

TEST(StableStep, WithoutSpringsOnlyTheDragLimitsIt) {
  EXPECT_EQ(stable_step({}, std::vector{1.0, 1.0}), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(stable_step({}, std::vector{1.0, 1.0}, 4), 0.5, 1e-15);
}

double hung_length(const test::HangingChain& chain) {
  SpringMotion motion(chain.springs, chain.x, chain.mass, 40, {0, -9.81, 0});
  const double dt = 0.9 * stable_step(chain.springs, motion.inverse_mass, 40);
  for (int n = 0; n < 20000 && (n < 100 || motion.fastest() > 1e-12); ++n) motion.step(dt);
  return -motion.x.back().y() - 1;
}

TEST(SpringForces, AHangingChainStretchesAsTheStripDoes) {
  // Reference case 3: exact with half the mass at the end, 1/N too long with all of it.
  for (const int links : {4, 16, 64}) {
    const double length = hung_length(test::hanging_chain(links, 0.2, 65.4));
    const double heavy = hung_length(test::hanging_chain(links, 0.2, 65.4, 1));
    std::cout << links << " links: relative error of the strip's 15 mm " << length / 0.015 - 1
              << ", with a full end mass " << heavy / 0.015 - 1 << "\n";
    EXPECT_NEAR(length / 0.015, 1, 1e-8);
    EXPECT_NEAR(heavy / 0.015, 1 + 1.0 / links, 1e-8);
  }
}

}  // namespace spring_forces_test
}  // namespace toile
