#include "cloth/contact/body_attraction.h"

#include <algorithm>

#include "cloth/contact/constants.h"
#include "cloth/scene/collider.h"

namespace toile {

Vec3 body_attraction(const Scene& scene, const Vec3& p, double weight) {
  const DistanceGrid::Sample sample = scene.collider->grid().at(p);
  const double strength = std::clamp(sample.distance / full_attraction_distance, 0.0, 1.0);
  return -strength * weight * sample.gradient;
}

}  // namespace toile
