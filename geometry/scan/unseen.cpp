#include "geometry/scan/unseen.h"

#include <algorithm>
#include <numeric>

namespace toile {

Unseen::Unseen(const std::vector<Vec3>& samples, double reach)
    : cells_(samples, reach), first_(cells_.cells() + 1, 0), reach_(reach) {
  std::vector<int> order(samples.size());
  std::iota(order.begin(), order.end(), 0);
  const std::vector<int>& cell_of = cells_.cell_of();
  std::ranges::stable_sort(order, {}, [&](int s) { return cell_of[s]; });
  samples_.reserve(samples.size());
  for (const int s : order) samples_.push_back(samples[s]);
  for (const int cell : cell_of) ++first_[cell + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

double Unseen::operator()(const Vec3& point) const {
  double seen = 0;
  cells_.near(point, 1, [&](int cell) {
    for (int s = first_[cell]; s < first_[cell + 1] && seen < 1; ++s) {
      const double share = (samples_[s] - point).squaredNorm() / (reach_ * reach_);
      if (share < 1) seen += (1 - share) * (1 - share) * (1 - share);
    }
  });
  const double left = std::max(0.0, 1 - seen);
  return left * left * left;
}

bool Unseen::is_far(const Vec3& point) const {
  bool far = true;
  cells_.near(point, 1, [&](int cell) {
    for (int s = first_[cell]; s < first_[cell + 1] && far; ++s) {
      far = (samples_[s] - point).squaredNorm() >= reach_ * reach_;
    }
  });
  return far;
}

}  // namespace toile
