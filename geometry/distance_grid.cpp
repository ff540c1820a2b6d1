#include "geometry/distance_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/distance_levels.h"
#include "geometry/node_values.h"
#include "geometry/vec4.h"

namespace toile {

namespace {

/// Nodes along each axis that the spline at a point needs.
constexpr int spline_side = 3;
/// The grid's box begins and ends at a multiple of so many cells.
constexpr int box_step = 2;

using Index = NodeValues::Index;

/// Four neighbours along x, as stored.
using Four = float __attribute__((vector_size(16), aligned(4), may_alias));
using FourMasks = int __attribute__((vector_size(16)));

}  // namespace

/// The distances at the nodes.
struct DistanceGrid::Table {
  Vec3 origin;  // metres: node 0
  std::vector<std::unique_ptr<DistanceLevels>> surfaces;
  std::unique_ptr<NodeValues> least;  // metres: of several surfaces, the least distance
  const NodeValues* nodes = nullptr;  // those that lookups read
  Index first = {0, 0, 0};            // the first node that a lookup may be nearest to
  Index size = {0, 0, 0};             // the number of such nodes along each axis
  std::size_t first_place = 0;        // of the first node that the spline there needs

  void add(const SurfaceDistance& surface, const DistanceGridOptions& options);
  void compute_around(const Index& centre) const;
};

void DistanceGrid::Table::add(const SurfaceDistance& surface, const DistanceGridOptions& options) {
  Vec3 low = surface.mesh().points.front();
  Vec3 high = low;
  for (const Vec3& p : surface.mesh().points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double around = options.padding + options.cell;
  if (surfaces.empty()) origin = low - Vec3::Constant(around);
  const double step = box_step * options.cell;
  Index covered_first;
  Index covered_size;
  for (int axis = 0; axis < 3; ++axis) {
    const double from = low[axis] - around - origin[axis];
    const double to = high[axis] + around - origin[axis];
    const int own_first = box_step * static_cast<int>(std::floor(from / step));
    const int own_end = box_step * (static_cast<int>(std::ceil(to / step)) + 1);
    const int end = std::max(first[axis] + size[axis], own_end);
    first[axis] = std::min(first[axis], own_first);
    size[axis] = end - first[axis];
    // The spline reaches one node farther.
    covered_first[axis] = first[axis] - 1;
    covered_size[axis] = size[axis] + 2;
  }
  surfaces.push_back(std::make_unique<DistanceLevels>(surface, origin, options.cell, options.band));
  for (const auto& levels : surfaces) levels->cover(covered_first, covered_size);
  nodes = &surfaces.front()->nodes();
  first_place = nodes->place(covered_first);
  if (surfaces.size() < 2) return;
  least = std::make_unique<NodeValues>(nodes->first(), nodes->size());
  nodes = least.get();
}

/// Computes the nodes that the spline around one needs.
void DistanceGrid::Table::compute_around(const Index& centre) const {
  for (int k = -1; k <= 1; ++k) {
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        const Index node = {centre[0] + i, centre[1] + j, centre[2] + k};
        const std::size_t place = nodes->place(node);
        float smallest = std::numeric_limits<float>::max();
        for (const auto& levels : surfaces) {
          if (levels->nodes().load(place) == 0) levels->compute_cube(node);
          smallest = std::min(smallest, levels->nodes().load(place));
        }
        if (least) least->store(place, smallest);
      }
    }
  }
}

DistanceGrid::DistanceGrid(const SurfaceDistance& body, const DistanceGridOptions& options)
    : DistanceGrid(std::vector{body}, options) {}

DistanceGrid::DistanceGrid(const std::vector<SurfaceDistance>& surfaces,
                           const DistanceGridOptions& options)
    : options_(options), table_(std::make_unique<Table>()) {
  for (const SurfaceDistance& surface : surfaces) add(surface);
}

DistanceGrid::~DistanceGrid() = default;
DistanceGrid::DistanceGrid(DistanceGrid&&) noexcept = default;
DistanceGrid& DistanceGrid::operator=(DistanceGrid&&) noexcept = default;

