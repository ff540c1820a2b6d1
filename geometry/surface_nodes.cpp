#include "geometry/surface_nodes.h"

#include <cmath>
#include <limits>

namespace toile {

double NodeLattice::interpolation_error() const { return 0.5 * std::sqrt(3.0) * coarsening * cell; }

SurfaceNodes::SurfaceNodes(const BodyDistance& surface, const NodeLattice& lattice)
    : surface_(surface), lattice_(lattice) {}

SurfaceNodes::~SurfaceNodes() {
  const std::size_t count = static_cast<std::size_t>(size_[0]) * size_[1] * size_[2];
  for (std::size_t i = 0; i < count; ++i) delete bricks_[i].load(std::memory_order_relaxed);
}

void SurfaceNodes::cover(const Index& first, const Index& size) {
  const auto count = [](const Index& of, int more) {
    return static_cast<std::size_t>(of[0] + more) * (of[1] + more) * (of[2] + more);
  };
  std::unique_ptr<std::atomic<const Brick*>[]> bricks(
      new std::atomic<const Brick*>[count(size, 0)] {});
  std::unique_ptr<std::atomic<float>[]> coarse(new std::atomic<float>[count(size, 1)]);
  for (std::size_t i = 0; i < count(size, 1); ++i) {
    coarse[i].store(std::numeric_limits<float>::quiet_NaN(), std::memory_order_relaxed);
  }
  // As many coarse nodes as bricks and one more along each axis.
  const auto each = [&](int more, const auto& visit) {
    if (size_[0] == 0) return;
    const Index to = {size[0] + more, size[1] + more, size[2] + more};
    const Index from = {size_[0] + more, size_[1] + more, size_[2] + more};
    for (int k = 0; k < from[2]; ++k) {
      for (int j = 0; j < from[1]; ++j) {
        for (int i = 0; i < from[0]; ++i) {
          const Index there = {i + first_[0] - first[0], j + first_[1] - first[1],
                               k + first_[2] - first[2]};
          visit(place({i, j, k}, from), place(there, to));
        }
      }
    }
  };
  each(0, [&](std::size_t from, std::size_t to) { bricks[to] = bricks_[from].load(); });
  each(1, [&](std::size_t from, std::size_t to) { coarse[to] = coarse_[from].load(); });
  bricks_ = std::move(bricks);
  coarse_ = std::move(coarse);
  first_ = first;
  size_ = size;
}

const SurfaceNodes::Brick& SurfaceNodes::at(const Index& brick) const {
  std::atomic<const Brick*>& known =
      bricks_[place({brick[0] - first_[0], brick[1] - first_[1], brick[2] - first_[2]}, size_)];
  const Brick* found = known.load(std::memory_order_acquire);
  if (found != nullptr) return *found;
  // Two threads may compute the same: the values are the same, the first to be done stays.
  std::unique_ptr<const Brick> computed(compute(brick));
  if (known.compare_exchange_strong(found, computed.get(), std::memory_order_acq_rel)) {
    return *computed.release();
  }
  return *found;
}

double SurfaceNodes::coarse(const Index& node) const {
  std::atomic<float>& known =
      coarse_[place({node[0] - first_[0], node[1] - first_[1], node[2] - first_[2]},
                    {size_[0] + 1, size_[1] + 1, size_[2] + 1})];
  const float value = known.load(std::memory_order_relaxed);
  if (!std::isnan(value)) return value;
  const Vec3 point = lattice_.origin + side * lattice_.cell * Vec3(node[0], node[1], node[2]);
  const auto computed = static_cast<float>(surface_.nearest(point).distance);
  known.store(computed, std::memory_order_relaxed);
  return computed;
}

const SurfaceNodes::Brick* SurfaceNodes::compute(const Index& brick) const {
  double corners[2][2][2];
  for (int c = 0; c < 2; ++c) {
    for (int b = 0; b < 2; ++b) {
      for (int a = 0; a < 2; ++a) {
        corners[c][b][a] = coarse({brick[0] + a, brick[1] + b, brick[2] + c});
      }
    }
  }
  auto values = std::make_unique<Brick>();
  const double reach = lattice_.reach + lattice_.interpolation_error();
  const auto between = [](double from, double to, int step) {
    return from + (to - from) * step / side;
  };
  BodyPoint last;
  bool has_last = false;
  for (int k = 0; k < side; ++k) {
    for (int j = 0; j < side; ++j) {
      double ends[2];
      for (int a = 0; a < 2; ++a) {
        ends[a] = between(between(corners[0][0][a], corners[0][1][a], j),
                          between(corners[1][0][a], corners[1][1][a], j), k);
      }
      for (int step = 0; step < side; ++step) {
        // To and fro, so that the last node is a neighbour: its triangle is most often this one's.
        const int i = (k * side + j) % 2 == 0 ? step : side - 1 - step;
        double value = between(ends[0], ends[1], i);
        if (std::abs(value) < reach) {
          const Vec3 node(side * brick[0] + i, side * brick[1] + j, side * brick[2] + k);
          const Vec3 point = lattice_.origin + lattice_.cell * node;
          last = has_last ? surface_.nearest(point, last) : surface_.nearest(point);
          has_last = true;
          value = last.distance;
        }
        (*values)[(k * side + j) * side + i] = static_cast<float>(value);
      }
    }
  }
  return values.release();
}

}  // namespace toile
