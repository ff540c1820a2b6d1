#include "cloth/relaxation/body_contact.h"

#include "geometry/distance_grid.h"

namespace toile {

namespace {

/// Metres off the surface from which the body is taken for a plane.
constexpr double near_surface = 2e-4;

}  // namespace

void BodyContact::look(const Scene& scene, const Vec3& p, double offset, double plane_reach) {
  const DistanceGrid::Sample sample = scene.body->at(p);
  const double away = sample.distance - offset;
  looked_at_ = p;
  near_ = away < near_surface;
  if (!near_) {
    // On the far side of the middle between here and there, the plane is asked for again.
    reach_ =
        std::max(scene.body->at_least(sample.distance) - offset - 0.5 * near_surface, plane_reach);
    anchored_ = false;
    return;
  }
  reach_ = plane_reach;
  const double length = sample.gradient.norm();
  // In the middle of the body no way out is nearer.
  near_ = length > 1e-6;
  if (!near_) return;
  const Vec3 normal = sample.gradient / length;
  normal_ = as_vec4(normal);
  level_ = normal.dot(p) - away;
}

}  // namespace toile
