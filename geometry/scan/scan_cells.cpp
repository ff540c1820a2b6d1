#include "geometry/scan/scan_cells.h"

#include <oneapi/tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "geometry/parallel.h"

namespace toile {

namespace {

constexpr int key_bits = 21;              // a coordinate; three fill a key
constexpr std::int64_t cell_margin = 64;  // cells: a neighbour's coordinate is never below zero

}  // namespace

ScanCells::ScanCells(const std::vector<Vec3>& points, double size) : size_(size) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  size_ = std::max(size_, box.sizes().maxCoeff() / 1e6);
  if (!(size_ > 0)) size_ = 1;
  origin_ = box.min();
  std::vector<std::pair<std::uint64_t, int>> order(points.size());
  parallel_for_chunks(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      order[i] = {key(place(points[i])), static_cast<int>(i)};
    }
  });
  tbb::parallel_sort(order.begin(), order.end());
  cell_of_.resize(points.size());
  for (const auto& [cell, point] : order) {
    if (keys_.empty() || keys_.back() != cell) {
      keys_.push_back(cell);
      means_.push_back(Vec3::Zero());
      counts_.push_back(0);
    }
    cell_of_[point] = static_cast<int>(keys_.size()) - 1;
    means_.back() += points[point];
    ++counts_.back();
  }
  for (std::size_t i = 0; i < means_.size(); ++i) means_[i] /= counts_[i];
}

std::array<std::int64_t, 3> ScanCells::place(const Vec3& point) const {
  std::array<std::int64_t, 3> at;
  for (int i = 0; i < 3; ++i) {
    at[i] = static_cast<std::int64_t>(std::floor((point[i] - origin_[i]) / size_)) + cell_margin;
  }
  return at;
}

std::uint64_t ScanCells::key(const std::array<std::int64_t, 3>& place) {
  constexpr std::int64_t most = (std::int64_t{1} << key_bits) - 1;
  std::uint64_t key = 0;
  for (int i = 2; i >= 0; --i) {
    key = key << key_bits | static_cast<std::uint64_t>(std::clamp(place[i], std::int64_t{0}, most));
  }
  return key;
}

double point_spacing(const std::vector<Vec3>& points) {
  if (points.empty()) return 0;
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  double size = box.sizes().maxCoeff() / 200;
  if (!(size > 0)) return 0;
  for (int round = 0; round < 12; ++round) {
    const ScanCells cells(points, size);
    // The cell in which half of the points have passed: cells with a stray point don't count much.
    std::vector<int> counts = cells.counts();
    std::sort(counts.begin(), counts.end());
    std::size_t passed = 0;
    std::size_t at = 0;
    while (2 * (passed + static_cast<std::size_t>(counts[at])) < points.size()) {
      passed += static_cast<std::size_t>(counts[at++]);
    }
    const int count = counts[at];
    const bool is_whole = cells.cells() < 8;  // nothing larger to look at
    if (count >= 6 || is_whole) return size / std::sqrt(static_cast<double>(count));
    size *= count >= 3 ? 1.5 : 2.0;
  }
  return size;
}

}  // namespace toile
