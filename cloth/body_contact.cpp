#include "cloth/body_contact.h"

#include <algorithm>

#include "geometry/distance_grid.h"

namespace toile {

namespace {

/// N/m. A node of 1 cm² that 100 Pa press to the skin sinks in by 0.01 mm.
constexpr double push_stiffness = 1000;
/// N/m, of the spring that holds a sticking vertex to its anchor on the skin.
constexpr double anchor_stiffness = 200;
/// Metres from the skin at which the pull toward it reaches its full strength.
constexpr double full_pull = 0.05;

}  // namespace

VertexForce BodyContact::force(const Scene& scene, const Vec3& p, double offset, double friction) {
  if (clearance_ > 0) return {};
  const DistanceGrid::Sample sample = scene.body->at(p);
  const double depth = offset - sample.distance;
  if (depth <= 0) {
    clearance_ = scene.body->at_least(sample.distance) - offset;
    anchored_ = false;
    return {};
  }
  clearance_ = 0;
  const double length = sample.gradient.norm();
  if (length < 1e-6) return {};  // the middle of the body, where no way out is nearer
  const Vec3 normal = sample.gradient / length;
  VertexForce result{push_stiffness * depth * normal, push_stiffness};
  if (friction <= 0) return result;
  if (!anchored_) {
    anchored_ = true;
    anchor_ = p;
  }
  const Vec3 away = p - anchor_;
  Vec3 slip = away - normal.dot(away) * normal;
  const double most = friction * push_stiffness * depth / anchor_stiffness;
  if (slip.norm() > most) {
    slip *= most / slip.norm();
    anchor_ = p - slip;
  }
  result.force -= anchor_stiffness * slip;
  result.stiffness += anchor_stiffness;
  return result;
}

Vec3 pull_to_body(const Scene& scene, const Vec3& p, double weight) {
  const DistanceGrid::Sample sample = scene.body->at(p);
  const double strength = std::clamp(sample.distance / full_pull, 0.0, 1.0);
  return -strength * weight * sample.gradient;
}

}  // namespace toile
