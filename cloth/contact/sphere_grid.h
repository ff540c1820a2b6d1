// A uniform grid in space that finds small things near a place.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// Spheres around things of about one size, filed by their centres. Of the few that are much larger
/// than the rest, all are looked at each time.
class SphereGrid {
 public:
  struct Sphere {
    Vec3 centre;
    double radius;
  };

  /// For questions about what is within `reach` of a sphere.
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
    constexpr double much_larger = 1.5;
    max_radius_ = much_larger * sum / std::max<std::size_t>(spheres.size(), 1);
    cell_ = std::max(0.5 * (2 * max_radius_ + reach), 1e-6);
    // Empty cells cost too: small spheres far apart get large ones.
    constexpr double max_cells_a_sphere = 8;
    const double max_cells = max_cells_a_sphere * static_cast<double>(spheres.size()) + 1;
    while (((high - low_) / cell_ + Vec3::Ones()).prod() > max_cells) cell_ *= 1.2;
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

  /// Calls `visit` with the number of each sphere that is nearer than the reach to this one, in an
  /// order that depends only on the spheres.
  template <typename Visit>
  void near(const Vec3& centre, double radius, const Visit& visit) const {
    near_from(0, centre, radius, [&](const Item& item) { visit(item.number); });
  }

  /// Pairs fall into as many parts as there are spheres, to be asked for in any order.
  std::size_t parts() const { return items_.size(); }

  /// Calls `visit` with the numbers of two spheres nearer to each other than the reach, the lesser
  /// first; over all parts, once for each such two.
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

  /// Of the items from `start` on.
  template <typename Visit>
  void near_from(std::size_t start, const Vec3& centre, double radius, const Visit& visit) const {
    const auto consider = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = std::max(begin, start); i < end; ++i) {
        const double apart = radius + items_[i].radius + reach_;
        if ((items_[i].centre - centre).squaredNorm() < apart * apart) visit(items_[i]);
      }
    };
    // A large sphere can be near anything.
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
  std::vector<int> first_;   // per cell, its first item
  std::vector<Item> items_;  // by cells; then the large ones
};

}  // namespace toile
