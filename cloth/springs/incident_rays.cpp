#include "cloth/springs/incident_rays.h"

#include <Eigen/Geometry>
#include <cmath>

namespace toile {

namespace {

/// Sine of the angle below which a direction counts as parallel to an edge or a triangle.
constexpr double parallel = 1e-9;

/// How far along `direction`, in its lengths, and the weights of b and c [Moeller & Trumbore 1997].
std::optional<Vec3> meet(const Vec3& from, const Vec3& direction, const Vec3& a, const Vec3& b,
                         const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 across = direction.cross(ac);
  const double volume = ab.dot(across);
  const double flat = parallel * direction.norm() * ab.cross(ac).norm();
  if (!(std::abs(volume) > flat)) return std::nullopt;
  const Vec3 away = from - a;
  const double of_b = away.dot(across) / volume;
  if (of_b < 0 || of_b > 1) return std::nullopt;
  const Vec3 other = away.cross(ab);
  const double of_c = direction.dot(other) / volume;
  if (of_c < 0 || of_b + of_c > 1) return std::nullopt;
  const double along = ac.dot(other) / volume;
  if (along < 0) return std::nullopt;
  return Vec3(along, of_b, of_c);
}

}  // namespace

std::optional<double> particle_ray(const Vec3& x, const Vec3& v, const Vec3& a, const Vec3& b,
                                   const Vec3& c) {
  const auto hit = meet(x, v, a, b, c);
  if (!hit) return std::nullopt;
  return (*hit)[0] * v.norm();
}

std::optional<VertexHit> vertex_ray(const Vec3& q, const Vec3& v_g, const Vec3& p1, const Vec3& p2,
                                    const Vec3& p3) {
  const auto hit = meet(q, -v_g, p1, p2, p3);
  if (!hit) return std::nullopt;
  return VertexHit{{1 - (*hit)[1] - (*hit)[2], (*hit)[1], (*hit)[2]}, (*hit)[0] * v_g.norm()};
}

std::optional<EdgeHit> edge_sweep(const Vec3& p1, const Vec3& p2, const Vec3& v_g, const Vec3& q1,
                                  const Vec3& q2) {
  const Vec3 p = p2 - p1;
  const Vec3 q = q2 - q1;
  const Vec3 plane = p.cross(v_g);
  const double steep = q.dot(plane);
  if (!(std::abs(steep) > parallel * q.norm() * p.norm() * v_g.norm())) return std::nullopt;
  const double w2 = (p1 - q1).dot(plane) / steep;
  if (w2 < 0 || w2 > 1) return std::nullopt;
  // Q3 - s v_G = P1 + w1 (P2 - P1), all in one plane: s and w1 by crossing out the other.
  const Vec3 away = q1 + w2 * q - p1;
  const double area = plane.squaredNorm();
  const double w1 = away.cross(v_g).dot(plane) / area;
  if (w1 < 0 || w1 > 1) return std::nullopt;
  // away = w1 p + s v_G: p x away = s p x v_G.
  const double s = p.cross(away).dot(plane) / area;
  if (s < 0) return std::nullopt;
  return EdgeHit{w1, w2, s * v_g.norm()};
}

}  // namespace toile
