// The way of a surface from one shape to another one with the same triangles.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>

#include "geometry/types.h"

namespace toile {

/// Shapes between two shapes of a surface, such as a body in two poses. Each triangle turns and
/// stretches evenly from one to the other [Alexa et al. 2000]. The surface is the one whose edges
/// are nearest to those of the triangles [Xu et al. 2005]. So limbs swing about their joints, and
/// keep their lengths. No skeleton is needed.
///
/// A triangle's turn is told from its two shapes only up to whole turns. It is taken nearest to its
/// neighbour's, from the triangle that turns least outward. So limbs may turn by more than 180
/// degrees.
class SurfaceMorph {
 public:
  /// Both surfaces are in metres. Throws Error, with the place `name`, when their triangles differ.
  /// It costs a sparse factorisation, about O(n^1.5): 0.4 s for 24k points.
  SurfaceMorph(const TriangleMesh& from, const TriangleMesh& to, const std::string& name);
  ~SurfaceMorph();
  SurfaceMorph(SurfaceMorph&&) noexcept;

  /// The surface at `share` of the way, in [0, 1]. At 0 and 1 it has the bits of the two shapes.
  /// About O(n log n).
  TriangleMesh at(double share) const;

  /// The turn of a triangle since `from`, at `share` of the way.
  Eigen::Quaterniond turn(int triangle, double share) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace toile
