#include "cloth/hinge_rigidity.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {

namespace {

/// Least of Σ (matrix·x - right)² over all x of 0 and more: the best of all the ways to hold some
/// of them at 0.
Eigen::Vector3d least_squares_of_positives(const Eigen::Matrix3d& matrix,
                                           const Eigen::Vector3d& right) {
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  double least = 0;  // of ½ xᵀ matrix x - rightᵀ x
  for (int held = 0; held < 7; ++held) {
    Eigen::Matrix3d m = matrix;
    Eigen::Vector3d r = right;
    for (int i = 0; i < 3; ++i) {
      if (((held >> i) & 1) == 0) continue;
      m.row(i).setZero();
      m.col(i).setZero();
      m(i, i) = 1;
      r[i] = 0;
    }
    const Eigen::Vector3d x = m.inverse() * r;
    if (x.minCoeff() < 0) continue;
    if (held == 0) return x;
    const double cost = 0.5 * x.dot(matrix * x) - right.dot(x);
    if (cost < least) {
      least = cost;
      best = x;
    }
  }
  return best;
}

}  // namespace

double bending_along(const Fabric& fabric, double angle) {
  const double weft = std::pow(std::cos(angle), 2);
  return std::pow(
      weft * std::sqrt(fabric.bending_weft) + (1 - weft) * std::sqrt(fabric.bending_warp), 2);
}

HingeResponse hinge_response(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& away,
                             double grain) {
  const double length = (b - a).norm();
  const Vec2 along = (b - a) / length;
  const double place = along.dot(c - a);
  const double height = along.x() * (c - a).y() - along.y() * (c - a).x();
  HingeResponse response;
  response.along = {std::cos(grain) * along.x() + std::sin(grain) * along.y(),
                    std::cos(grain) * along.y() - std::sin(grain) * along.x()};
  response.normal = 0.5 * (height + away.y());
  response.edge =
      0.5 * (place * (place - length) / height + away.x() * (away.x() - length) / away.y());
  response.twist = place - away.x();
  response.weight = length / (height + away.y());
  return response;
}

std::array<double, 3> hinge_rigidities(const Fabric& fabric,
                                       const std::array<HingeResponse, 3>& hinges) {
  if (fabric.bending_weft == fabric.bending_warp) {
    return {fabric.bending_weft, fabric.bending_weft, fabric.bending_weft};
  }
  struct Way {
    double angle;  // of the direction rolled along, to the weft
    double weight;
  };
  constexpr double quarter = std::numbers::pi / 4;
  constexpr std::array<Way, 4> ways = {
      {{0, 10}, {2 * quarter, 10}, {quarter, 0.3}, {-quarter, 0.3}}};
  // Keeps what the ways leave open near the sheet's rigidity across the hinge, and off 0.
  constexpr double habit = 0.05;
  const double least = 0.05 * std::min(fabric.bending_weft, fabric.bending_warp);
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Way& way : ways) {
    const Vec2 rolled(std::cos(way.angle), std::sin(way.angle));
    Eigen::Vector3d felt;
    for (int i = 0; i < 3; ++i) {
      const HingeResponse& hinge = hinges[i];
      const double t = rolled.dot(hinge.along);
      const double n = rolled.y() * hinge.along.x() - rolled.x() * hinge.along.y();
      felt[i] = hinge.weight *
                std::pow(hinge.normal * n * n + hinge.edge * t * t + hinge.twist * n * t, 2);
    }
    const double wanted = bending_along(fabric, way.angle);
    if (!(felt.sum() > 0) || !(wanted > 0)) continue;
    felt /= felt.sum() * wanted;
    matrix += way.weight * felt * felt.transpose();
    right += way.weight * felt;
  }
  for (int i = 0; i < 3; ++i) {
    const double across = std::atan2(hinges[i].along.x(), -hinges[i].along.y());
    const double usual = std::max(bending_along(fabric, across), least);
    matrix(i, i) += habit * habit / (usual * usual);
    right[i] += habit * habit / usual;
  }
  right -= matrix * Eigen::Vector3d::Constant(least);
  // In units of the rigidities, for the sake of the numbers' size.
  const double unit = std::max(fabric.bending_weft, fabric.bending_warp);
  const Eigen::Vector3d x = least_squares_of_positives(unit * unit * matrix, unit * right);
  std::array<double, 3> rigidity;
  for (int i = 0; i < 3; ++i) rigidity[i] = least + unit * x[i];
  return rigidity;
}

}  // namespace toile
