// The rays that announce a collision: what moves, along its velocity, against what stands still.
#pragma once

#include <array>
#include <optional>

#include "geometry/types.h"

namespace toile {

/// Metres along the ray (x, v) of a garment particle to the subject's triangle abc, from either
/// side, borders included. Nothing where it misses, or v is 0 or parallel to the triangle.
std::optional<double> particle_ray(const Vec3& x, const Vec3& v, const Vec3& a, const Vec3& b,
                                   const Vec3& c);

/// Where the ray (Q, -v_G) of a subject vertex meets a garment triangle [Zhong & Xu 2009, fig. 6].
struct VertexHit {
  std::array<double, 3> weights;  ///< barycentric, of P4
  double distance;                ///< metres, |Q P4|
};
std::optional<VertexHit> vertex_ray(const Vec3& q, const Vec3& v_g, const Vec3& p1, const Vec3& p2,
                                    const Vec3& p3);

/// Where the garment edge P1P2, swept along v_G, meets the subject's edge Q1Q2. Q3 is where Q1Q2
/// goes through the plane of P1P2 and v_G. P3 is where the ray (Q3, -v_G) meets P1P2 [Zhong & Xu
/// 2009, fig. 7].
struct EdgeHit {
  double w1;        ///< |P1 P3| / |P1 P2|
  double w2;        ///< |Q1 Q3| / |Q1 Q2|
  double distance;  ///< metres, |Q3 P3|
};
std::optional<EdgeHit> edge_sweep(const Vec3& p1, const Vec3& p2, const Vec3& v_g, const Vec3& q1,
                                  const Vec3& q2);

}  // namespace toile
