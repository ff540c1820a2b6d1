// Solids as distance functions: lofts through superelliptic cross-sections, ellipsoids, and smooth
// unions of them. A mannequin is made of them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// A cross-section of a loft, metres. It is a superellipse about (u, v):
/// |u'/half_width|^squareness + |v'/depth|^squareness = 1. The depth is `front` where v' is
/// positive, `back` where it is negative.
struct LoftRow {
  double t = 0;           ///< height along the loft's axis
  double u = 0;           ///< centre
  double v = 0;           ///< centre
  double half_width = 0;  ///< to both sides in u
  double front = 0;       ///< in v
  double back = 0;        ///< in -v
  double squareness = 2;  ///< 2 is an ellipse; usual values are 1.8 to 3
};

/// The frame of a loft: an axis and the directions of its sections, orthonormal.
struct LoftFrame {
  Vec3 origin = Vec3::Zero();
  Vec3 along = Vec3::UnitY();
  Vec3 u = Vec3::UnitX();
  Vec3 v = Vec3::UnitZ();
};

/// A solid through cross-sections, with natural cubic splines between them and rounded ends.
class Loft {
 public:
  /// Three or more rows in rising t. `rounding` is in metres, the length of a rounded end.
  Loft(const LoftFrame& frame, std::vector<LoftRow> rows, double rounding);

  /// About the distance to the surface, metres. Its sign is exact, and near the surface its value
  /// is exact to first order. More than `far` from the solid it is a lower bound above `far`.
  double distance(const Vec3& point) const;

  /// Scales the half width and the depths of row `i`, in [0, rows().size()), by `factor`.
  void scale(int i, double factor);

  static constexpr double far = 0.1;  ///< metres; larger than any blend in use

  const std::vector<LoftRow>& rows() const { return rows_; }
  const LoftFrame& frame() const { return frame_; }
  double rounding() const { return rounding_; }  ///< metres
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
  Vec3 low_;                          // metres: bounds in u, v, t
  Vec3 high_;
  bool elliptic_ = false;  // whether every section is an ellipse
};

/// An ellipsoid with its axes along x, y and z, tilted about x.
struct Ellipsoid {
  Vec3 centre;      ///< metres
  Vec3 radii;       ///< metres
  double tilt = 0;  ///< radians

  /// About the distance to the surface, metres.
  double distance(const Vec3& point) const;
};

/// The distance to the union of two solids at distances `a` and `b`, metres. It is the minimum with
/// a cubic fillet where `a` and `b` differ by less than `blend`. It is twice differentiable.
double smooth_union(double a, double b, double blend);
/// The distance to the intersection of two solids: the maximum with the same fillet.
double smooth_intersection(double a, double b, double blend);

}  // namespace toile
