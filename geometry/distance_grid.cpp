#include "geometry/distance_grid.h"

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>

#include "geometry/distance_levels.h"
#include "geometry/vec4.h"

namespace toile {

namespace {

/// Nodes of a block along each axis, without and with the rim of one node that the spline needs.
constexpr int block_side = 2;
constexpr int rimmed_side = DistanceLevels::block_side;
constexpr int rimmed_nodes = rimmed_side * rimmed_side * rimmed_side;
static_assert(rimmed_side == block_side + 2);

using Index = DistanceLevels::Index;

/// Four neighbours along x, as stored.
using Four = float __attribute__((vector_size(16)));

}  // namespace

/// The distances, metres, at all nodes that a lookup needs: along x first, then y, then z. The
/// nodes of one z are a line of the cache.
struct alignas(64) DistanceGrid::Block {
  float values[rimmed_nodes];
};

/// The blocks, and the distances that fill them.
struct DistanceGrid::Table {
  Vec3 origin;  // metres: node 0
  double cell;
  std::vector<std::unique_ptr<DistanceLevels>> surfaces;
  Index first = {0, 0, 0};  // first block; it begins at node block_side * first
  Index size = {0, 0, 0};   // blocks along each axis
  struct Free {
    void operator()(void* memory) const { std::free(memory); }
  };
  std::unique_ptr<std::atomic<const Block*>[], Free> blocks;
  /// Memory of the blocks that a thread has filled. Freed by slabs, for there are tens of
  /// thousands.
  struct Store {
    static constexpr std::size_t slab = 64;  // blocks
    std::vector<std::unique_ptr<Block[]>> slabs;
    std::size_t used = slab;  // of the last slab

    Block* next() {
      if (used == slab) {
        slabs.push_back(std::make_unique_for_overwrite<Block[]>(slab));
        used = 0;
      }
      return &slabs.back()[used++];
    }
    void take_back() { --used; }
  };
  mutable tbb::enumerable_thread_specific<Store> stores;

