#include "cloth/springs/strain_control.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "cloth/springs/spring_forces.h"
#include "geometry/parallel.h"

namespace toile {
namespace {

/// Share of the rest length by which a spring must be beyond the limit to count. Without it,
/// rounding would decide whether springs brought to the limit take part again.
constexpr double activity = 1e-12;

/// Bounds on (length/rest)².
struct Bounds {
  double low;
  double high;

  bool exceeded_by(double square) const { return square > high || square < low; }
};

Bounds bounds(const StrainControlOptions& options) {
  const double high = 1 + options.limit + activity;
  const double low = options.compression ? std::max(1 - options.limit - activity, 0.0) : 0;
  return {low * low, high * high};
}

double target(const StrainControlOptions& options, double square, double rest) {
  return rest * (square > 1 ? 1 + options.limit : 1 - options.limit);
}

double largest_strain(double lowest_square, double highest_square, bool compression) {
  const double elongation = std::sqrt(highest_square) - 1;
  const double shortening = compression ? 1 - std::sqrt(lowest_square) : 0;
  return std::max({elongation, shortening, 0.0});
}

}  // namespace

StrainControlOptions provot_options() {
  StrainControlOptions options;
  options.limit = 0.1;
  options.compression = false;
  options.passes = 1;
  options.sweep = StrainSweep::in_order;
  options.mean_of_passes = false;
  return options;
}

StrainControl::StrainControl(std::span<const Spring> springs, int nodes)
    : reached_(nodes, Vec3::Zero()),
      pulls_(springs.size(), Vec3::Zero()),
      pulling_(springs.size()),
      touched_(nodes),
      requests_(nodes),
      surveys_(chunks_of(springs.size(), vertex_chunk)) {
  check_springs(springs, nodes);
  springs_.reserve(springs.size());
  for (const Spring& s : springs) {
    springs_.push_back({s.a, s.b, s.rest, 1 / (s.rest * s.rest)});
  }
  ends_.assign(static_cast<std::size_t>(nodes), [&](const auto& add) {
    for (std::size_t s = 0; s < springs.size(); ++s) {
      add(springs[s].a, {static_cast<int>(s), false});
      add(springs[s].b, {static_cast<int>(s), true});
    }
  });
}

StrainReport StrainControl::adjust_velocities(std::span<const Vec3> x,
                                              std::span<const double> inverse_mass, double dt,
                                              const StrainControlOptions& options,
                                              std::span<Vec3> v) {
  const auto predict = [&] {
    parallel_for_chunks(x.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) reached_[n] = x[n] + dt * v[n];
    });
  };
  predict();
  StrainReport report = adjust(inverse_mass, options, 1 / dt, v);
  if (report.over > 0 && options.measure_after) {
    predict();
    report.after = measure(options).largest;
  }
  return report;
}

StrainReport StrainControl::adjust_positions(std::span<const double> inverse_mass,
                                             const StrainControlOptions& options,
                                             std::span<Vec3> x) {
  std::copy(x.begin(), x.end(), reached_.begin());
  StrainReport report = adjust(inverse_mass, options, 1, x);
  if (report.over > 0 && options.measure_after) {
    std::copy(x.begin(), x.end(), reached_.begin());
    report.after = measure(options).largest;
  }
  return report;
}

/// Adjusts reached_, and `out` by `scale` times the same.
StrainReport StrainControl::adjust(std::span<const double> inverse_mass,
                                   const StrainControlOptions& options, double scale,
                                   std::span<Vec3> out) {
  StrainReport report;
  for (int pass = 0; pass < options.passes; ++pass) {
    const bool in_order = options.sweep == StrainSweep::in_order;
    const Survey survey = in_order ? measure(options) : find_pulls(inverse_mass, options);
    if (pass == 0) {
      report.before = survey.largest;
      report.over = survey.over;
    }
    if (survey.over == 0) break;
    if (in_order && pass > 0 && survey.largest - options.limit < options.tolerance) break;
    // A pass's change is part of the state after each later pass. So the mean needs no copies of
    // these states.
    const double share =
        options.mean_of_passes ? double(options.passes - pass) / options.passes : 1.0;
    if (in_order) {
      sweep_in_order(inverse_mass, options, share * scale, out);
    } else {
      count_requests();
      apply_pulls(inverse_mass, share * scale, out);
    }
    ++report.passes;
  }
  report.after = report.over == 0 ? report.before : -1;
  return report;
}

