#include "cloth/springs/strain_control.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "cloth/springs/chunks.h"
#include "cloth/springs/spring_forces.h"

namespace toile {
namespace {

/// Share of the rest length by which a spring must be beyond the limit to count. Without it,
/// rounding would decide whether springs brought to the limit take part again.
constexpr double activity = 1e-12;

/// Bounds on (length/rest)².
struct Bounds {
  double low;
  double high;
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
    : first_(static_cast<std::size_t>(nodes) + 1),
      ends_(2 * springs.size()),
      reached_(nodes, Vec3::Zero()),
      pulls_(springs.size(), Vec3::Zero()),
      over_(springs.size()),
      touched_(nodes),
      requests_(nodes),
      seen_(std::max(chunks_of(static_cast<int>(springs.size())), 1)) {
  check_springs(springs, nodes);
  springs_.reserve(springs.size());
  for (const Spring& s : springs) {
    springs_.push_back({s.a, s.b, s.rest, 1 / (s.rest * s.rest)});
    ++first_[s.a + 1];
    ++first_[s.b + 1];
  }
  for (int n = 0; n < nodes; ++n) first_[n + 1] += first_[n];
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t s = 0; s < springs.size(); ++s) {
    ends_[next[springs[s].a]++] = static_cast<int>(2 * s);
    ends_[next[springs[s].b]++] = static_cast<int>(2 * s + 1);
  }
}

StrainReport StrainControl::adjust_velocities(std::span<const Vec3> x,
                                              std::span<const double> inverse_mass, double dt,
                                              const StrainControlOptions& options,
                                              std::span<Vec3> v) {
  const auto predict = [&] {
    in_spring_chunks(static_cast<int>(x.size()), [&](int, int first, int last) {
      for (int n = first; n < last; ++n) reached_[n] = x[n] + dt * v[n];
    });
  };
  predict();
  StrainReport report = adjust(inverse_mass, options, 1 / dt, v);
  if (report.over > 0 && options.measure_after) {
    predict();
    report.after = look(options).largest;
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
    report.after = look(options).largest;
  }
  return report;
}

/// Adjusts reached_, and `out` by `scale` times the same.
StrainReport StrainControl::adjust(std::span<const double> inverse_mass,
                                   const StrainControlOptions& options, double scale,
                                   std::span<Vec3> out) {
  StrainReport report;
  Seen seen;
  for (int pass = 0; pass < options.passes; ++pass) {
    const bool in_order = options.sweep == StrainSweep::in_order;
    seen = in_order ? look(options) : request(inverse_mass, options);
    if (pass == 0) {
      report.before = seen.largest;
      report.over = seen.over;
    }
    if (seen.over == 0) break;
    if (in_order && pass > 0 && seen.largest - options.limit < options.tolerance) break;
    // What one pass changes is in what all later ones reach: the mean needs no memory of them.
    const double share =
        options.mean_of_passes ? double(options.passes - pass) / options.passes : 1.0;
    if (in_order) {
      sweep_in_order(inverse_mass, options, share * scale, out);
    } else {
      if (options.sweep != StrainSweep::summed) count_requests();
      apply(inverse_mass, options.sweep, share * scale, out);
    }
    ++report.passes;
  }
  report.after = report.over == 0 ? report.before : -1;
  return report;
}

StrainControl::Seen StrainControl::look(const StrainControlOptions& options) {
  const Bounds bound = bounds(options);
  in_spring_chunks(static_cast<int>(springs_.size()), [&](int chunk, int first, int last) {
    double lowest = 1;
    double highest = 1;
    int over = 0;
    for (int s = first; s < last; ++s) {
      const Limited& spring = springs_[s];
      const double square =
          (reached_[spring.b] - reached_[spring.a]).squaredNorm() * spring.inverse_square;
      lowest = std::min(lowest, square);
      highest = std::max(highest, square);
      over += square > bound.high || square < bound.low;
    }
    seen_[chunk] = {largest_strain(lowest, highest, options.compression), over};
  });
  return sum_of_chunks();
}

/// look() that also writes down what the springs beyond the limit ask for.
StrainControl::Seen StrainControl::request(std::span<const double> inverse_mass,
                                           const StrainControlOptions& options) {
  const Bounds bound = bounds(options);
  in_spring_chunks(static_cast<int>(springs_.size()), [&](int chunk, int first, int last) {
    double lowest = 1;
    double highest = 1;
    int over = 0;
    for (int s = first; s < last; ++s) {
      const Limited& spring = springs_[s];
      const Vec3 d = reached_[spring.b] - reached_[spring.a];
      const double square = d.squaredNorm() * spring.inverse_square;
      lowest = std::min(lowest, square);
      highest = std::max(highest, square);
      over_[s] = 0;
      if (!(square > bound.high || square < bound.low)) continue;
      ++over;
      const double sum = inverse_mass[spring.a] + inverse_mass[spring.b];
      const double length = d.norm();
      if (sum == 0 || length == 0) continue;
      over_[s] = 1;
      pulls_[s] = (length - target(options, square, spring.rest)) / (length * sum) * d;
      for (const int end : {spring.a, spring.b}) {
        std::atomic_ref(touched_[end]).store(1, std::memory_order_relaxed);
      }
    }
    seen_[chunk] = {largest_strain(lowest, highest, options.compression), over};
  });
  return sum_of_chunks();
}

StrainControl::Seen StrainControl::sum_of_chunks() const {
  Seen sum;
  const int chunks = chunks_of(static_cast<int>(springs_.size()));
  for (int c = 0; c < chunks; ++c) {
    sum.largest = std::max(sum.largest, seen_[c].largest);
    sum.over += seen_[c].over;
  }
  return sum;
}

void StrainControl::count_requests() {
  in_spring_chunks(static_cast<int>(requests_.size()), [&](int, int first, int last) {
    for (int n = first; n < last; ++n) {
      if (!touched_[n]) continue;
      int count = 0;
      for (int e = first_[n]; e < first_[n + 1]; ++e) count += over_[ends_[e] / 2];
      requests_[n] = count;
    }
  });
}

void StrainControl::apply(std::span<const double> inverse_mass, StrainSweep sweep, double scale,
                          std::span<Vec3> out) {
  in_spring_chunks(static_cast<int>(touched_.size()), [&](int, int first, int last) {
    for (int n = first; n < last; ++n) {
      if (!touched_[n]) continue;
      touched_[n] = 0;
      if (inverse_mass[n] == 0) continue;
      Vec3 sum = Vec3::Zero();
      for (int e = first_[n]; e < first_[n + 1]; ++e) {
        const int s = ends_[e] / 2;
        if (!over_[s]) continue;
        const bool at_b = ends_[e] % 2 == 1;
        double factor = at_b ? -1 : 1;
        if (sweep == StrainSweep::shared) {
          // A held end takes all that is asked of it: only ends that move can be overcharged.
          const int other = at_b ? springs_[s].a : springs_[s].b;
          factor /=
              inverse_mass[other] == 0 ? requests_[n] : std::max(requests_[n], requests_[other]);
        }
        sum += factor * pulls_[s];
      }
      if (sweep == StrainSweep::node_average) sum /= requests_[n];
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
    if (!(square > bound.high || square < bound.low)) continue;
    const double sum = inverse_mass[spring.a] + inverse_mass[spring.b];
    const double length = d.norm();
    if (sum == 0 || length == 0) continue;
    const Vec3 pull = (length - target(options, square, spring.rest)) / (length * sum) * d;
    const Vec3 a = inverse_mass[spring.a] * pull;
    const Vec3 b = inverse_mass[spring.b] * pull;
    reached_[spring.a] += a;
    reached_[spring.b] -= b;
    out[spring.a] += scale * a;
    out[spring.b] -= scale * b;
  }
}

}  // namespace toile
