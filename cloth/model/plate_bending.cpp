#include "cloth/model/plate_bending.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "cloth/model/constants.h"

namespace toile {

double bending_along(const Fabric& fabric, double angle) {
  const double weft = std::pow(std::cos(angle), 2);
  return std::pow(
      weft * std::sqrt(fabric.bending_weft) + (1 - weft) * std::sqrt(fabric.bending_warp), 2);
}

Vec3 jump_by_curvature(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& away,
                       double grain) {
  const double length = (b - a).norm();
  const Vec2 along = (b - a) / length;
  const double place = along.dot(c - a);
  const double height = along.x() * (c - a).y() - along.y() * (c - a).x();
  // Jumps for unit curvature square to the edge, unit curvature along it, and unit twist.
  const double normal = 0.5 * (height + away.y());
  const double edge =
      0.5 * (place * (place - length) / height + away.x() * (away.x() - length) / away.y());
  const double twist = place - away.x();
  // The components of the edge's direction along weft and warp.
  const double u = std::cos(grain) * along.x() + std::sin(grain) * along.y();
  const double v = std::cos(grain) * along.y() - std::sin(grain) * along.x();
  return {normal * v * v + edge * u * u - twist * u * v,
          normal * u * u + edge * v * v + twist * u * v,
          2 * (edge - normal) * u * v + twist * (u * u - v * v)};
}

Eigen::Matrix3d plate_stiffness(const Fabric& fabric, double area, const std::array<Vec3, 3>& jumps,
                                const std::array<bool, 3>& there) {
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  const double largest = std::max(fabric.bending_weft, fabric.bending_warp);
  const int count = static_cast<int>(std::count(there.begin(), there.end(), true));
  if (!(largest > 0) || count == 0) return stiffness;
  const double weft = std::max(fabric.bending_weft, min_rigidity_ratio * largest);
  const double warp = std::max(fabric.bending_warp, min_rigidity_ratio * largest);
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
  Matrix rows(count, 3);
  std::array<int, 3> edge{};
  for (int i = 0, row = 0; i < 3; ++i) {
    if (!there[i]) continue;
    edge[row] = i;
    rows.row(row++) = jumps[i];
  }
  const Vec3 compliance(1 / weft, 1 / warp, 0.5 / std::sqrt(weft * warp));
  Matrix matrix = rows * compliance.asDiagonal() * rows.transpose();
  rows.rowwise().normalize();
  const double distinct =
      Eigen::SelfAdjointEigenSolver<Matrix>(rows * rows.transpose(), Eigen::EigenvaluesOnly)
          .eigenvalues()
          .minCoeff();
  matrix.diagonal() *= 1 + std::max(0.0, min_distinct_jumps - distinct);
  const Matrix inverse = matrix.inverse();
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      stiffness(edge[i], edge[j]) = 0.5 * area * (inverse(i, j) + inverse(j, i));
    }
  }
  return stiffness;
}

}  // namespace toile
