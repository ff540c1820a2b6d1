// A uniform grid in space that finds the spheres near a point.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "cloth/contact/constants.h"
#include "geometry/types.h"

namespace toile {

/// Spheres of about one size, filed by their centres. The few that are much larger than the others
/// are compared with every query.
class SphereGrid {
 public:
  struct Sphere {
    Vec3 centre;
    double radius;
  };

  /// Files `spheres` (metres) for queries within `reach` metres of a sphere. O(n).
  SphereGrid(const std::vector<Sphere>& spheres, double reach) : reach_(reach) {
    low_ = Vec3::Constant(std::numeric_limits<double>::max());
    Vec3 high = -low_;
    double sum = 0;
    for (const Sphere& sphere : spheres) {
      low_ = low_.cwiseMin(sphere.centre);
      high = high.cwiseMax(sphere.centre);
      sum += sphere.radius;
    }
    if (spheres.empty()) low_ = high = Vec3::Zero();
    max_radius_ = large_sphere_ratio * sum / std::max<std::size_t>(spheres.size(), 1);
    cell_ = std::max(0.5 * (2 * max_radius_ + reach), 1e-6);
    const double max_cells = max_cells_per_sphere * static_cast<double>(spheres.size()) + 1;
    while (((high - low_) / cell_ + Vec3::Ones()).prod() > max_cells) cell_ *= cell_growth;
    for (int axis = 0; axis < 3; ++axis) {
      size_[axis] = static_cast<int>((high[axis] - low_[axis]) / cell_) + 1;
    }
    first_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2] + 1, 0);
    std::vector<std::size_t> cell_of(spheres.size());
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      if (spheres[i].radius > max_radius_) {
        continue;
      }
      const Vec3& c = spheres[i].centre;
      cell_of[i] = row(column(c, 1), column(c, 2)) + column(c, 0);
      ++first_[cell_of[i] + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    items_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      if (spheres[i].radius > max_radius_) continue;
      items_[next[cell_of[i]]++] = {spheres[i].centre, spheres[i].radius, static_cast<int>(i)};
    }
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      if (spheres[i].radius <= max_radius_) continue;
      items_.push_back({spheres[i].centre, spheres[i].radius, static_cast<int>(i)});
    }
  }

  /// Calls `visit` with the index of each sphere that is less than the reach away from the given
  /// one. The order depends on the spheres only.
  template <typename Visit>
  void near(const Vec3& centre, double radius, const Visit& visit) const {
    near_from(0, centre, radius, [&](const Item& item) { visit(item.number); });
  }

  /// Number of parts that all pairs of spheres fall into: one part per sphere.
  std::size_t parts() const { return items_.size(); }

  /// Calls `visit` with the indices, the lower first, of two spheres less than the reach apart, for
  /// each such pair of a part. Over all parts in [0, parts()), each pair comes once.
  template <typename Visit>
  void pairs(std::size_t part, const Visit& visit) const {
    const Item& one = items_[part];
    near_from(part + 1, one.centre, one.radius, [&](const Item& other) {
      visit(std::min(one.number, other.number), std::max(one.number, other.number));
    });
  }

 private:
  struct Item {
    Vec3 centre;
    double radius;
    int number;
  };

  /// Calls `visit` with each near item, of those from index `start` on.
  template <typename Visit>
  void near_from(std::size_t start, const Vec3& centre, double radius, const Visit& visit) const {
    const auto consider = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = std::max(begin, start); i < end; ++i) {
        const double apart = radius + items_[i].radius + reach_;
        if ((items_[i].centre - centre).squaredNorm() < apart * apart) visit(items_[i]);
      }
    };
    // Large spheres are in no cell.
    const std::size_t filed = static_cast<std::size_t>(first_.back());
    const double around = radius + max_radius_ + reach_;
    const Vec3 from = centre - Vec3::Constant(around);
    const Vec3 to = centre + Vec3::Constant(around);
    const int x0 = column(from, 0);
    const int x1 = column(to, 0);
    const int y1 = column(to, 1);
    const int z1 = column(to, 2);
    for (int z = column(from, 2); z <= z1; ++z) {
      for (int y = column(from, 1); y <= y1; ++y) {
        consider(first_[row(y, z) + x0], first_[row(y, z) + x1 + 1]);
      }
    }
    consider(filed, items_.size());
  }

  int column(const Vec3& p, int axis) const {
    return static_cast<int>(std::clamp((p[axis] - low_[axis]) / cell_, 0.0, size_[axis] - 1.0));
  }
  std::size_t row(int y, int z) const {
    return (static_cast<std::size_t>(z) * size_[1] + y) * size_[0];
  }

  double reach_;
  double max_radius_;
  double cell_;
  Vec3 low_;
  int size_[3];
  std::vector<int> first_;   // per cell, the index of its first item
  std::vector<Item> items_;  // by cells, then the large spheres
};

}  // namespace toile