/// Calls visit(spring index, vector from end a to end b, squared length / rest) for each spring
/// beyond the limit, in parallel.
template <typename Visit>
StrainControl::Survey StrainControl::survey(const StrainControlOptions& options,
                                            const Visit& visit) {
  const Bounds bound = bounds(options);
  parallel_for_chunks(springs_.size(), [&](std::size_t begin, std::size_t end) {
    double lowest = 1;
    double highest = 1;
    int over = 0;
    for (std::size_t s = begin; s < end; ++s) {
      const Limited& spring = springs_[s];
      const Vec3 d = reached_[spring.b] - reached_[spring.a];
      const double square = d.squaredNorm() * spring.inverse_square;
      lowest = std::min(lowest, square);
      highest = std::max(highest, square);
      if (!bound.exceeded_by(square)) continue;
      ++over;
      visit(s, d, square);
    }
    surveys_[begin / vertex_chunk] = {largest_strain(lowest, highest, options.compression), over};
  });
  Survey all;
  for (const Survey& of_chunk : surveys_) {
    all.largest = std::max(all.largest, of_chunk.largest);
    all.over += of_chunk.over;
  }
  return all;
}

StrainControl::Survey StrainControl::measure(const StrainControlOptions& options) {
  return survey(options, [](std::size_t, const Vec3&, double) {});
}

/// Pull on end a toward end b that brings a spring to the limit, kg·m. `d` is the vector from a to
/// b, `square` its squared length in rest lengths. Nothing where neither end can move, or the two
/// are in one place.
std::optional<Vec3> StrainControl::pull_of(const Limited& spring, const Vec3& d, double square,
                                           std::span<const double> inverse_mass,
                                           const StrainControlOptions& options) {
  const double sum = inverse_mass[spring.a] + inverse_mass[spring.b];
  const double length = d.norm();
  if (sum == 0 || length == 0) return std::nullopt;
  return (length - target(options, square, spring.rest)) / (length * sum) * d;
}

/// Stores the pulls of the springs beyond the limit, and marks the nodes at their ends.
StrainControl::Survey StrainControl::find_pulls(std::span<const double> inverse_mass,
                                                const StrainControlOptions& options) {
  std::fill(pulling_.begin(), pulling_.end(), 0);
  return survey(options, [&](std::size_t s, const Vec3& d, double square) {
    const Limited& spring = springs_[s];
    const std::optional<Vec3> pull = pull_of(spring, d, square, inverse_mass, options);
    if (!pull) return;
    pulling_[s] = 1;
    pulls_[s] = *pull;
    for (const int end : {spring.a, spring.b}) {
      std::atomic_ref(touched_[end]).store(1, std::memory_order_relaxed);
    }
  });
}

void StrainControl::count_requests() {
  parallel_for_chunks(requests_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      if (!touched_[n]) continue;
      int count = 0;
      for (const End& e : ends_[n]) count += pulling_[e.spring];
      requests_[n] = count;
    }
  });
}

void StrainControl::apply_pulls(std::span<const double> inverse_mass, double scale,
                                std::span<Vec3> out) {
  parallel_for_chunks(touched_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      if (!touched_[n]) continue;
      touched_[n] = 0;
      if (inverse_mass[n] == 0) continue;
      Vec3 sum = Vec3::Zero();
      for (const End& e : ends_[n]) {
        if (!pulling_[e.spring]) continue;
        // A held end does not move. So only the requests at ends that move divide the pull.
        const int other = e.is_b ? springs_[e.spring].a : springs_[e.spring].b;
        const int divisor =
            inverse_mass[other] == 0 ? requests_[n] : std::max(requests_[n], requests_[other]);
        sum += (e.is_b ? -1.0 : 1.0) / divisor * pulls_[e.spring];
      }
      const Vec3 change = inverse_mass[n] * sum;
      reached_[n] += change;
      out[n] += scale * change;
    }
  });
}

void StrainControl::sweep_in_order(std::span<const double> inverse_mass,
                                   const StrainControlOptions& options, double scale,
                                   std::span<Vec3> out) {
  const Bounds bound = bounds(options);
  for (const Limited& spring : springs_) {
    const Vec3 d = reached_[spring.b] - reached_[spring.a];
    const double square = d.squaredNorm() * spring.inverse_square;
    if (!bound.exceeded_by(square)) continue;
    const std::optional<Vec3> pull = pull_of(spring, d, square, inverse_mass, options);
    if (!pull) continue;
    const Vec3 a = inverse_mass[spring.a] * *pull;
    const Vec3 b = inverse_mass[spring.b] * *pull;
    reached_[spring.a] += a;
    reached_[spring.b] -= b;
    out[spring.a] += scale * a;
    out[spring.b] -= scale * b;
  }
}

}  // namespace toile
