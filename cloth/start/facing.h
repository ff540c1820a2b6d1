// Which direction placed cloth faces.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// The areas of some triangles, added up twice. m², but each area counts double.
struct FacingSum {
  Vec3 vectors = Vec3::Zero();  ///< as vectors along the triangles' normals
  double sizes = 0;             ///< as numbers

  /// Whether the triangles face one direction: the vectors keep more than `share` of the sizes.
  bool flatter_than(double share) const { return vectors.norm() > share * sizes; }
};

/// Adds up the areas of `triangles` with their points at `placed` (metres).
inline FacingSum facing_of(std::span<const Triangle> triangles, const std::vector<Vec3>& placed) {
  FacingSum sum;
  for (const auto& [a, b, c] : triangles) {
    const Vec3 area = (placed[b] - placed[a]).cross(placed[c] - placed[a]);
    sum.vectors += area;
    sum.sizes += area.norm();
  }
  return sum;
}

}  // namespace toile