  void add(const SurfaceDistance& surface, const DistanceGridOptions& options);
  void compute(const Index& block, float* values) const;
};

void DistanceGrid::Table::add(const SurfaceDistance& surface, const DistanceGridOptions& options) {
  Vec3 low = surface.mesh().points.front();
  Vec3 high = low;
  for (const Vec3& p : surface.mesh().points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double around = options.padding + cell;
  if (surfaces.empty()) origin = low - Vec3::Constant(around);
  const double side = block_side * cell;
  Index new_first = first;
  Index new_size;
  for (int axis = 0; axis < 3; ++axis) {
    const double from = low[axis] - around - origin[axis];
    const double to = high[axis] + around - origin[axis];
    new_first[axis] = std::min(first[axis], static_cast<int>(std::floor(from / side)));
    new_size[axis] =
        std::max(first[axis] + size[axis], static_cast<int>(std::ceil(to / side)) + 1) -
        new_first[axis];
  }
  blocks.reset();
  stores.clear();
  first = new_first;
  size = new_size;
  const std::size_t count = static_cast<std::size_t>(size[0]) * size[1] * size[2];
  // calloc() gives null pointers, and pages that nobody writes to take no memory.
  void* const memory = std::calloc(count, sizeof(std::atomic<const Block*>));
  if (memory == nullptr) throw std::bad_alloc();
  blocks.reset(static_cast<std::atomic<const Block*>*>(memory));
  surfaces.push_back(std::make_unique<DistanceLevels>(surface, origin, cell, options.band));
  Index first_node;
  Index nodes;
  for (int axis = 0; axis < 3; ++axis) {
    first_node[axis] = block_side * first[axis] - 1;
    nodes[axis] = block_side * size[axis] + 2;
  }
  for (const auto& levels : surfaces) levels->cover(first_node, nodes);
}

void DistanceGrid::Table::compute(const Index& block, float* values) const {
  const Index first_node = {block_side * block[0] - 1, block_side * block[1] - 1,
                            block_side * block[2] - 1};
  surfaces.front()->block_at(first_node, values);
  for (std::size_t s = 1; s < surfaces.size(); ++s) {
    float others[rimmed_nodes];
    surfaces[s]->block_at(first_node, others);
    for (int n = 0; n < rimmed_nodes; ++n) values[n] = std::min(values[n], others[n]);
  }
}

DistanceGrid::DistanceGrid(const SurfaceDistance& body, const DistanceGridOptions& options)
    : DistanceGrid(std::vector{body}, options) {}

DistanceGrid::DistanceGrid(const std::vector<SurfaceDistance>& surfaces,
                           const DistanceGridOptions& options)
    : options_(options), table_(std::make_unique<Table>()) {
  table_->cell = options.cell;
  for (const SurfaceDistance& surface : surfaces) add(surface);
}

DistanceGrid::~DistanceGrid() = default;
DistanceGrid::DistanceGrid(DistanceGrid&&) noexcept = default;
DistanceGrid& DistanceGrid::operator=(DistanceGrid&&) noexcept = default;

void DistanceGrid::add(const SurfaceDistance& surface) {
  table_->add(surface, options_);
  const Index& first = table_->first;
  origin_ = table_->origin + block_side * options_.cell * Vec3(first[0], first[1], first[2]);
  nodes_a_metre_ = 1 / options_.cell;
  blocks_ = table_->size;
}

DistanceCache DistanceGrid::cache() const { return table_->surfaces.front()->cache(); }
std::size_t DistanceGrid::computed_nodes() const {
  return table_->surfaces.front()->computed_nodes();
}
bool DistanceGrid::restore(const DistanceCache& cache) {
  return table_->surfaces.front()->restore(cache);
}

double DistanceGrid::lower_bound(double distance) const {
  return std::abs(distance) <= options_.band
             ? distance
             : DistanceLevels::lower_bound(distance, options_.cell, options_.band);
}

DistanceGrid::Sample DistanceGrid::beyond(const Vec3& point) const {
  if (!point.allFinite()) return {options_.padding, Vec3::Zero()};
  const Vec3 high =
      origin_ +
      options_.cell * (block_side * Vec3(blocks_[0], blocks_[1], blocks_[2]) - Vec3::Ones());
  const Vec3 inside = point.cwiseMax(origin_).cwiseMin(high);
  const Sample there = at(inside);
  const Vec3 from_skin = point - inside + there.distance * there.gradient;
  // The grid's box is convex and holds the body. So the distance is at least the hypotenuse over
  // the distance to the box and the distance from there to the body.
  return {std::hypot(there.distance, (point - inside).norm()), from_skin.normalized()};
}

const DistanceGrid::Block* DistanceGrid::fill(int number) const {
  const Index& size = table_->size;
  const Index block = {number % size[0] + table_->first[0],
                       number / size[0] % size[1] + table_->first[1],
                       number / size[0] / size[1] + table_->first[2]};
  // Two threads may compute the same block. Their values are equal; the first one's block stays.
  Table::Store& store = table_->stores.local();
  Block* const made = store.next();
  table_->compute(block, made->values);
  const Block* found = nullptr;
  if (table_->blocks[number].compare_exchange_strong(found, made, std::memory_order_acq_rel)) {
    return made;
  }
  store.take_back();
  return found;
}

TOILE_CLONES
DistanceGrid::Sample DistanceGrid::at(const Vec3& point) const {
  int block[3];
  int corner[3];
  double weight[3][3];
  double slope[3][3];
  for (int axis = 0; axis < 3; ++axis) {
    const double local = (point[axis] - origin_[axis]) * nodes_a_metre_;
    if (!(local >= -0.5 && local < block_side * blocks_[axis] - 0.5)) return beyond(point);
    const double from_edge = local + 0.5;  // at least 0: the cast rounds down
    const int centre = static_cast<int>(from_edge);
    const double t = local - centre;  // nodes, in [-0.5, 0.5]
    block[axis] = centre / block_side;
    corner[axis] = centre % block_side;  // the spline and the block both begin one node lower
    weight[axis][0] = 0.5 * (0.5 - t) * (0.5 - t);
    weight[axis][1] = 0.75 - t * t;
    weight[axis][2] = 0.5 * (0.5 + t) * (0.5 + t);
    slope[axis][0] = t - 0.5;
    slope[axis][1] = -2 * t;
    slope[axis][2] = t + 0.5;
  }
  const int number = (block[2] * blocks_[1] + block[1]) * blocks_[0] + block[0];
  const Block* found = table_->blocks[number].load(std::memory_order_acquire);
  if (found == nullptr) found = fill(number);
  const float* row =
      &found->values[static_cast<std::size_t>(corner[2] * rimmed_side + corner[1]) * rimmed_side];
  // Sums over y and z for four neighbours along x at a time. The spline needs three of them.
  Vec4 value = {0, 0, 0, 0};
  Vec4 along_y = {0, 0, 0, 0};
  Vec4 along_z = {0, 0, 0, 0};
  for (int c = 0; c < 3; ++c) {
    Vec4 sum = {0, 0, 0, 0};
    Vec4 rise = {0, 0, 0, 0};
    for (int b = 0; b < 3; ++b) {
      const float* const stored = &row[static_cast<std::size_t>(c * rimmed_side + b) * rimmed_side];
      const Vec4 values = __builtin_convertvector(*reinterpret_cast<const Four*>(stored), Vec4);
      sum += weight[1][b] * values;
      rise += slope[1][b] * values;
    }
    value += weight[2][c] * sum;
    along_y += weight[2][c] * rise;
    along_z += slope[2][c] * sum;
  }
  if (corner[0] != 0) {
    value = __builtin_shufflevector(value, value, 1, 2, 3, 3);
    along_y = __builtin_shufflevector(along_y, along_y, 1, 2, 3, 3);
    along_z = __builtin_shufflevector(along_z, along_z, 1, 2, 3, 3);
  }
  const auto across = [](const Vec4& of, const double(&by)[3]) {
    return by[0] * of[0] + by[1] * of[1] + by[2] * of[2];
  };
  Sample sample{across(value, weight[0]),
                {across(value, slope[0]), across(along_y, weight[0]), across(along_z, weight[0])}};
  sample.gradient *= nodes_a_metre_;
  return sample;
}

}  // namespace toile
