// Nodes on springs under gravity and air drag, stepped by symplectic Euler.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "cloth/springs/spring_forces.h"
#include "tests/support/spring_grid.h"

namespace toile::test {

class SpringMotion {
 public:
  /// Mass 0 holds a node. `drag_rate` in 1/s: each node is slowed by mass·drag_rate·velocity.
  SpringMotion(std::span<const Spring> springs, std::vector<Vec3> start,
               const std::vector<double>& mass, double drag_rate, const Vec3& gravity)
      : x(std::move(start)),
        v(x.size(), Vec3::Zero()),
        forces_(springs, static_cast<int>(x.size())),
        drag_rate_(drag_rate),
        gravity_(gravity),
        force_(x.size()) {
    for (const double m : mass) inverse_mass.push_back(m > 0 ? 1 / m : 0);
  }

  /// `adjust` may change the new velocities before the positions move with them.
  void step(double dt, const std::function<void()>& adjust = {}) {
    std::fill(force_.begin(), force_.end(), Vec3::Zero());
    forces_.add(x, v, force_);
    for (std::size_t n = 0; n < x.size(); ++n) {
      if (inverse_mass[n] == 0) continue;
      v[n] += dt * (inverse_mass[n] * force_[n] + gravity_ - drag_rate_ * v[n]);
    }
    if (adjust) adjust();
    for (std::size_t n = 0; n < x.size(); ++n) x[n] += dt * v[n];
  }

  double fastest() const {
    double square = 0;
    for (const Vec3& speed : v) square = std::max(square, speed.squaredNorm());
    return std::sqrt(square);
  }

  std::vector<Vec3> x;
  std::vector<Vec3> v;
  std::vector<double> inverse_mass;

 private:
  SpringForces forces_;
  double drag_rate_;
  Vec3 gravity_;
  std::vector<Vec3> force_;
};

/// A strip of length 1 m, hung up and cut into elements [reference case 3]. Node 0 is held, and the
/// others hang one below the other. The last one has half the mass of the others.
struct HangingChain {
  std::vector<Spring> springs;
  std::vector<Vec3> x;
  std::vector<double> mass;
};

inline HangingChain hanging_chain(int links, double areal_density, double stretch,
                                  double end_share = 0.5) {
  const double h = 1.0 / links;
  HangingChain chain;
  chain.springs = spring_chain(links, h, stretch / h);
  for (int i = 0; i <= links; ++i) {
    chain.x.push_back({0, -h * i, 0});
    chain.mass.push_back(i == 0 ? 0 : areal_density * h * (i == links ? end_share : 1));
  }
  return chain;
}

}  // namespace toile::test
