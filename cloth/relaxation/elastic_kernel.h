// Forces of stretch, shear and bending on all vertices of a garment, laid out for the processor.
#pragma once

#include <cstddef>
#include <vector>

#include "cloth/model/bending_matrix.h"
#include "cloth/model/garment_model.h"
#include "cloth/model/stretch.h"
#include "geometry/adjacency.h"
#include "geometry/vec4.h"

namespace toile {

/// Forces of stretch, shear and bending. Vertices are the model's material points with `of_points`,
/// as while seams stand open; else they are its nodes.
///
/// Forces take two passes over disjoint ranges that may run in parallel: all of pull(), then all of
/// gather(). A vertex adds up the pulls of its triangles in a fixed order, so bits don't depend on
/// the threads. The pulls on a vertex lie side by side, for gather() waits for memory most.
///
/// Element for element it is the same model as stretch_forces() and the bend triangles of the
/// model.
class ElasticKernel {
 public:
  static constexpr std::size_t group = 4;  ///< triangles that are computed together

  ElasticKernel(const GarmentModel& model, bool of_points);

  std::size_t vertices() const { return corners_.size(); }
  std::size_t groups() const { return groups_.size(); }

  /// First pass: finds the pulls of the triangles of groups `begin` to `end`. `x`: metres, one a
  /// vertex.
  void pull(std::size_t begin, std::size_t end, const StretchOptions& options, const Vec4s& x);

  /// Second pass: sets the forces (N) on vertices `begin` to `end`. `bending` is a factor on the
  /// stiffness of all bending; `seam_bending` (0 to 1) is a further factor across seams.
  void gather(std::size_t begin, std::size_t end, double bending, double seam_bending,
              const Vec4s& x, Vec4s& force) const;

  /// Sets the multipliers that hold the yarns to their limits, one a triangle of the model. Each is
  /// cut to the largest that is allowed.
  void start_multipliers(const std::vector<LimitMultiplier>& yarns);
  /// The multipliers as they are now, one a triangle.
  std::vector<LimitMultiplier> multipliers() const;
  /// Numbers of strains beyond their limits by more than `limit_tolerance`.
  struct LimitViolations {
    int at_max_multiplier = 0;  ///< those that the largest multiplier cannot hold
    int beyond = 0;             ///< the others
  };
  /// Raises the multipliers of groups `begin` to `end` where yarns at `x` (metres) exceed their
  /// limits, and lowers them where yarns are within. Repeated calls bring the yarns within limits.
  LimitViolations update_multipliers(std::size_t begin, std::size_t end,
                                     const StretchOptions& options, const Vec4s& x);
  /// N/m: a bound of the stiffness that limits add to a vertex, as of the last
  /// update_multipliers().
  double stiffening(std::size_t vertex) const;

 private:
  struct alignas(32) TriangleGroup {
    // Per triangle: derivatives of the weft and warp deformation by the second and third corner;
    // the first's is minus their sum.
    Vec4 weft[2];
    Vec4 warp[2];
    Vec4 stretch_weft;  // N·m: stiffness times area
    Vec4 stretch_warp;
    Vec4 shear;
    int corners[3][group];
    int pulls[3][group];  // indices of the pulls on the corners
  };
  struct alignas(32) LimitGroup {
    Vec4 weft;  // N·m: multiplier times area
    Vec4 warp;
    Vec4 shear;
    Vec4 max;       // N·m: the largest of each
    Vec4 area;      // m²
    Vec4 sum_weft;  // 1/m: of the corners' derivatives
    Vec4 sum_warp;
    Vec4 stiffening_weft;  // N: what limits add to the stiffness, times those
    Vec4 stiffening_warp;
  };

  template <bool limited>
  void pull_all(std::size_t begin, std::size_t end, const StretchOptions& options, const Vec4* x);
  void lay_out_triangles(const GarmentModel& model, const std::vector<Triangle>& triangles,
                         std::size_t vertices);
  void lay_out_limits(const GarmentModel& model);
  static double at_corner(const Vec4 (&weights)[2], std::size_t i, int corner);

  std::vector<TriangleGroup> groups_;
  std::vector<LimitGroup> limits_;  // empty: no limits
  std::size_t triangles_ = 0;
  Adjacency<TriangleCorner> corners_;  // per vertex
  std::vector<int> first_pull_;        // per vertex, and one more: in the order of its corners
  Vec4s pulls_;                        // N; those of the triangles that fill up come last
  BendMatrix bend_;
};

}  // namespace toile
