#include "geometry/triangle_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
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

/// The closest triangle so far.
struct TriangleTree::Nearest {
  Vec3 point;
  double squared = std::numeric_limits<double>::infinity();
  int triangle = 0;

  /// Whether the triangle is closer than those before.
  bool consider(const TriangleMesh& mesh, int t) {
    const Triangle& corners = mesh.triangles[t];
    const Vec3& a = mesh.points[corners[0]];
    const Vec3& b = mesh.points[corners[1]];
    const Vec3& c = mesh.points[corners[2]];
    const Vec3 weights = closest_on_triangle(point, a, b, c);
    const double away = (weights[0] * a + weights[1] * b + weights[2] * c - point).squaredNorm();
    // Of several equally close triangles it takes the first, in whatever order they come.
    const bool closer = away < squared || (away == squared && t < triangle);
    if (!closer) return false;
    squared = away;
    triangle = t;
    return true;
  }
};

struct TriangleTree::Search {
  Query query;
  Nearest nearest;
  float limit = infinite;

  void consider(const TriangleMesh& mesh, int t) {
    if (nearest.consider(mesh, t)) limit = query.limit(std::sqrt(nearest.squared));
  }
};

TOILE_CLONES
void TriangleTree::search(std::size_t level, std::size_t number, Search& found) const {
  const Lanes distances = found.query.measure(levels_[level][number]);
  unsigned left = bits_of(distances < found.limit);
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
    if (!(squared[next] < found.limit)) return;
    left &= ~(1U << static_cast<unsigned>(next));
    const std::size_t child = number * width + static_cast<std::size_t>(next);
    if (level > 0) {
      search(level - 1, child, found);
    } else {
      found.consider(mesh_, order_[child]);
    }
  }
}

int TriangleTree::closest_triangle(const Vec3& point, int hint) const {
  Search found{Query(point, largest_), {point}};
  if (hint >= 0) found.consider(mesh_, hint);
  search(levels_.size() - 1, 0, found);
  return found.nearest.triangle;
}

namespace {

/// Share of the largest coordinate from the middle of some points. It is far above the rounding of
/// distances in single precision. Where several triangles are as close, double precision decides.
constexpr double close_call = 1e-5;
/// The same share. A lower triangle is its sides.
constexpr double least_height = 1e-6;

/// Coordinates of eight points.
struct Points8 {
  Lanes x, y, z;
};

/// Coordinates in single precision.
struct Float3 {
  Float3() = default;
  explicit Float3(const Vec3& p)
      : x(static_cast<float>(p.x())), y(static_cast<float>(p.y())), z(static_cast<float>(p.z())) {}
  float x = 0;
  float y = 0;
  float z = 0;
};
[[gnu::always_inline]] inline Points8 operator-(const Points8& a, const Float3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[gnu::always_inline]] inline Lanes dot(const Points8& a, const Float3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[gnu::always_inline]] inline Lanes smaller(const Lanes& a, const Lanes& b) {
  return a < b ? a : b;
}

/// A triangle as squared distances to it need it.
struct TriangleSides {
  /// `size`: as large as a coordinate can be.
  TriangleSides(const std::array<Vec3, 3>& corners, double size) {
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double length = normal.norm();
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 along = corners[(i + 1) % 3] - corners[i];
      const double square = along.squaredNorm();
      longest = std::max(longest, square);
      corner[i] = Float3(corners[i]);
      side[i] = Float3(along);
      inverse[i] = static_cast<float>(square > 0 ? 1 / square : 0);
      inward[i] = Float3(normal.cross(along));
    }
    flat = length <= least_height * size * std::sqrt(longest);
    if (!flat) up = Float3(normal / length);
  }

