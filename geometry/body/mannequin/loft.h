// Solids as distance functions: lofts through superelliptic cross-sections, ellipsoids, and the
// smooth unions that join them. What a mannequin is carved from.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// A cross-section of a loft at height `t` along its axis, metres. The section is a superellipse
/// about (u, v) that reaches `half_width` to both sides in u, `front` ahead and `back` behind in v:
/// |u'/half_width|^squareness + |v'/depth|^squareness = 1. Squareness 2 is an ellipse; usual 1.8-3.
struct LoftRow {
  double t = 0;
  double u = 0;
  double v = 0;
  double half_width = 0;
  double front = 0;
  double back = 0;
  double squareness = 2;
};

/// The frame of a loft: an axis and the directions of its sections, orthonormal.
struct LoftFrame {
  Vec3 origin = Vec3::Zero();
  Vec3 along = Vec3::UnitY();
  Vec3 u = Vec3::UnitX();
  Vec3 v = Vec3::UnitZ();
};

/// A solid through cross-sections, natural cubic splines between them, ends rounded.
class Loft {
 public:
  /// Rows in rising t, three or more. `rounding` is how far from each end row the rounding of the
  /// end reaches, metres.
  Loft(const LoftFrame& frame, std::vector<LoftRow> rows, double rounding);

  /// About the distance to the surface: exact in sign, and to first order near the surface;
  /// farther than `far` from the solid only a lower bound above `far`.
  double distance(const Vec3& point) const;

  /// Scales row `i`'s half width and depths.
  void scale(int i, double factor);

  static constexpr double far = 0.1;  ///< metres; above any blend in use

  const std::vector<LoftRow>& rows() const { return rows_; }
  const LoftFrame& frame() const { return frame_; }
  /// The centre line's point at height t.
  Vec3 centre(double t) const;

 private:
  using Channels = Eigen::Array<double, 6, 1>;  // u, v, half_width, front, back, squareness
  void fit();
  void evaluate(double t, Channels& value, Channels& slope) const;

  LoftFrame frame_;
  std::vector<LoftRow> rows_;
  double rounding_;
  std::vector<Channels> values_;
  std::vector<Channels> curvatures_;  // second derivatives at the rows
  Vec3 low_;                          // bounds in u, v, t
  Vec3 high_;
  bool elliptic_ = false;  // every section is an ellipse
};

/// An ellipsoid with its axes along x, y, z, turned by `tilt` radians about x.
struct Ellipsoid {
  Vec3 centre;
  Vec3 radii;
  double tilt = 0;

  double distance(const Vec3& point) const;
};

/// Union and intersection of two solids whose surfaces flow into each other where their distances
/// differ by less than `blend` metres: min and max with a cubic fillet, twice differentiable.
double smooth_union(double a, double b, double blend);
double smooth_intersection(double a, double b, double blend);

}  // namespace toile
