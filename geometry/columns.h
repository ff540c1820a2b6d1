// Four vectors at a time, for inner loops: their x components, their y components, their z
// components. Each lane gives the same bits as the same steps on one vector.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "geometry/vec4.h"

namespace toile {

struct Columns {
  Vec4 x;
  Vec4 y;
  Vec4 z;
};

/// The vectors a, b, c and d as columns. `fourth` receives their fourth components, if asked for.
[[gnu::always_inline]] inline Columns columns_of(const Vec4& a, const Vec4& b, const Vec4& c,
                                                 const Vec4& d, Vec4* fourth = nullptr) {
  const Vec4 ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6);   // ax bx az bz
  const Vec4 ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);  // ay by aw bw
  const Vec4 cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Vec4 cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  if (fourth != nullptr) *fourth = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
  return {__builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5),
          __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5),
          __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7)};
}

/// Stores the four vectors, each at its index, with 0 as the fourth component.
[[gnu::always_inline]] inline void store_rows(const Columns& c, Vec4* out, const int (&at)[4]) {
  const Vec4 zero = {0, 0, 0, 0};
  const Vec4 xy_low = __builtin_shufflevector(c.x, c.y, 0, 4, 2, 6);   // x0 y0 x2 y2
  const Vec4 xy_high = __builtin_shufflevector(c.x, c.y, 1, 5, 3, 7);  // x1 y1 x3 y3
  const Vec4 zw_low = __builtin_shufflevector(c.z, zero, 0, 4, 2, 6);
  const Vec4 zw_high = __builtin_shufflevector(c.z, zero, 1, 5, 3, 7);
  out[at[0]] = __builtin_shufflevector(xy_low, zw_low, 0, 1, 4, 5);
  out[at[1]] = __builtin_shufflevector(xy_high, zw_high, 0, 1, 4, 5);
  out[at[2]] = __builtin_shufflevector(xy_low, zw_low, 2, 3, 6, 7);
  out[at[3]] = __builtin_shufflevector(xy_high, zw_high, 2, 3, 6, 7);
}

[[gnu::always_inline]] inline Vec4 dot(const Columns& a, const Columns& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[gnu::always_inline]] inline Columns operator+(const Columns& a, const Columns& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[gnu::always_inline]] inline Columns operator-(const Columns& a, const Columns& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// Each vector times its own factor.
[[gnu::always_inline]] inline Columns operator*(const Vec4& factors, const Columns& a) {
  return {factors * a.x, factors * a.y, factors * a.z};
}

[[gnu::always_inline]] inline Vec4 square_root(const Vec4& a) {
  Vec4 root;
  for (int i = 0; i < 4; ++i) root[i] = __builtin_sqrt(a[i]);
  return root;
}

[[gnu::always_inline]] inline Vec4 larger(const Vec4& a, const Vec4& b) { return a > b ? a : b; }
[[gnu::always_inline]] inline Vec4 smaller(const Vec4& a, const Vec4& b) { return a < b ? a : b; }

[[gnu::always_inline]] inline Vec4 repeated(double number) {
  return Vec4{number, number, number, number};
}

/// Four places in arrays, from `begin` on. Those from `end` on are the last one before it.
class Places {
 public:
  Places(std::size_t begin, std::size_t end) {
    for (std::size_t i = 0; i < 4; ++i) at_[i] = std::min(begin + i, end - 1);
    all_ = end - begin >= 4;
  }
  std::size_t operator[](std::size_t lane) const { return at_[lane]; }
  /// The numbers there.
  [[gnu::always_inline]] Vec4 of(const std::vector<double>& numbers) const {
    const double* const from = numbers.data();
    if (all_) return *reinterpret_cast<const Stored*>(from + at_[0]);
    return Vec4{from[at_[0]], from[at_[1]], from[at_[2]], from[at_[3]]};
  }
  /// Sets the numbers there; of lanes with the same place, the first one counts.
  [[gnu::always_inline]] void set(std::vector<double>& numbers, const Vec4& to) const {
    double* const first = numbers.data();
    if (all_) {
      *reinterpret_cast<Stored*>(first + at_[0]) = to;
    } else {
      for (int i = 3; i >= 0; --i) first[at_[i]] = to[i];
    }
  }
  /// The vectors there, as columns.
  [[gnu::always_inline]] Columns of(const Vec4s& vectors, Vec4* fourth = nullptr) const {
    return columns_of(vectors[at_[0]], vectors[at_[1]], vectors[at_[2]], vectors[at_[3]], fourth);
  }

 private:
  /// Four doubles in a row, as stored.
  using Stored = double __attribute__((vector_size(32), aligned(8), may_alias));

  std::size_t at_[4];
  bool all_;  // no place comes twice
};

/// The vectors that are longer than `longest`, shortened to it; the others as they are. The
/// square root is taken only where there is such a one.
[[gnu::always_inline]] inline Columns shortened(const Columns& a, double longest) {
  const Vec4 squared = dot(a, a);
  const double limit = longest * longest;
  const auto is_long = squared > limit;
  if ((is_long[0] | is_long[1] | is_long[2] | is_long[3]) == 0) return a;
  const Vec4 factor = longest / square_root(squared);
  return {is_long ? factor * a.x : a.x, is_long ? factor * a.y : a.y, is_long ? factor * a.z : a.z};
}

}  // namespace toile
