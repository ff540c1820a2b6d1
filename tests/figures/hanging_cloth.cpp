#include "tests/figures/hanging_cloth.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "tests/support/spring_motion.h"

namespace toile::figures {
namespace {

constexpr double side = 1;              // m
constexpr double areal_density = 0.15;  // kg/m²

test::SpringGrid cloth(const HangingClothOptions& options) {
  test::SpringGridOptions grid;
  grid.columns = grid.rows = options.nodes_across;
  grid.spacing = side / (options.nodes_across - 1);
  grid.structural = grid.shear = options.stiffness;
  grid.bending = options.bending;
  grid.damping = options.damping;
  return test::spring_grid(grid);
}

/// A node carries the cloth around it: half as much on an edge, a quarter at a corner.
std::vector<double> masses(const test::SpringGrid& grid) {
  std::vector<double> mass;
  for (int r = 0; r < grid.rows; ++r) {
    for (int c = 0; c < grid.columns; ++c) {
      const double across = c == 0 || c == grid.columns - 1 ? 0.5 : 1;
      const double along = r == 0 || r == grid.rows - 1 ? 0.5 : 1;
      mass.push_back(areal_density * side * side * across * along /
                     ((grid.columns - 1) * (grid.rows - 1)));
    }
  }
  mass[grid.node(0, 0)] = 0;
  mass[grid.node(grid.columns - 1, 0)] = 0;
  return mass;
}

test::SpringMotion motion_of(const test::SpringGrid& grid, double drag_rate) {
  return {grid.all(), grid.x, masses(grid), drag_rate, Vec3(0, -9.81, 0)};
}

class Measure {
 public:
  explicit Measure(const test::SpringGrid& grid) : springs_(grid.limited()) {
    const int other = grid.node(grid.columns - 1, 0);
    for (const Spring& s : springs_) {
      at_corner_.push_back(s.a == 0 || s.b == 0 || s.a == other || s.b == other);
    }
  }

  ClothStrain operator()(const std::vector<Vec3>& x) {
    ClothStrain strain;
    strains_.clear();
    for (std::size_t i = 0; i < springs_.size(); ++i) {
      const Spring& s = springs_[i];
      strains_.push_back(std::abs((x[s.b] - x[s.a]).norm() / s.rest - 1));
      // Not std::max, which would pass over what is not a number.
      if (!(strains_.back() <= strain.max)) strain.max = strains_.back();
      if (at_corner_[i]) strain.corners = std::max(strain.corners, strains_.back());
    }
    return strain;
  }

  /// Of the last call.
  double p99() {
    const auto at = strains_.begin() + static_cast<std::ptrdiff_t>(0.99 * (strains_.size() - 1));
    std::nth_element(strains_.begin(), at, strains_.end());
    return *at;
  }

 private:
  std::vector<Spring> springs_;
  std::vector<char> at_corner_;
  std::vector<double> strains_;
};

}  // namespace

double hanging_cloth_step(const HangingClothOptions& options) {
  const test::SpringGrid grid = cloth(options);
  return stable_step(grid.all(), motion_of(grid, 0).inverse_mass, options.drag_rate);
}

HangingCloth hang_cloth(const HangingClothOptions& options) {
  HangingCloth result;
  result.grid = cloth(options);
  test::SpringMotion motion = motion_of(result.grid, options.drag_rate);
  const std::vector<Spring> limited = result.grid.limited();
  StrainControl control(limited, static_cast<int>(result.grid.x.size()));
  Measure measure(result.grid);

  using Clock = std::chrono::steady_clock;
  const int steps = static_cast<int>(std::ceil(options.seconds_max / options.dt));
  long passes = 0;
  double still_since = 0;
  StrainControlOptions adjustment = options.control;
  adjustment.measure_after = false;
  std::vector<Vec3> before;
  for (int n = 0; n < steps && !result.at_rest; ++n) {
    before = motion.x;
    const Clock::time_point start = Clock::now();
    if (options.scheme == StrainScheme::velocity) {
      motion.step(options.dt, [&] {
        const StrainReport report =
            options.jacobi
                ? test::adjust_velocities(*options.jacobi, limited, motion.x, motion.inverse_mass,
                                          options.dt, options.control, motion.v)
                : control.adjust_velocities(motion.x, motion.inverse_mass, options.dt,
                                            options.control, motion.v);
        passes += report.passes;
      });
    } else {
      motion.step(options.dt);
      if (options.scheme == StrainScheme::position) {
        passes += control.adjust_positions(motion.inverse_mass, adjustment, motion.x).passes;
      }
    }
    result.wall_seconds += std::chrono::duration<double>(Clock::now() - start).count();

    result.steps = n + 1;
    result.seconds = result.steps * options.dt;
    result.strain = measure(motion.x);
    if (!(result.strain.max < 100)) {
      result.blew_up = true;
      break;
    }
    result.max_during = std::max(result.max_during, result.strain.max);
    if (result.curve.empty() || result.seconds > result.curve.back().seconds) {
      result.curve.push_back({0.02 * std::ceil(result.seconds / 0.02), 0, 0});
    }
    HangingClothMoment& now = result.curve.back();
    now.corners = std::max(now.corners, result.strain.corners);
    now.max = std::max(now.max, result.strain.max);
    // From the positions: when those are adjusted, the velocities are not what happens.
    result.fastest = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      result.fastest = std::max(result.fastest, (motion.x[i] - before[i]).norm() / options.dt);
    }
    if (result.fastest > options.rest_speed) still_since = result.seconds;
    result.at_rest = result.seconds - still_since > 0.1;
  }
  result.strain.p99 = measure.p99();
  result.passes = static_cast<double>(passes) / result.steps;
  result.x = motion.x;
  return result;
}

}  // namespace toile::figures