void DistanceGrid::add(const SurfaceDistance& surface) {
  table_->add(surface, options_);
  const Index& first = table_->first;
  origin_ = table_->origin + options_.cell * Vec3(first[0], first[1], first[2]);
  nodes_a_metre_ = 1 / options_.cell;
  size_ = table_->size;
}

DistanceCache DistanceGrid::cache() const { return table_->surfaces.front()->cache(); }
std::size_t DistanceGrid::computed_nodes() const {
  return table_->surfaces.front()->computed_nodes();
}
bool DistanceGrid::restore(DistanceCache cache) {
  return table_->surfaces.front()->restore(std::move(cache));
}
std::size_t DistanceGrid::restored_nodes() const {
  return table_->surfaces.front()->restored_nodes();
}

double DistanceGrid::lower_bound(double distance) const {
  return std::abs(distance) <= options_.band
             ? distance
             : DistanceLevels::lower_bound(distance, options_.cell, options_.band);
}

DistanceGrid::Sample DistanceGrid::beyond(const Vec3& point) const {
  if (!point.allFinite()) return {options_.padding, Vec3::Zero()};
  const Vec3 high = origin_ + options_.cell * (Vec3(size_[0], size_[1], size_[2]) - Vec3::Ones());
  const Vec3 inside = point.cwiseMax(origin_).cwiseMin(high);
  const Sample there = at(inside);
  const Vec3 from_skin = point - inside + there.distance * there.gradient;
  // The grid's box is convex and holds the body. So the distance is at least the hypotenuse over
  // the distance to the box and the distance from there to the body.
  return {std::hypot(there.distance, (point - inside).norm()), from_skin.normalized()};
}

TOILE_CLONES
DistanceGrid::Sample DistanceGrid::at(const Vec3& point) const {
  int centre[3];  // the nearest node, from the first one
  double weight[3][3];
  double slope[3][3];
  for (int axis = 0; axis < 3; ++axis) {
    const double local = (point[axis] - origin_[axis]) * nodes_a_metre_;
    if (!(local >= -0.5 && local < size_[axis] - 0.5)) return beyond(point);
    const double from_edge = local + 0.5;  // at least 0: the cast rounds down
    centre[axis] = static_cast<int>(from_edge);
    const double t = local - centre[axis];  // nodes, in [-0.5, 0.5]
    weight[axis][0] = 0.5 * (0.5 - t) * (0.5 - t);
    weight[axis][1] = 0.75 - t * t;
    weight[axis][2] = 0.5 * (0.5 + t) * (0.5 + t);
    slope[axis][0] = t - 0.5;
    slope[axis][1] = -2 * t;
    slope[axis][2] = t + 0.5;
  }
  const NodeValues& nodes = *table_->nodes;
  const std::size_t row = nodes.size()[0];
  const std::size_t slice = row * nodes.size()[1];
  const float* const corner =
      nodes.data() + table_->first_place + centre[2] * slice + centre[1] * row + centre[0];
  // Four neighbours along x at a time. The spline needs three of them.
  Four stored[spline_side * spline_side];
  FourMasks unknown = {0, 0, 0, 0};
  for (std::size_t c = 0; c < spline_side; ++c) {
    for (std::size_t b = 0; b < spline_side; ++b) {
      Four& four = stored[c * spline_side + b];
      four = *reinterpret_cast<const Four*>(corner + c * slice + b * row);
      unknown |= four == 0;
    }
  }
  if ((unknown[0] | unknown[1] | unknown[2]) != 0) {
    const Index& first = table_->first;
    table_->compute_around({first[0] + centre[0], first[1] + centre[1], first[2] + centre[2]});
    return at(point);
  }
  Vec4 value = {0, 0, 0, 0};
  Vec4 along_y = {0, 0, 0, 0};
  Vec4 along_z = {0, 0, 0, 0};
  for (int c = 0; c < spline_side; ++c) {
    Vec4 sum = {0, 0, 0, 0};
    Vec4 rise = {0, 0, 0, 0};
    for (int b = 0; b < spline_side; ++b) {
      const Vec4 values = __builtin_convertvector(stored[c * spline_side + b], Vec4);
      sum += weight[1][b] * values;
      rise += slope[1][b] * values;
    }
    value += weight[2][c] * sum;
    along_y += weight[2][c] * rise;
    along_z += slope[2][c] * sum;
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
