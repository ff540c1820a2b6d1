#include "geometry/distance_grid.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile {

namespace {

/// Coarse cells are this many fine ones along each axis.
constexpr int coarsening = 4;

/// Nodes of a regular grid, filled with tree distances along x so that each query starts from its
/// neighbour's answer. The rows are independent, so the values don't depend on the threads.
template <typename Wanted>
void fill_exactly(const std::vector<const BodyDistance*>& surfaces, const Vec3& origin, double cell,
                  const std::array<int, 3>& size, std::vector<float>& values,
                  const Wanted& wanted) {
  tbb::parallel_for(0, size[1] * size[2], [&](int row) {
    const int j = row % size[1];
    const int k = row / size[1];
    std::vector<BodyPoint> last(surfaces.size());
    bool known = false;
    for (int i = 0; i < size[0]; ++i) {
      if (!wanted(i, j, k)) continue;
      const Vec3 point = origin + cell * Vec3(i, j, k);
      double least = std::numeric_limits<double>::max();
      for (std::size_t s = 0; s < surfaces.size(); ++s) {
        last[s] = known ? surfaces[s]->nearest(point, last[s]) : surfaces[s]->nearest(point);
        least = std::min(least, last[s].distance);
      }
      known = true;
      values[static_cast<std::size_t>(row) * size[0] + i] = static_cast<float>(least);
    }
  });
}

}  // namespace

DistanceGrid::DistanceGrid(const BodyDistance& body, const DistanceGridOptions& options)
    : DistanceGrid(std::vector{&body}, options) {}

DistanceGrid::DistanceGrid(const std::vector<const BodyDistance*>& surfaces,
                           const DistanceGridOptions& options)
    : cell_(options.cell), band_(options.band), padding_(options.padding) {
  Vec3 low = surfaces.front()->body().points.front();
  Vec3 high = low;
  for (const BodyDistance* surface : surfaces) {
    for (const Vec3& p : surface->body().points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  const double coarse_cell = coarsening * cell_;
  origin_ = low - Vec3::Constant(padding_ + cell_);
  std::array<int, 3> coarse_size;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = high[axis] + padding_ + cell_ - origin_[axis];
    coarse_size[axis] = static_cast<int>(std::ceil(extent / coarse_cell)) + 1;
    size_[axis] = (coarse_size[axis] - 1) * coarsening + 1;
  }

  std::vector<float> coarse(static_cast<std::size_t>(coarse_size[0]) * coarse_size[1] *
                            coarse_size[2]);
  fill_exactly(surfaces, origin_, coarse_cell, coarse_size, coarse,
               [](int, int, int) { return true; });

  // Everywhere first from the coarse grid (trilinear), ...
  values_.resize(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2]);
  const auto coarse_at = [&](int i, int j, int k) {
    return coarse[(static_cast<std::size_t>(k) * coarse_size[1] + j) * coarse_size[0] + i];
  };
  tbb::parallel_for(0, size_[2], [&](int k) {
    const int ck = std::min(k / coarsening, coarse_size[2] - 2);
    const float w = static_cast<float>(k - ck * coarsening) / coarsening;
    for (int j = 0; j < size_[1]; ++j) {
      const int cj = std::min(j / coarsening, coarse_size[1] - 2);
      const float v = static_cast<float>(j - cj * coarsening) / coarsening;
      for (int i = 0; i < size_[0]; ++i) {
        const int ci = std::min(i / coarsening, coarse_size[0] - 2);
        const float u = static_cast<float>(i - ci * coarsening) / coarsening;
        float sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
          const int a = corner & 1;
          const int b = (corner >> 1) & 1;
          const int c = corner >> 2;
          sum += (a ? u : 1 - u) * (b ? v : 1 - v) * (c ? w : 1 - w) *
                 coarse_at(ci + a, cj + b, ck + c);
        }
        values_[index(i, j, k)] = sum;
      }
    }
  });

  // ... then exactly near the skin. A distance changes no faster than the point moves, and no point
  // of a cell is farther from a corner than half its diagonal.
  interpolation_error_ = 0.5 * std::sqrt(3.0) * coarse_cell;
  const float reach = static_cast<float>(band_ + interpolation_error_);
  std::vector<char> near(values_.size());
  for (std::size_t n = 0; n < values_.size(); ++n) near[n] = std::abs(values_[n]) < reach;
  fill_exactly(surfaces, origin_, cell_, size_, values_,
               [&](int i, int j, int k) { return near[index(i, j, k)] != 0; });
}

DistanceGrid::Sample DistanceGrid::beyond(const Vec3& point) const {
  if (!point.allFinite()) return {padding_, Vec3::Zero()};
  const Vec3 low = origin_ + Vec3::Constant(1.5 * cell_);
  const Vec3 high = origin_ + cell_ * Vec3(size_[0] - 2.5, size_[1] - 2.5, size_[2] - 2.5);
  const Vec3 inside = point.cwiseMax(low).cwiseMin(high);
  const Sample there = at(inside);
  const Vec3 from_skin = point - inside + there.distance * there.gradient;
  // The grid is convex and holds the body: no nearer than the two legs of a right angle tell.
  return {std::hypot(there.distance, (point - inside).norm()), from_skin.normalized()};
}

DistanceGrid::Sample DistanceGrid::at(const Vec3& point) const {
  const Vec3 local = (point - origin_) / cell_;
  int base[3];
  double weight[3][3];
  double slope[3][3];
  for (int axis = 0; axis < 3; ++axis) {
    if (!(local[axis] >= 1 && local[axis] <= size_[axis] - 2)) return beyond(point);
    const int centre = std::min(static_cast<int>(local[axis] + 0.5), size_[axis] - 2);
    const double t = local[axis] - centre;  // in [-0.5, 0.5]
    base[axis] = centre - 1;
    weight[axis][0] = 0.5 * (0.5 - t) * (0.5 - t);
    weight[axis][1] = 0.75 - t * t;
    weight[axis][2] = 0.5 * (0.5 + t) * (0.5 + t);
    slope[axis][0] = t - 0.5;
    slope[axis][1] = -2 * t;
    slope[axis][2] = t + 0.5;
  }
  double value = 0;
  Vec3 gradient = Vec3::Zero();
  for (int c = 0; c < 3; ++c) {
    for (int b = 0; b < 3; ++b) {
      const float* row = &values_[index(base[0], base[1] + b, base[2] + c)];
      const double along = weight[0][0] * row[0] + weight[0][1] * row[1] + weight[0][2] * row[2];
      const double rise = slope[0][0] * row[0] + slope[0][1] * row[1] + slope[0][2] * row[2];
      value += weight[1][b] * weight[2][c] * along;
      gradient.x() += weight[1][b] * weight[2][c] * rise;
      gradient.y() += slope[1][b] * weight[2][c] * along;
      gradient.z() += weight[1][b] * slope[2][c] * along;
    }
  }
  return {value, gradient / cell_};
}

}  // namespace toile
