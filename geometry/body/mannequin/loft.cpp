#include "geometry/body/mannequin/loft.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace toile {

Loft::Loft(const LoftFrame& frame, std::vector<LoftRow> rows, double rounding)
    : frame_(frame), rows_(std::move(rows)), rounding_(rounding) {
  fit();
}

void Loft::scale(int i, double factor) {
  LoftRow& row = rows_[i];
  row.half_width *= factor;
  row.front *= factor;
  row.back *= factor;
  fit();
}

void Loft::fit() {
  const int n = static_cast<int>(rows_.size());
  values_.resize(n);
  curvatures_.resize(n);
  for (int i = 0; i < n; ++i) {
    const LoftRow& r = rows_[i];
    values_[i] << r.u, r.v, r.half_width, r.front, r.back, r.squareness;
  }
  // The natural cubic spline: the second derivatives at the rows, 0 at the ends, make the first
  // derivatives continuous.
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 6);
  for (int i = 1; i + 1 < n; ++i) {
    const double before = rows_[i].t - rows_[i - 1].t;
    const double after = rows_[i + 1].t - rows_[i].t;
    system(i, i - 1) = before / 6;
    system(i, i) = (before + after) / 3;
    system(i, i + 1) = after / 6;
    right.row(i) = ((values_[i + 1] - values_[i]) / after - (values_[i] - values_[i - 1]) / before)
                       .matrix()
                       .transpose();
  }
  const Eigen::MatrixXd solved = system.partialPivLu().solve(right);
  for (int i = 0; i < n; ++i) curvatures_[i] = solved.row(i).transpose().array();

  // Metres: splines may swing a little beyond their rows.
  constexpr double margin = 0.01;
  low_ = Vec3(1e9, 1e9, rows_.front().t);
  high_ = Vec3(-1e9, -1e9, rows_.back().t);
  elliptic_ = true;
  for (const LoftRow& r : rows_) {
    low_.x() = std::min(low_.x(), r.u - r.half_width - margin);
    low_.y() = std::min(low_.y(), r.v - r.back - margin);
    high_.x() = std::max(high_.x(), r.u + r.half_width + margin);
    high_.y() = std::max(high_.y(), r.v + r.front + margin);
    elliptic_ = elliptic_ && r.squareness == 2;
  }
}

void Loft::evaluate(double t, Channels& value, Channels& slope) const {
  t = std::clamp(t, rows_.front().t, rows_.back().t);
  const auto after = std::upper_bound(rows_.begin() + 1, rows_.end() - 1, t,
                                      [](double x, const LoftRow& row) { return x < row.t; });
  const std::size_t j = static_cast<std::size_t>(after - rows_.begin());
  const std::size_t i = j - 1;
  const double h = rows_[j].t - rows_[i].t;
  const double b = (t - rows_[i].t) / h;
  const double a = 1 - b;
  value = a * values_[i] + b * values_[j] +
          ((a * a * a - a) * curvatures_[i] + (b * b * b - b) * curvatures_[j]) * (h * h / 6);
  slope = (values_[j] - values_[i]) / h +
          ((3 * b * b - 1) * curvatures_[j] - (3 * a * a - 1) * curvatures_[i]) * (h / 6);
}

Vec3 Loft::centre(double t) const {
  Channels value;
  Channels slope;
  evaluate(t, value, slope);
  return frame_.origin + t * frame_.along + value[0] * frame_.u + value[1] * frame_.v;
}

double Loft::distance(const Vec3& point) const {
  const Vec3 local = point - frame_.origin;
  const Vec3 place(local.dot(frame_.u), local.dot(frame_.v), local.dot(frame_.along));
  const double away = (low_ - place).cwiseMax(place - high_).cwiseMax(0).norm();
  if (away > far) return away;

  const double t = place.z();
  Channels value;
  Channels slope;
  evaluate(t, value, slope);
  const double u = place.x() - value[0];
  const double v = place.y() - value[1];
  const int side = v > 0 ? 3 : 4;
  const double width = value[2];
  const double depth = value[side];
  const double n = elliptic_ ? 2 : value[5];
  const auto power = [this, n](double x) { return elliptic_ ? x * x : std::pow(x, n); };

  // rho is 1 on the surface and grows in proportion along every ray from the centre line. So
  // rho - 1 divided by the size of its gradient is a distance to first order.
  const double in_u = power(std::abs(u) / width);
  const double in_v = power(std::abs(v) / depth);
  const double sum = in_u + in_v;
  double radial = -std::min(width, depth);
  if (sum > 1e-12) {
    const double rho = elliptic_ ? std::sqrt(sum) : std::pow(sum, 1 / n);
    const double along_u = u == 0 ? 0 : rho * in_u / (sum * u);
    const double along_v = v == 0 ? 0 : rho * in_v / (sum * v);
    const double along_t = -along_u * slope[0] - along_v * slope[1] -
                           rho / sum * (in_u / width * slope[2] + in_v / depth * slope[side]);
    radial = (rho - 1) / std::sqrt(along_u * along_u + along_v * along_v + along_t * along_t);
  }
  const double beyond = std::max(rows_.front().t - t, t - rows_.back().t);
  return smooth_intersection(radial, beyond, rounding_);
}

double Ellipsoid::distance(const Vec3& point) const {
  const Vec3 offset = point - centre;
  const double c = std::cos(tilt);
  const double s = std::sin(tilt);
  const Vec3 turned(offset.x(), c * offset.y() + s * offset.z(), c * offset.z() - s * offset.y());
  const Vec3 scaled = turned.cwiseQuotient(radii);
  const double k = scaled.norm();
  const double slope = scaled.cwiseQuotient(radii).norm();
  return slope > 1e-9 ? k * (k - 1) / slope : -radii.minCoeff();
}

double smooth_union(double a, double b, double blend) {
  const double h = std::max(blend - std::abs(a - b), 0.0) / blend;
  return std::min(a, b) - h * h * h * blend / 6;
}

double smooth_intersection(double a, double b, double blend) {
  return -smooth_union(-a, -b, blend);
}

}  // namespace toile
