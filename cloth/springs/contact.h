// One contact of the cloth with the subject, and the impulse that answers it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// Inverse mass, 1/kg, of the point with barycentric `weights` of nodes of `inverse_mass` (1/kg, 0
/// of a held node). An impulse P there changes the point's velocity by P times that.
template <std::size_t N>
double inverse_mass_at(const std::array<double, N>& weights,
                       const std::array<double, N>& inverse_mass) {
  double sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += weights[i] * weights[i] * inverse_mass[i];
  return sum;
}

/// A point of the cloth whose approach to the subject is limited. `N` nodes hold it.
template <std::size_t N>
struct Contact {
  std::array<int, N> nodes;
  std::array<double, N> weights;       ///< barycentric, of the point
  std::array<double, N> inverse_mass;  ///< 1/kg, of the nodes
  Vec3 normal;                         ///< outward, of unit length
  double least = 0;                    ///< m/s along the normal, at least, afterwards
  double push = 0;                     ///< N s along the normal so far, never negative
  Vec3 drag = Vec3::Zero();            ///< N s of friction so far, square to the normal

  Vec3 velocity(const std::vector<Vec3>& v) const {
    Vec3 sum = weights[0] * v[nodes[0]];
    for (std::size_t i = 1; i < N; ++i) sum += weights[i] * v[nodes[i]];
    return sum;
  }
  double approach(const std::vector<Vec3>& v) const { return least - normal.dot(velocity(v)); }

  /// Gives the point the velocity along the normal that it needs, and takes back what was pushed
  /// too much. Then it applies as much friction as the push so far allows. Returns the largest
  /// change of the point's velocity, m/s.
  double solve(double friction, std::vector<Vec3>& v) {
    const double at_point = inverse_mass_at(weights, inverse_mass);
    if (at_point <= 0) return 0;
    const double pushed = std::max(0.0, push + approach(v) / at_point);
    double change = std::abs(pushed - push) * at_point;
    if (pushed != push) apply((pushed - push) * normal, v);
    push = pushed;
    if (friction > 0 && (push > 0 || !drag.isZero(0))) {
      const Vec3 now = velocity(v);
      const Vec3 along = now - normal.dot(now) * normal;
      Vec3 dragged = drag - along / at_point;
      const double size = dragged.norm();
      if (size > friction * push) dragged *= friction * push / size;
      change = std::max(change, (dragged - drag).norm() * at_point);
      apply(dragged - drag, v);
      drag = dragged;
    }
    return change;
  }

 private:
  void apply(const Vec3& impulse, std::vector<Vec3>& v) const {
    for (std::size_t i = 0; i < N; ++i) v[nodes[i]] += weights[i] * inverse_mass[i] * impulse;
  }
};

}  // namespace toile
