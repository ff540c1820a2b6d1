#include "geometry/distance_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/triangle_tree.h"

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

/// A place in a cell of the next coarser level.
struct InCell {
  std::array<double, 8> weights;  ///< of the cell's corners
  std::array<double, 8> away;     ///< cells to each of them; infinite where the weight is 0
};

const InCell& in_cell(const NodeValues::Index& node) {
  static const std::array<InCell, cube_nodes> places = [] {
    std::array<InCell, cube_nodes> all;
    for (std::size_t i = 0; i < cube_nodes; ++i) {
      const std::array<std::size_t, 3> steps = {i % coarsening, i / coarsening % coarsening,
                                                i / coarsening / coarsening};
      for (std::size_t corner = 0; corner < 8; ++corner) {
        double weight = 1;
        double squared = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double along = static_cast<double>(steps[axis]) / coarsening;
          const double beside = (corner >> axis & 1) != 0 ? 1 - along : along;
          weight *= 1 - beside;
          squared += beside * beside;
        }
        all[i].weights[corner] = weight;
        all[i].away[corner] =
            weight == 0 ? std::numeric_limits<double>::infinity() : std::sqrt(squared);
      }
    }
    return all;
  }();
  std::size_t place = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const int step = node[axis] - coarsening * floor_by(node[axis], coarsening);
    place = place * coarsening + static_cast<std::size_t>(step);
  }
  return places[place];
}

/// The next coarser level's cell that a node lies in.
NodeValues::Index cell_of(const NodeValues::Index& node) {
  return {floor_by(node[0], coarsening), floor_by(node[1], coarsening),
          floor_by(node[2], coarsening)};
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

std::size_t DistanceLevels::Level::cubes() const { return nodes.count() / cube_nodes; }

std::size_t DistanceLevels::Level::cube_of(const Index& node) const {
  std::size_t cube = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const int along = (node[axis] - nodes.first()[axis]) / cube_side;
    cube = cube * (nodes.size()[axis] / cube_side) + along;
  }
  return cube;
}

template <typename Call>
void DistanceLevels::Level::for_each_node(std::size_t cube, const Call& call) const {
  Index node;
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = static_cast<std::size_t>(nodes.size()[axis] / cube_side);
    node[axis] = nodes.first()[axis] + cube_side * static_cast<int>(cube % along);
    cube /= along;
  }
  const std::size_t first = nodes.place(node);
  const auto row = static_cast<std::size_t>(nodes.size()[0]);
  const std::size_t slice = row * nodes.size()[1];
  std::size_t i = 0;
  for (std::size_t z = 0; z < cube_side; ++z) {
    for (std::size_t y = 0; y < cube_side; ++y) {
      for (std::size_t x = 0; x < cube_side; ++x) call(i++, first + z * slice + y * row + x);
    }
  }
}

bool DistanceLevels::Level::uses(std::size_t cube) const {
  return std::atomic_ref(in_use[cube]).load(std::memory_order_relaxed) != 0;
}

void DistanceLevels::Level::use(std::size_t cube) const {
  if (uses(cube)) return;
  if (!known_at.empty() && known_at[cube] != 0) {
    const DistanceCache::Cube& values = known[known_at[cube] - 1];
    for_each_node(cube, [&](std::size_t i, std::size_t place) {
      if (values.values[i] != 0) nodes.store(place, values.values[i]);
    });
  }
  std::atomic_ref(in_use[cube]).store(1, std::memory_order_relaxed);
}

DistanceCache DistanceLevels::cache() const {
  DistanceCache cache{levels_[0].cell, band_, nodes().first(), nodes().size(), {}};
  for (std::size_t l = 0; l < levels; ++l) {
    for (std::size_t c = 0; c < levels_[l].cubes(); ++c) {
      const Level& level = levels_[l];
      if (level.uses(c)) {
        DistanceCache::Cube cube{static_cast<int>(c), {}};
        level.for_each_node(
            c, [&](std::size_t i, std::size_t place) { cube.values[i] = level.nodes.load(place); });
        cache.levels[l].push_back(cube);
      } else if (!level.known_at.empty() && level.known_at[c] != 0) {
        cache.levels[l].push_back(level.known[level.known_at[c] - 1]);
      }
    }
  }
  return cache;
}

bool DistanceLevels::restore(DistanceCache cache) {
  if (cache.cell != levels_[0].cell || cache.band != band_ || cache.first != nodes().first() ||
      cache.size != nodes().size()) {
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
    Level& level = levels_[l];
    level.known = std::move(cache.levels[l]);
    level.known_at.assign(level.cubes(), 0);
    for (std::size_t k = 0; k < level.known.size(); ++k) {
      level.known_at[level.known[k].number] = static_cast<int>(k) + 1;
    }
  }
  return true;
}

std::size_t DistanceLevels::restored_nodes() const {
  std::size_t nodes = 0;
  for (const Level& level : levels_) nodes += level.known.size() * cube_nodes;
  return nodes;
}