  [[gnu::always_inline]] Lanes squared_distance(const Points8& p) const {
    const Lanes zero = {};
    Lanes least = infinite - zero;
    LaneMasks above = {-1, -1, -1, -1, -1, -1, -1, -1};
    for (std::size_t i = 0; i < 3; ++i) {
      const Points8 away = p - corner[i];
      Lanes share = dot(away, side[i]) * inverse[i];
      share = share > zero ? share : zero;
      share = smaller(share, 1 - zero);
      const Lanes x = away.x - share * side[i].x;
      const Lanes y = away.y - share * side[i].y;
      const Lanes z = away.z - share * side[i].z;
      least = smaller(x * x + y * y + z * z, least);
      above &= dot(away, inward[i]) >= zero;
    }
    if (flat) return least;
    const Lanes height = dot(p - corner[0], up);
    return above ? smaller(height * height, least) : least;
  }

  std::array<Float3, 3> corner;
  std::array<Float3, 3> side;    ///< from each corner to the next one
  std::array<float, 3> inverse;  ///< of the sides' squared lengths
  std::array<Float3, 3> inward;  ///< square to each side, in the triangle's plane
  Float3 up;                     ///< the unit normal
  bool flat;
};

}  // namespace

TOILE_CLONES
void TriangleTree::closest_triangles(std::span<const Vec3> points, int hint, int* found) const {
  constexpr std::size_t most_groups = most_points / width;
  Vec3 low = points.front();
  Vec3 high = low;
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3 middle = 0.5 * (low + high);
  Nearest of_middle{middle};
  of_middle.consider(mesh_, closest_triangle(middle, hint));
  // No point is farther from its closest triangle than from the middle's.
  const double reach = (1 + rounding) * (std::sqrt(of_middle.squared) + (high - low).norm());
  std::vector<int> near;
  meeting(middle - Vec3::Constant(reach), middle + Vec3::Constant(reach), near);

  struct alignas(Lanes) Numbers {
    Lanes of[most_groups];  // a number for each point
  };
  const std::size_t groups = (points.size() + width - 1) / width;
  std::array<Points8, most_groups> from_middle;
  for (std::size_t i = 0; i < groups * width; ++i) {
    const Float3 p(points[std::min(i, points.size() - 1)] - middle);
    Points8& group = from_middle[i / width];
    group.x[i % width] = p.x;
    group.y[i % width] = p.y;
    group.z[i % width] = p.z;
  }
  Numbers limit;
  std::fill_n(limit.of, most_groups, infinite - Lanes{});
  std::vector<Numbers> squared(near.size());
  std::size_t count = 0;
  double size = reach;
  for (const int t : near) {
    const Triangle& c = mesh_.triangles[t];
    const std::array<Vec3, 3> corners = {mesh_.points[c[0]] - middle, mesh_.points[c[1]] - middle,
                                         mesh_.points[c[2]] - middle};
    const Vec3 centroid = (corners[0] + corners[1] + corners[2]) / 3;
    const double around = std::sqrt(
        std::max({(corners[0] - centroid).squaredNorm(), (corners[1] - centroid).squaredNorm(),
                  (corners[2] - centroid).squaredNorm()}));
    if (centroid.norm() > reach + around) continue;
    size = std::max(size, reach + 2 * around);
    const TriangleSides triangle(corners, size);
    for (std::size_t g = 0; g < groups; ++g) {
      squared[count].of[g] = triangle.squared_distance(from_middle[g]);
      limit.of[g] = smaller(squared[count].of[g], limit.of[g]);
    }
    near[count++] = t;
  }
  for (std::size_t i = 0; i < groups * width; ++i) {
    float& least = limit.of[i / width][i % width];
    const double farther = std::sqrt(static_cast<double>(least)) + close_call * size;
    least = static_cast<float>(farther * farther);
  }
  std::array<Nearest, most_points> nearest;
  for (std::size_t i = 0; i < points.size(); ++i) nearest[i] = {points[i]};
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t g = 0; g < groups; ++g) {
      for (unsigned left = bits_of(squared[k].of[g] <= limit.of[g]); left != 0; left &= left - 1) {
        const std::size_t i = g * width + static_cast<std::size_t>(std::countr_zero(left));
        if (i < points.size()) nearest[i].consider(mesh_, near[k]);
      }
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) found[i] = nearest[i].triangle;
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
