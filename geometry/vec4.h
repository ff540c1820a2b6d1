// Points as four doubles that one instruction handles, for inner loops.
#pragma once

#include <boost/align/aligned_allocator.hpp>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// x, y, z and 0. It needs a compiler with vector extensions (GCC or Clang).
using Vec4 = double __attribute__((vector_size(32)));

/// Vec4s aligned as the wide instructions expect. A struct that holds a Vec4 says alignas(32) and
/// has the Vec4 first.
using Vec4s = std::vector<Vec4, boost::alignment::aligned_allocator<Vec4, 64>>;

[[gnu::always_inline]] inline Vec4 as_vec4(const Vec3& p) { return Vec4{p.x(), p.y(), p.z(), 0}; }
[[gnu::always_inline]] inline Vec3 as_vec3(const Vec4& p) { return {p[0], p[1], p[2]}; }
[[gnu::always_inline]] inline double dot(const Vec4& a, const Vec4& b) {
  const Vec4 products = a * b;
  return products[0] + products[1] + products[2];
}
[[gnu::always_inline]] inline double squared_length(const Vec4& p) { return dot(p, p); }

inline Vec4s as_vec4(const std::vector<Vec3>& points) {
  Vec4s result;
  result.reserve(points.size());
  for (const Vec3& p : points) result.push_back(as_vec4(p));
  return result;
}

// TOILE_CLONES compiles a function once for each instruction set. All clones give the same bits:
// none may fuse a product and a sum. So everything is compiled with -ffp-contract=off.
// TOILE_ONE_CLONE switches it off for tools that don't know the wide instructions, such as
// valgrind.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(TOILE_ONE_CLONE)
#define TOILE_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define TOILE_CLONES
#endif

}  // namespace toile