void DistanceLevels::cover(const Index& first, const Index& size) {
  Index low = first;
  Index end;
  for (int axis = 0; axis < 3; ++axis) end[axis] = first[axis] + size[axis];
  for (Level& level : levels_) {
    for (const DistanceCache::Cube& cube : level.known) {
      level.use(static_cast<std::size_t>(cube.number));
    }
    level.known.clear();
    level.known_at.clear();
    Index covered_size;
    for (int axis = 0; axis < 3; ++axis) {
      // Whole cubes, then the next level's nodes around them.
      const int first_cell = floor_by(low[axis], coarsening);
      const int end_cell = floor_by(end[axis] - 1, coarsening) + 1;
      low[axis] = coarsening * first_cell;
      covered_size[axis] = coarsening * end_cell - low[axis];
      end[axis] = end_cell + 1;
    }
    const NodeValues before = std::exchange(level.nodes, NodeValues(low, covered_size));
    level.in_use.assign(level.cubes(), 0);
    low = cell_of(low);
    for (int k = 0; k < before.size()[2]; ++k) {
      for (int j = 0; j < before.size()[1]; ++j) {
        for (int i = 0; i < before.size()[0]; ++i) {
          const Index node = {before.first()[0] + i, before.first()[1] + j, before.first()[2] + k};
          const float known = before.load(before.place(node));
          if (known == 0) continue;
          level.nodes.store(level.nodes.place(node), known);
          level.in_use[level.cube_of(node)] = 1;
        }
      }
    }
  }
}

Vec3 DistanceLevels::point(std::size_t level, const Index& node) const {
  return origin_ + levels_[level].cell * Vec3(node[0], node[1], node[2]);
}

void DistanceLevels::store(std::size_t level, std::size_t place, float value) const {
  if (value == 0) value = std::numeric_limits<float>::min();
  // Two threads may compute the same node. Their values are equal.
  if (levels_[level].nodes.store(place, value) == 0) {
    computed_.fetch_add(1, std::memory_order_relaxed);
  }
}

void DistanceLevels::compute_cube(const Index& node) const {
  static_assert(coarsening == cube_side && cube_nodes <= TriangleTree::most_points);
  const NodeValues& finest = nodes();
  levels_[0].use(levels_[0].cube_of(node));
  if (finest.load(finest.place(node)) != 0) return;
  const Index cell = cell_of(node);
  SurfacePoint near;  // a hint: neighbouring nodes have closest points near each other
  const Corners around = corners(1, cell, near);
  std::array<Vec3, cube_nodes> points;
  std::array<std::size_t, cube_nodes> places;
  std::size_t exact = 0;
  for (int i = 0; i < static_cast<int>(cube_nodes); ++i) {
    const Index one = {coarsening * cell[0] + i % cube_side,
                       coarsening * cell[1] + i / cube_side % cube_side,
                       coarsening * cell[2] + i / cube_side / cube_side};
    const std::size_t place = finest.place(one);
    if (finest.load(place) != 0) continue;
    if (const std::optional<float> value = interpolated(0, one, around)) {
      store(0, place, *value);
    } else {
      points[exact] = point(0, one);
      places[exact++] = place;
    }
  }
  if (exact == 0) return;
  std::array<SurfacePoint, cube_nodes> found;
  surface_.closest_points({points.data(), exact}, near, found.data());
  for (std::size_t i = 0; i < exact; ++i) {
    store(0, places[i], static_cast<float>(found[i].distance));
  }
}

float DistanceLevels::at(std::size_t level, const Index& node, SurfacePoint& near) const {
  const NodeValues& nodes = levels_[level].nodes;
  const std::size_t place = nodes.place(node);
  if (nodes.load(place) == 0) levels_[level].use(levels_[level].cube_of(node));
  if (nodes.load(place) == 0) {
    std::optional<float> value;
    if (level + 1 < levels)
      value = interpolated(level, node, corners(level + 1, cell_of(node), near));
    if (!value) {
      near = surface_.closest_point(point(level, node), near);
      value = static_cast<float>(near.distance);
    }
    store(level, place, *value);
  }
  return nodes.load(place);
}

DistanceLevels::Corners DistanceLevels::corners(std::size_t level, const Index& cell,
                                                SurfacePoint& near) const {
  Corners corners;
  for (int corner = 0; corner < 8; ++corner) {
    Index node = cell;
    for (int axis = 0; axis < 3; ++axis) node[axis] += corner >> axis & 1;
    corners[corner] = at(level, node, near);
  }
  return corners;
}

std::optional<float> DistanceLevels::interpolated(std::size_t level, const Index& node,
                                                  const Corners& corners) const {
  const Level& coarser = levels_[level + 1];
  const InCell& place = in_cell(node);
  double value = 0;
  double sure = 0;  // metres: the surface is at least this far off, by the corners' distances
  double side = 1;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const double distance = corners[corner];
    value += place.weights[corner] * distance;
    const double by_corner =
        std::min(std::abs(distance), coarser.exact) - coarser.cell * place.away[corner];
    if (by_corner <= sure) continue;
    sure = by_corner;
    side = std::copysign(1.0, distance);
  }
  const Level& own = levels_[level];
  if (sure < own.exact || side * value < own.reach) return {};
  return static_cast<float>(value);
}

}  // namespace toile
