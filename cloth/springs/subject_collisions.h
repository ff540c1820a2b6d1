// Collisions of the mass-spring cloth with the motionless subject: found, and answered by impulses.
#pragma once

#include <memory>
#include <vector>

#include "geometry/types.h"

namespace toile {

struct CollisionOptions {
  double tolerance = 0.002;  ///< xi of the particles, metres, above 0: also the gap they keep
  /// xi of edges and of triangles over the subject's vertices, metres, above 0, at most
  /// `tolerance`. It is smaller because edges cut the corners of a convex body. So the nodes carry
  /// the cloth, which is cheaper by far. They hold edges and triangles off unless something sharp
  /// comes between nodes. A chord of 1 cm loses 1 mm where the radius is 12 mm.
  double edge_tolerance = 0.001;
  double restitution = 0;        ///< lambda, in [0, 1]
  double friction = 0;           ///< Coulomb's; 0 while wrapping and sewing
  double slowest_bounce = 0.01;  ///< m/s; a slower approach does not bounce, so that cloth can rest
  double let_out_speed = 0.05;   ///< m/s, at most, of what is nearer than the gap, outward
};

/// How many collisions got an impulse.
struct CollisionCounts {
  long particle_facet = 0;
  long vertex_triangle = 0;
  long edge_edge = 0;
};

/// Detection and response, once a time step [Zhong & Xu 2009, 'Collision detection and response',
/// figs 6 and 7; Bridson, Fedkiw & Anderson 2002].
///
/// The paper's incident rays announce a collision within the tolerance, or within the path of a
/// step where that is longer. The rays say nothing of cloth that rests (v = 0) or moves along the
/// surface. There the nearest points decide: the cloth may come as near as the tolerance, which is
/// its gap, and no nearer. Nearer cloth is let out slowly.
///
/// Impulses of all collisions are found together by Gauss-Seidel sweeps in fixed order, each share
/// (w_i/m_i) / (sum of w_j^2/m_j). Coulomb's friction is bounded by the sum of a collision's normal
/// impulses, so cloth that sticks does not creep. Last, velocities are cut where a step is long
/// against the distance left. So no node, edge or triangle can pass through in one step.
///
/// A node up to 5 mm behind the nearest point of the surface is let out. A deeper one is not
/// detected.
class SubjectCollisions {
 public:
  /// `subject`: the closed body and open sheets, outward-oriented, one mesh; a copy is kept.
  /// `triangles`: of the cloth's nodes. Throws Error for a subject without area or with points
  /// that are not finite.
  SubjectCollisions(const TriangleMesh& subject, const std::vector<Triangle>& triangles);
  ~SubjectCollisions();
  SubjectCollisions(SubjectCollisions&&) noexcept;
  SubjectCollisions& operator=(SubjectCollisions&&) noexcept;

  /// Sets new triangles of the cloth, for instance when nodes of a seam were merged. Lists of
  /// unchanged triangles stay valid.
  void set_cloth(const std::vector<Triangle>& triangles);

  /// Changes the velocities v (m/s) so that moving x (m) by dt·v (s) collides with nothing. All per
  /// node; inverse_mass in 1/kg, 0 for a node that is held. Nodes of no triangle are left alone.
  /// The same bits for any number of threads.
  CollisionCounts respond(const std::vector<Vec3>& x, const std::vector<double>& inverse_mass,
                          double dt, const CollisionOptions& options, std::vector<Vec3>& v);

 private:
  class Response;
  std::unique_ptr<Response> response_;
};

}  // namespace toile
