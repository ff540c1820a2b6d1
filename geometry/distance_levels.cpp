#include "geometry/distance_levels.h"

#include <cmath>
#include <limits>
#include <new>

namespace toile {

namespace {

constexpr int coarsening = 4;
constexpr int cube_side = 4;
constexpr std::size_t cube_nodes = std::tuple_size_v<decltype(DistanceCache::Cube::values)>;
static_assert(cube_nodes == std::size_t{cube_side} * cube_side * cube_side);
/// Cells of the middle level: nodes of it that are farther off are interpolated, too.
constexpr double far_cells = 4;

/// Metres by which interpolation in a cell can be wrong. A distance changes no faster than its
/// point moves. No point of a cell is farther from its nearest corner than half the diagonal.
double interpolation_error(double cell) { return 0.5 * std::sqrt(3.0) * cell; }

/// Metres from a point to the farthest node that a quadratic spline there uses.
double spline_reach(double cell) { return 1.5 * std::sqrt(3.0) * cell; }

int floor_by(int value, int divisor) {
  return value >= 0 ? value / divisor : -((divisor - 1 - value) / divisor);
}

}  // namespace

DistanceLevels::DistanceLevels(const SurfaceDistance& surface, const Vec3& origin, double cell,
                               double band)
    : surface_(surface), origin_(origin), band_(band) {
  const double middle = coarsening * cell;
  levels_[0].cell = cell;
  levels_[0].exact = band;
  levels_[0].reach = band + spline_reach(cell);
  levels_[1].cell = middle;
  levels_[1].exact = levels_[1].reach = far_cells * middle;
  levels_[2].cell = coarsening * middle;
  levels_[2].exact = levels_[2].reach = std::numeric_limits<double>::infinity();
}

double DistanceLevels::lower_bound(double distance, double cell, double band) {
  const double middle = coarsening * cell;
  const double once = distance - interpolation_error(middle);
  if (distance < 0) return once - interpolation_error(coarsening * middle);
  // A value interpolated twice has both errors. It contributes only to points that are nearly as
  // far off: less by a cell's diagonal and the spline's reach.
  const double far = far_cells * middle - std::sqrt(3.0) * middle - spline_reach(cell);
  if (once < far) return std::max(band, once);
  return std::max({band, far, once - interpolation_error(coarsening * middle)});
}

std::size_t DistanceLevels::Level::place(const Index& node) const {
  // Nodes are stored by small cubes, so that neighbours share pages and cache lines.
  std::size_t cube = 0;
  std::size_t inside = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const int from_first = node[axis] - first[axis];
    cube = cube * (size[axis] / cube_side) + from_first / cube_side;
    inside = inside * cube_side + from_first % cube_side;
  }
  return cube * cube_nodes + inside;
}

std::size_t DistanceLevels::Level::cubes() const {
  return static_cast<std::size_t>(size[0]) * size[1] * size[2] / cube_nodes;
}

DistanceCache DistanceLevels::cache() const {
  DistanceCache cache{levels_[0].cell, band_, levels_[0].first, levels_[0].size, {}};
  for (std::size_t l = 0; l < levels; ++l) {
    for (std::size_t c = 0; c < levels_[l].cubes(); ++c) {
      DistanceCache::Cube cube{static_cast<int>(c), {}};
      bool any = false;
      for (std::size_t i = 0; i < cube_nodes; ++i) {
        cube.values[i] = levels_[l].values[c * cube_nodes + i].load(std::memory_order_relaxed);
        any |= cube.values[i] != 0;
      }
      if (any) cache.levels[l].push_back(cube);
    }
  }
  return cache;
}

bool DistanceLevels::restore(const DistanceCache& cache) {
  if (cache.cell != levels_[0].cell || cache.band != band_ || cache.first != levels_[0].first ||
      cache.size != levels_[0].size) {
    return false;
  }
  for (std::size_t l = 0; l < levels; ++l) {
    for (const DistanceCache::Cube& cube : cache.levels[l]) {
      if (cube.number < 0 || static_cast<std::size_t>(cube.number) >= levels_[l].cubes()) {
        return false;
      }
    }
  }
  for (std::size_t l = 0; l < levels; ++l) {
    for (const DistanceCache::Cube& cube : cache.levels[l]) {
      std::atomic<float>* const values = &levels_[l].values[cube.number * cube_nodes];
      for (std::size_t i = 0; i < cube_nodes; ++i) {
        if (cube.values[i] != 0) values[i].store(cube.values[i], std::memory_order_relaxed);
      }
    }
  }
  return true;
}

