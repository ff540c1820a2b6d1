#include "geometry/triangle_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "geometry/closest_points.h"
#include "geometry/parallel.h"
#include "geometry/vec4.h"

namespace toile {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
/// Share of the largest coordinate: an ample bound for the rounding error of a distance.
constexpr double rounding = 1e-6;

/// A number for each of the eight boxes.
using Lanes = float __attribute__((vector_size(32)));
using LaneMasks = int __attribute__((vector_size(32)));

[[gnu::always_inline]] inline const Lanes& lanes(const float (&eight)[8]) {
  return *reinterpret_cast<const Lanes*>(eight);
}

/// A bit for each lane whose mask is set.
[[gnu::always_inline]] inline unsigned bits_of(const LaneMasks& masks) {
  LaneMasks bits = masks & LaneMasks{1, 2, 4, 8, 16, 32, 64, 128};
  bits |= __builtin_shufflevector(bits, bits, 4, 5, 6, 7, 0, 1, 2, 3);
  bits |= __builtin_shufflevector(bits, bits, 2, 3, 0, 1, 6, 7, 4, 5);
  bits |= __builtin_shufflevector(bits, bits, 1, 0, 3, 2, 5, 4, 7, 6);
  return static_cast<unsigned>(bits[0]);
}

float rounded_down(double value) {
  const auto near = static_cast<float>(value);
  return near > value ? std::nextafter(near, -infinite) : near;
}
float rounded_up(double value) { return -rounded_down(-value); }

/// A triangle's index and its centroid.
struct Entry {
  Vec3 centroid;
  int triangle;
};

/// Orders the entries so that each run of `run` entries fills a small box. So does each run of
/// every smaller power of two. `run` is a power of two.
void order_entries(Entry* begin, Entry* end, std::ptrdiff_t run) {
  constexpr std::ptrdiff_t worth_a_thread = 4096;
  while (run > 1 && end - begin <= run / 2) run /= 2;
  if (run <= 1) return;
  Vec3 low = begin->centroid;
  Vec3 high = low;
  for (const Entry* entry = begin; entry != end; ++entry) {
    low = low.cwiseMin(entry->centroid);
    high = high.cwiseMax(entry->centroid);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  Entry* const middle = begin + run / 2;
  std::nth_element(begin, middle, end, [axis](const Entry& a, const Entry& b) {
    return a.centroid[axis] != b.centroid[axis] ? a.centroid[axis] < b.centroid[axis]
                                                : a.triangle < b.triangle;
  });
  if (end - begin < worth_a_thread) {
    order_entries(begin, middle, run / 2);
    order_entries(middle, end, run / 2);
  } else {
    parallel_invoke([=] { order_entries(begin, middle, run / 2); },
                    [=] { order_entries(middle, end, run / 2); });
  }
}

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_(mesh) {
  for (const Vec3& p : mesh.points) largest_ = std::max(largest_, p.cwiseAbs().maxCoeff());
  std::vector<Entry> entries(mesh.triangles.size());
  parallel_for_items(entries.size(), [&](std::size_t t) {
    const Triangle& c = mesh.triangles[t];
    entries[t] = {(mesh.points[c[0]] + mesh.points[c[1]] + mesh.points[c[2]]) / 3,
                  static_cast<int>(t)};
  });
  std::ptrdiff_t run = 1;
  while (run < static_cast<std::ptrdiff_t>(entries.size())) run *= 2;
  order_entries(entries.data(), entries.data() + entries.size(), run);
  order_.resize(entries.size());

  Boxes none;
  std::fill_n(&none.low[0][0], 3 * width, infinite);
  std::fill_n(&none.high[0][0], 3 * width, -infinite);
  const auto eights = [](std::size_t count) { return (count + width - 1) / width; };
  levels_.emplace_back(eights(order_.size()), none);
  parallel_for_items(order_.size(), [&](std::size_t i) {
    order_[i] = entries[i].triangle;
    Boxes& boxes = levels_.front()[i / width];
    const Triangle& corners = mesh_.triangles[order_[i]];
    for (int axis = 0; axis < 3; ++axis) {
      const auto [min, max] =
          std::minmax({mesh_.points[corners[0]][axis], mesh_.points[corners[1]][axis],
                       mesh_.points[corners[2]][axis]});
      boxes.low[axis][i % width] = rounded_down(min);
      boxes.high[axis][i % width] = rounded_up(max);
    }
  });
  while (levels_.back().size() > 1) {
    std::vector<Boxes> above(eights(levels_.back().size()), none);
    for (std::size_t i = 0; i < levels_.back().size(); ++i) {
      const Boxes& below = levels_.back()[i];
      for (int axis = 0; axis < 3; ++axis) {
        above[i / width].low[axis][i % width] =
            *std::min_element(below.low[axis], below.low[axis] + width);
        above[i / width].high[axis][i % width] =
            *std::max_element(below.high[axis], below.high[axis] + width);
      }
    }
    levels_.push_back(std::move(above));
  }
}

/// A point whose distances to boxes are asked for.
struct TriangleTree::Query {
  Query(const Vec3& point, double largest)
      : at{static_cast<float>(point.x()), static_cast<float>(point.y()),
           static_cast<float>(point.z())},
        slack(rounding * std::max(largest, point.cwiseAbs().maxCoeff())) {}

  /// Squared distances to the eight boxes; infinite where there is no box.
  [[gnu::always_inline]] Lanes measure(const Boxes& boxes) const {
    Lanes sum = {0, 0, 0, 0, 0, 0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes below = lanes(boxes.low[axis]) - at[axis];
      const Lanes above = at[axis] - lanes(boxes.high[axis]);
      Lanes away = below > above ? below : above;
      away = away > 0 ? away : Lanes{0, 0, 0, 0, 0, 0, 0, 0};
      sum += away * away;
    }
    return sum;
  }
  /// An upper bound of measure() for boxes that hold a point within `distance`.
  float limit(double distance) const { return rounded_up((distance + slack) * (distance + slack)); }

  float at[3];
  double slack;
};

struct TriangleTree::Nearest {
  Query query;
  Vec3 point;
  double squared = std::numeric_limits<double>::infinity();
  float limit = infinite;
  int triangle = 0;

  void consider(const TriangleMesh& mesh, int t) {
    const Triangle& corners = mesh.triangles[t];
    const Vec3& a = mesh.points[corners[0]];
    const Vec3& b = mesh.points[corners[1]];
    const Vec3& c = mesh.points[corners[2]];
    const Vec3 weights = closest_on_triangle(point, a, b, c);
    const double away = (weights[0] * a + weights[1] * b + weights[2] * c - point).squaredNorm();
    // Of several equally close triangles it takes the first, in whatever order they come.
    if (away < squared || (away == squared && t < triangle)) {
      squared = away;
      limit = query.limit(std::sqrt(away));
      triangle = t;
    }
  }
};

TOILE_CLONES
void TriangleTree::search(std::size_t level, std::size_t number, Nearest& nearest) const {
  const Lanes distances = nearest.query.measure(levels_[level][number]);
  unsigned left = bits_of(distances < nearest.limit);
  if (left == 0) return;
  alignas(Lanes) float squared[width];
  *reinterpret_cast<Lanes*>(squared) = distances;
  while (left != 0) {
    // The closest of the eight boxes comes first: its triangles rule out most of the others.
    int next = std::countr_zero(left);
    for (unsigned others = left & (left - 1); others != 0; others &= others - 1) {
      const int other = std::countr_zero(others);
      next = squared[other] < squared[next] ? other : next;
    }
    if (!(squared[next] < nearest.limit)) return;
    left &= ~(1U << static_cast<unsigned>(next));
    const std::size_t child = number * width + static_cast<std::size_t>(next);
    if (level > 0) {
      search(level - 1, child, nearest);
    } else {
      nearest.consider(mesh_, order_[child]);
    }
  }
}

int TriangleTree::closest_triangle(const Vec3& point, int hint) const {
  Nearest nearest{Query(point, largest_), point};
  if (hint >= 0) nearest.consider(mesh_, hint);
  search(levels_.size() - 1, 0, nearest);
  return nearest.triangle;
}

TOILE_CLONES
void TriangleTree::collect(std::size_t level, std::size_t number, const FloatBox& box,
                           std::vector<int>& found) const {
  const Boxes& boxes = levels_[level][number];
  LaneMasks met = {-1, -1, -1, -1, -1, -1, -1, -1};
  for (int axis = 0; axis < 3; ++axis) {
    met &= lanes(boxes.low[axis]) <= box.high[axis];
    met &= lanes(boxes.high[axis]) >= box.low[axis];
  }
  for (unsigned left = bits_of(met); left != 0; left &= left - 1) {
    const std::size_t child = number * width + static_cast<std::size_t>(std::countr_zero(left));
    if (level > 0) {
      collect(level - 1, child, box, found);
    } else {
      found.push_back(order_[child]);
    }
  }
}

void TriangleTree::meeting(const Vec3& low, const Vec3& high, std::vector<int>& found) const {
  FloatBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = rounded_down(low[axis]);
    box.high[axis] = rounded_up(high[axis]);
  }
  collect(levels_.size() - 1, 0, box, found);
}

}  // namespace toile
