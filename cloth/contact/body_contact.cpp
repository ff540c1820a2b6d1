#include "cloth/contact/body_contact.h"

#include <algorithm>

#include "cloth/scene/collider.h"
#include "cloth/scene/floor.h"

namespace toile {

void BodyContact::linearize(const Scene& scene, const Vec3& p, double offset,
                            double linearization_radius, double approach_bound, bool firm) {
  const DistanceGrid::Sample sample = obstacle_at(scene, p, offset);
  const double away = sample.distance - offset;
  linearized_at_ = p;
  const double near = std::max(body_activation_distance, approach_bound);
  near_ = away < near;
  firm_ = firm;
  if (!near_) {
    // Beyond the middle between the vertex and the surface, linearize() is due again.
    reach_ = std::max(scene.collider->grid().lower_bound(sample.distance) - offset - 0.5 * near,
                      linearization_radius);
    anchored_ = false;
    return;
  }
  const double length = sample.gradient.norm();
  const Vec3 normal = length > 0 ? Vec3(sample.gradient / length) : Vec3::Zero();
  slope_ = std::min(length, 1.0);
  normal_ = as_vec4(normal);
  level_ = slope_ * normal.dot(p) - away;
  reach_ = slope_ < ridge_slope ? 0 : linearization_radius;
  const double deeper = -away - firm_depth;
  if (firm && deeper > 0) reach_ *= firm_reach_share;
  stiffness_ = body_push_stiffness *
               (slope_ * slope_ + scene.collider->grid().gradient_bound() * std::max(-away, 0.0));
  if (firm && deeper > -linearization_radius) {
    stiffness_ +=
        (firm_push_factor - 1) * body_push_stiffness *
        (slope_ * slope_ + scene.collider->grid().gradient_bound() * std::max(deeper, 0.0));
  }
}

}  // namespace toile