void DistanceLevels::cover(const Index& first, const Index& size) {
  Index low = first;
  Index high;
  for (int axis = 0; axis < 3; ++axis) high[axis] = first[axis] + size[axis];
  for (Level& level : levels_) {
    Level covered;
    covered.cell = level.cell;
    covered.exact = level.exact;
    covered.reach = level.reach;
    std::size_t count = 1;
    for (int axis = 0; axis < 3; ++axis) {
      covered.first[axis] = low[axis];
      covered.size[axis] = coarsening * (floor_by(high[axis] - 1 - low[axis], coarsening) + 1);
      count *= static_cast<std::size_t>(covered.size[axis]);
      // The next level's nodes around all of these.
      high[axis] = floor_by(low[axis] + covered.size[axis] - 1, coarsening) + 2;
      low[axis] = floor_by(low[axis], coarsening);
    }
    // calloc() gives zeros, and pages that nobody writes to take no memory.
    void* const memory = std::calloc(count, sizeof(std::atomic<float>));
    if (memory == nullptr) throw std::bad_alloc();
    covered.values.reset(static_cast<std::atomic<float>*>(memory));
    for (int k = 0; k < level.size[2]; ++k) {
      for (int j = 0; j < level.size[1]; ++j) {
        for (int i = 0; i < level.size[0]; ++i) {
          const Index node = {level.first[0] + i, level.first[1] + j, level.first[2] + k};
          const float cached = level.values[level.place(node)];
          if (cached != 0) covered.values[covered.place(node)] = cached;
        }
      }
    }
    level = std::move(covered);
  }
}

float DistanceLevels::at(const Index& node, SurfacePoint& near) const { return at(0, node, near); }

void DistanceLevels::block_at(const Index& first, float* values) const {
  const Level& finest = levels_[0];
  // A place is the sum of what each axis adds to it.
  std::size_t places[3][block_side];
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < block_side; ++i) {
      Index node = finest.first;
      node[axis] = first[axis] + i;
      places[axis][i] = finest.place(node);
    }
  }
  SurfacePoint near;  // a hint: neighbouring nodes have closest points near each other
  for (int k = 0; k < block_side; ++k) {
    for (int j = 0; j < block_side; ++j) {
      for (int i = 0; i < block_side; ++i) {
        const std::size_t place = places[0][i] + places[1][j] + places[2][k];
        *values = finest.values[place].load(std::memory_order_relaxed);
        if (*values == 0) *values = at({first[0] + i, first[1] + j, first[2] + k}, near);
        ++values;
      }
    }
  }
}

float DistanceLevels::at(std::size_t level, const Index& node, SurfacePoint& near) const {
  std::atomic<float>& cached = levels_[level].values[levels_[level].place(node)];
  float value = cached.load(std::memory_order_relaxed);
  if (value != 0) return value;
  // Two threads may compute the same node. Their values are equal.
  value = compute(level, node, near);
  if (value == 0) value = std::numeric_limits<float>::min();
  if (cached.exchange(value, std::memory_order_relaxed) == 0) {
    computed_.fetch_add(1, std::memory_order_relaxed);
  }
  return value;
}

float DistanceLevels::compute(std::size_t level, const Index& node, SurfacePoint& near) const {
  if (level + 1 < levels) {
    Index low;
    double along[3];
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = floor_by(node[axis], coarsening);
      along[axis] = static_cast<double>(node[axis] - coarsening * low[axis]) / coarsening;
    }
    const double coarser = levels_[level + 1].cell;
    double value = 0;
    double sure = 0;  // metres: the surface is at least this far off, by the corners' distances
    double side = 1;
    for (int corner = 0; corner < 8; ++corner) {
      double weight = 1;
      double squared = 0;
      Index there;
      for (int axis = 0; axis < 3; ++axis) {
        const int up = corner >> axis & 1;
        there[axis] = low[axis] + up;
        const double beside = up != 0 ? 1 - along[axis] : along[axis];
        weight *= 1 - beside;
        squared += beside * beside;
      }
      if (weight == 0) continue;
      const double distance = at(level + 1, there, near);
      value += weight * distance;
      const double by_corner =
          std::min(std::abs(distance), levels_[level + 1].exact) - coarser * std::sqrt(squared);
      if (by_corner <= sure) continue;
      sure = by_corner;
      side = std::copysign(1.0, distance);
    }
    const Level& own = levels_[level];
    if (sure >= own.exact && side * value >= own.reach) return static_cast<float>(value);
  }
  const Vec3 point = origin_ + levels_[level].cell * Vec3(node[0], node[1], node[2]);
  near = surface_.closest_point(point, near);
  return static_cast<float>(near.distance);
}

}  // namespace toile
