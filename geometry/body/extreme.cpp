#include "geometry/body/extreme.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace toile {

namespace {

/// The sample around which the mean within `reach` is greatest. At an end it counts alone.
std::size_t greatest_of_means(const std::vector<Vec2>& samples, double reach) {
  std::size_t best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    // As far to the one side as to the other: a slope has no greatest mean within.
    const double at = samples[i].x();
    const double half = std::min({reach, at - samples.front().x(), samples.back().x() - at});
    double sum = 0;
    int n = 0;
    for (const Vec2& sample : samples) {
      if (std::abs(sample.x() - at) > half * (1 + 1e-9)) continue;
      sum += sample.y();
      ++n;
    }
    if (sum / n > most) {
      most = sum / n;
      best = i;
    }
  }
  return best;
}

}  // namespace

Extreme greatest(const std::vector<Vec2>& samples, double reach) {
  constexpr double fade = 1.5;  // of the reach: samples beyond don't count
  const std::size_t most = greatest_of_means(samples, reach / 2);
  Extreme extreme{samples[most].x(), samples[most].y(), 0, false};
  const double low = samples.front().x();
  const double high = samples.back().x();
  // An end, unless the samples rise and fall: 2 of 5 within the reach have to be on either side.
  const double margin = 0.4 * reach;
  if (extreme.at - low < margin || high - extreme.at < margin) {
    extreme.is_end = true;
    return extreme;
  }
  constexpr int most_rounds = 20;  // 5 are usual
  for (int round = 0; round < most_rounds; ++round) {
    Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    int n = 0;
    for (const Vec2& sample : samples) {
      const double t = (sample.x() - extreme.at) / reach;
      if (std::abs(t) > fade) continue;
      // Samples come in and go out by and by: else the summit jumps.
      const double share = std::pow(1 - t * t / (fade * fade), 2);
      const Eigen::Vector3d powers(1, t, t * t);
      sums += share * powers * powers.transpose();
      right += share * sample.y() * powers;
      ++n;
    }
    if (n < 4) return extreme;
    const Eigen::Vector3d fit = sums.ldlt().solve(right);
    if (!(fit[2] < 0)) return extreme;
    const double t = std::clamp(-fit[1] / (2 * fit[2]), -1.0, 1.0);
    extreme.value = fit[0] + t * (fit[1] + t * fit[2]);
    extreme.curvature = 2 * fit[2] / (reach * reach);
    extreme.at = std::clamp(extreme.at + t * reach, low, high);
    if (std::abs(t) < 1e-4) break;
  }
  return extreme;
}

}  // namespace toile
