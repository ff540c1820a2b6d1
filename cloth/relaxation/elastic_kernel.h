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

/// Share of a limit by which it is missed at most.
inline constexpr double limit_tolerance = 0.08;

/// Vertices are the model's nodes, or its material points while seams stand open. Forces take two
/// passes over disjoint ranges that may run side by side: first all of pull(), then all of
/// gather(); a vertex sums what its triangles left in a fixed order, so that bits don't depend on
/// the threads. The same model as stretch_forces() and the model's bend triangles, element for
/// element.
class ElasticKernel {
 public:
  static constexpr std::size_t group = 4;  ///< triangles that are pulled together

  ElasticKernel(const GarmentModel& model, bool of_points);

  std::size_t vertices() const { return pulls_on_.size(); }
  std::size_t groups() const { return groups_.size(); }

  /// First pass, of groups `begin` to `end`: stresses of the triangles, with vertices at `x`.
  void pull(std::size_t begin, std::size_t end, const StretchOptions& options, const Vec4s& x);

  /// Second pass: force (N) on vertices `begin` to `end`. `bending` multiplies the stiffness of all
  /// that bends, `seam_bending` (0 to 1) besides that of what bends across a seam.
  void gather(std::size_t begin, std::size_t end, double bending, double seam_bending,
              const Vec4s& x, Vec4s& force) const;

  /// What holds the yarns to the limits of `options`, per triangle: to begin with, and now.
  void start_multipliers(const std::vector<LimitMultiplier>& yarns);
  std::vector<LimitMultiplier> multipliers() const;
  /// Lets go where yarns of groups `begin` to `end` are within their limits at `x` and holds them
  /// harder where they are not, so that repeated they come to be. Returns how many were beyond by
  /// more than `limit_tolerance`, but are held as much as they can be, and how many others.
  struct LimitViolations {
    int at_max_multiplier = 0;
    int beyond = 0;
  };
  LimitViolations update_multipliers(std::size_t begin, std::size_t end,
                                     const StretchOptions& options, const Vec4s& x);
  /// A bound of the stiffness (N/m) that limits add to a vertex, as of the last hold().
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
  };
  struct alignas(32) LimitGroup {
    Vec4 weft;  // N·m: multiplier times area
    Vec4 warp;
    Vec4 shear;
    Vec4 max;       // N·m: of each
    Vec4 area;      // m²
    Vec4 sum_weft;  // 1/m: of the corners' derivatives
    Vec4 sum_warp;
    Vec4 stiffening_weft;  // N: what limits add to the stiffness, times those
    Vec4 stiffening_warp;
  };
  struct PullEntry {
    int triangle;
    double weft;
    double warp;
  };

  template <bool limited>
  void pull_all(std::size_t begin, std::size_t end, const StretchOptions& options, const Vec4* x);
  void lay_out_triangles(const GarmentModel& model, const std::vector<Triangle>& triangles,
                         std::size_t vertices);
  void lay_out_limits(const GarmentModel& model);

  std::vector<TriangleGroup> groups_;
  std::vector<LimitGroup> limits_;  // empty: no limits
  std::size_t triangles_ = 0;
  Vec4s pulls_;                    // per triangle: by weft, by warp
  Adjacency<PullEntry> pulls_on_;  // per vertex
  BendMatrix bend_;
};

}  // namespace toile
