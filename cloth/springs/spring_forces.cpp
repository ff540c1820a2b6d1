#include "cloth/springs/spring_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "geometry/error.h"
#include "geometry/parallel.h"

namespace toile {

void check_springs(std::span<const Spring> springs, int nodes) {
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Spring& spring = springs[s];
    const bool ends = spring.a >= 0 && spring.a < nodes && spring.b >= 0 && spring.b < nodes &&
                      spring.a != spring.b;
    if (!ends || !(spring.rest > 0)) {
      throw Error("spring " + std::to_string(s),
                  ends ? "its rest length is not above 0" : "its ends are not two nodes",
                  "leave it out");
    }
  }
}

SpringForces::SpringForces(std::span<const Spring> springs, int nodes) {
  check_springs(springs, nodes);
  halves_.assign(static_cast<std::size_t>(nodes), [&](const auto& add) {
    for (const Spring& s : springs) {
      add(s.a, {s.b, s.rest, s.stiffness, s.damping});
      add(s.b, {s.a, s.rest, s.stiffness, s.damping});
    }
  });
}

void SpringForces::add(std::span<const Vec3> x, std::span<const Vec3> v,
                       std::span<Vec3> force) const {
  parallel_for_chunks(halves_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      // Each spring is computed at both ends: cheaper than storing it once and collecting it twice.
      Vec3 sum = Vec3::Zero();
      for (const Half& half : halves_[n]) {
        const Vec3 d = x[half.other] - x[n];
        const double length = d.norm();
        if (length == 0) continue;
        const double inverse = 1 / length;
        const double rate = d.dot(v[half.other] - v[n]) * inverse;
        sum += (half.stiffness * (length - half.rest) + half.damping * rate) * inverse * d;
      }
      force[n] += sum;
    }
  });
}

double stable_step(std::span<const Spring> springs, std::span<const double> inverse_mass,
                   double drag_rate) {
  struct Load {
    double stiffness = 0;
    double damping = 0;
  };
  std::vector<Load> loads(inverse_mass.size());
  for (const Spring& s : springs) {
    for (const int end : {s.a, s.b}) {
      loads[end].stiffness += s.stiffness * inverse_mass[end];
      loads[end].damping += s.damping * inverse_mass[end];
    }
  }
  const auto longest = [](double square, double rate) {
    const double sum = rate + std::sqrt(rate * rate + 4 * square);
    return sum > 0 ? 4 / sum : std::numeric_limits<double>::infinity();
  };
  double step = longest(0, drag_rate);
  for (const Spring& s : springs) {
    step = std::min(step, longest(loads[s.a].stiffness + loads[s.b].stiffness,
                                  loads[s.a].damping + loads[s.b].damping + drag_rate));
  }
  return step;
}

}  // namespace toile
