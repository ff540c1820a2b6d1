#include "cloth/scene/floor.h"

#include <algorithm>
#include <cmath>

#include "cloth/scene/collider.h"

namespace toile {

std::optional<double> floor_below(const TriangleMesh& body, const Vec3& gravity) {
  if (-gravity.y() <= std::hypot(gravity.x(), gravity.z())) return std::nullopt;
  double lowest = 0;
  for (const Vec3& p : body.points) lowest = std::min(lowest, p.y());
  return lowest;
}

DistanceGrid::Sample obstacle_at(const Scene& scene, const Vec3& p, double offset) {
  const DistanceGrid::Sample body = scene.collider->grid().at(p);
  if (!scene.floor) return body;
  double above = p.y() - *scene.floor;
  if (body.gradient.y() < 0) above = std::max(above, 2 * offset - body.distance);
  if (above >= body.distance) return body;
  return {above, Vec3::UnitY()};
}

}  // namespace toile
