// Two other readings of the paper's strain control, to compare with: Jacobi sweeps that add up
// corrections, or take each node's mean. On one thread.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "cloth/springs/strain_control.h"

namespace toile::test {

/// How the corrections of one pass add up where springs share a node.
enum class JacobiSum {
  summed,        ///< all corrections added; overshoots, and can grow, where many meet
  node_average,  ///< a node takes the mean of what its springs ask; loses momentum
};

/// StrainControl::adjust_velocities() with another sum. `options.sweep` and `options.tolerance`
/// play no part.
inline StrainReport adjust_velocities(JacobiSum sum_of, std::span<const Spring> springs,
                                      std::span<const Vec3> x, std::span<const double> inverse_mass,
                                      double dt, const StrainControlOptions& options,
                                      std::span<Vec3> v) {
  constexpr double rounding = 1e-12;  // of a rest length; a spring at the limit is not beyond it
  std::vector<Vec3> reached(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) reached[n] = x[n] + dt * v[n];
  std::vector<Vec3> sums(x.size());
  std::vector<int> requests(x.size());
  // Springs beyond the limit and the largest strain; their pulls are added to `sums`.
  const auto survey = [&](double& largest) {
    sums.assign(x.size(), Vec3::Zero());
    requests.assign(x.size(), 0);
    largest = 0;
    int over = 0;
    for (const Spring& s : springs) {
      const Vec3 d = reached[s.b] - reached[s.a];
      const double length = d.norm();
      const double strain = length / s.rest - 1;
      if (strain < 0 && !options.compression) continue;
      largest = std::max(largest, std::abs(strain));
      if (std::abs(strain) <= options.limit + rounding) continue;
      ++over;
      const double mobility = inverse_mass[s.a] + inverse_mass[s.b];
      if (mobility == 0 || length == 0) continue;
      const double target = s.rest * (1 + std::copysign(options.limit, strain));
      const Vec3 pull = (length - target) / (length * mobility) * d;
      sums[s.a] += pull;
      sums[s.b] -= pull;
      ++requests[s.a];
      ++requests[s.b];
    }
    return over;
  };
  StrainReport report;
  for (int pass = 0; pass < options.passes; ++pass) {
    double largest;
    const int over = survey(largest);
    if (pass == 0) {
      report.before = largest;
      report.over = over;
    }
    if (over == 0) break;
    const double share =
        options.mean_of_passes ? double(options.passes - pass) / options.passes : 1.0;
    for (std::size_t n = 0; n < x.size(); ++n) {
      if (requests[n] == 0) continue;
      Vec3 change = inverse_mass[n] * sums[n];
      if (sum_of == JacobiSum::node_average) change /= requests[n];
      reached[n] += change;
      v[n] += share / dt * change;
    }
    ++report.passes;
  }
  if (report.over == 0) {
    report.after = report.before;
  } else if (options.measure_after) {
    for (std::size_t n = 0; n < x.size(); ++n) reached[n] = x[n] + dt * v[n];
    survey(report.after);
  } else {
    report.after = -1;
  }
  return report;
}

}  // namespace toile::test
