#include "cloth/springs/sewing_force.h"

#include <algorithm>

namespace toile {

namespace {

/// Relative velocity after a step of the law above delta.
Vec3 approach(const SewingForce& f, double dt, const Vec3& apart, const Vec3& velocity) {
  const double distance = apart.norm();
  const Vec3 axis = apart / distance;
  const double along = velocity.dot(axis);
  const Vec3 across = velocity - along * axis;
  const double T = f.unit_time;
  const double correction = f.lambda_f + f.damp_normal;
  const double mass = 1 + f.atten_normal;
  const double damping = (f.tau + correction) / T;
  const double stiffness = (2 * f.epsilon + correction) / (T * T);
  const double mass_across = 1 + f.atten_tangent;
  const double damping_across = (f.tau + f.damp_tangent) / T;
  const double new_along =
      (mass * along - dt * stiffness * distance) / (mass + dt * damping + dt * dt * stiffness);
  const double limited = std::max(new_along, std::min(along, -f.fastest));
  return limited * axis + mass_across / (mass_across + dt * damping_across) * across;
}

/// Relative velocity after a step of the constant force.
Vec3 land(const SewingForce& f, double acceleration, double dt, const Vec3& apart,
          const Vec3& velocity) {
  const double damping = (f.tau + f.lambda_f + f.damp_normal) / f.unit_time;
  const Vec3 ahead = apart + dt / (1 + dt * damping) * velocity;
  const double pulled = acceleration * dt * dt;
  // Also when they would pass each other within the step: the merge must not be jumped over.
  const Vec3 way = ahead - apart;
  const double nearest =
      std::clamp(-apart.dot(way) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
  if ((apart + nearest * way).norm() <= pulled) return -apart / dt;
  const double distance = ahead.norm();
  return ((1 - pulled / distance) * ahead - apart) / dt;
}

}  // namespace

void sew_step(const SewingForce& f, double dt, SewnPair& pair) {
  const Vec3 apart = pair.x_b - pair.x_a;
  const Vec3 velocity = pair.v_b - pair.v_a;
  const double total = pair.mass_a + pair.mass_b;
  const double reduced = pair.mass_a * pair.mass_b / total;
  const double most = f.most / reduced;
  const double distance = apart.norm();
  Vec3 change;
  if (distance > f.delta) {
    change = approach(f, dt, apart, velocity) - velocity;
    const double size = change.norm();
    if (size > most * dt) change *= most * dt / size;
  } else {
    const double acceleration = 2 * f.c * f.unit_length / (f.unit_time * f.unit_time);
    change = land(f, std::min(acceleration, most), dt, apart, velocity) - velocity;
  }
  // Air holds the pair as a whole back, too.
  const Vec3 mean = (pair.mass_a * pair.v_a + pair.mass_b * pair.v_b) / total;
  const Vec3 slowed = mean / (1 + dt * f.tau / f.unit_time);
  const Vec3 relative = velocity + change;
  pair.v_a = slowed - pair.mass_b / total * relative;
  pair.v_b = slowed + pair.mass_a / total * relative;
}

}  // namespace toile
