#include "cloth/scene/collider.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace toile {

Collider::Collider(const TriangleMesh& body, DistanceCache known,
                   const DistanceGridOptions& options)
    : surfaces_{SurfaceDistance(body)}, surface_(body), grid_(surfaces_.front(), options) {
  if (!known.empty()) grid_.restore(std::move(known));
}

void Collider::add_layer(const TriangleMesh& garment) {
  surfaces_.emplace_back(garment);
  append(surface_, garment);
  append(cloth_, garment);
  grid_.add(surfaces_.back());
}

double Collider::distance(const Vec3& point) const {
  double smallest = std::numeric_limits<double>::max();
  for (const SurfaceDistance& surface : surfaces_) {
    smallest = std::min(smallest, surface.closest_point(point).distance);
  }
  return smallest;
}

}  // namespace toile
