// Stiffness of the cloth at its nodes by direction: large in its plane, small along its normal.
#pragma once

#include <array>
#include <vector>

#include "cloth/model/garment_model.h"
#include "geometry/adjacency.h"
#include "geometry/columns.h"
#include "geometry/vec4.h"

namespace toile {

/// N/m: xx, xy, xz, yy, yz, zz of a symmetric matrix.
using StiffnessBlock = std::array<double, 6>;

/// Solves (`stiffness` + `more` · I) displacement = `force` (N) for the displacement (metres).
/// `more` is in N/m. Returns zero where the matrix is singular.
[[gnu::always_inline]] inline Vec4 solve_block(const StiffnessBlock& stiffness, double more,
                                               const Vec4& force) {
  const double xx = stiffness[0] + more;
  const double yy = stiffness[3] + more;
  const double zz = stiffness[5] + more;
  const auto& [xx_, xy, xz, yy_, yz, zz_] = stiffness;
  const double cofactor_xx = yy * zz - yz * yz;
  const double cofactor_xy = xz * yz - xy * zz;
  const double cofactor_xz = xy * yz - xz * yy;
  const double determinant = xx * cofactor_xx + xy * cofactor_xy + xz * cofactor_xz;
  if (!(determinant > 0)) return Vec4{};
  const double cofactor_yz = xy * xz - xx * yz;
  const Vec4 displacement = force[0] * Vec4{cofactor_xx, cofactor_xy, cofactor_xz, 0} +
                            force[1] * Vec4{cofactor_xy, xx * zz - xz * xz, cofactor_yz, 0} +
                            force[2] * Vec4{cofactor_xz, cofactor_yz, xx * yy - xy * xy, 0};
  return displacement / determinant;
}

/// Does the same for four nodes at a time, and gives the same bits.
[[gnu::always_inline]] inline Columns solve_blocks(const std::vector<StiffnessBlock>& blocks,
                                                   const Places& at, const Vec4& more,
                                                   const Columns& force) {
  const auto entry = [&](std::size_t k) {
    return Vec4{blocks[at[0]][k], blocks[at[1]][k], blocks[at[2]][k], blocks[at[3]][k]};
  };
  const Vec4 xx = entry(0) + more;
  const Vec4 xy = entry(1);
  const Vec4 xz = entry(2);
  const Vec4 yy = entry(3) + more;
  const Vec4 yz = entry(4);
  const Vec4 zz = entry(5) + more;
  const Vec4 cofactor_xx = yy * zz - yz * yz;
  const Vec4 cofactor_xy = xz * yz - xy * zz;
  const Vec4 cofactor_xz = xy * yz - xz * yy;
  const Vec4 determinant = xx * cofactor_xx + xy * cofactor_xy + xz * cofactor_xz;
  const Vec4 cofactor_yz = xy * xz - xx * yz;
  const Columns scaled = {
      force.x * cofactor_xx + force.y * cofactor_xy + force.z * cofactor_xz,
      force.x * cofactor_xy + force.y * (xx * zz - xz * xz) + force.z * cofactor_yz,
      force.x * cofactor_xz + force.y * cofactor_yz + force.z * (xx * yy - xy * xy)};
  const Vec4 zero = {0, 0, 0, 0};
  return {determinant > 0.0 ? scaled.x / determinant : zero,
          determinant > 0.0 ? scaled.y / determinant : zero,
          determinant > 0.0 ? scaled.z / determinant : zero};
}

/// A bound of the stiffness of stretch, shear and elastics at each node, as a matrix. Along a yarn
/// it is the row sum of the stiffness; across a yarn it is what the tension adds. So a step along
/// the normal of the cloth may be many times as long as one in its plane.
class BlockStiffness {
 public:
  explicit BlockStiffness(const GarmentModel& model);

  /// Finds the blocks of all nodes at `x` (metres, one a node). Returns how far they changed: the
  /// mean over the nodes of the largest change along any direction, in units of the isotropic
  /// bound. That is the sine of the angle by which yarns turned. The first time it is 1. Linear in
  /// the triangles; same bits for any number of threads.
  double update(const Vec4s& x);
  /// Whether there was an update(). Before it, the blocks are zero.
  bool known() const { return known_; }
  /// N/m, per node.
  const std::vector<StiffnessBlock>& of_nodes() const { return of_nodes_; }

 private:
  /// Updates nodes `begin` to `end`, at most vertex_chunk; returns the sum of their changes.
  double update(std::size_t begin, std::size_t end, const Vec4s& x);

  const GarmentModel& model_;
  Adjacency<TriangleCorner> corners_;  // per node
  std::vector<double> elastic_;        // N/m, per node; empty: no elastics
  std::vector<StiffnessBlock> of_nodes_;
  std::vector<double> partial_;
  bool known_ = false;
};

}  // namespace toile
