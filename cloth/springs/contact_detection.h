// Which contacts a step has: by the incident rays of the paper, and by the nearest points.
#pragma once

#include <vector>

#include "cloth/springs/collision_candidates.h"
#include "cloth/springs/contact.h"
#include "cloth/springs/subject_collisions.h"

namespace toile {

/// What detection knows of a step.
struct CollisionStep {
  const SubjectSurface& subject;
  const std::vector<ClothTriangle>& cloth;
  const std::vector<Vec3>& x;               ///< metres, per node
  const std::vector<Vec3>& before;          ///< m/s, before any response
  const std::vector<double>& inverse_mass;  ///< 1/kg
  double dt;                                ///< s
  const CollisionOptions& options;
  double behind_depth;  ///< metres that a node may be behind the surface and still be let out
};

/// m/s along the normal that a point `distance` metres from the surface needs. It may come down to
/// the gap (metres) within the step. A nearer point is let out.
double min_speed(const CollisionStep& step, double distance, double gap);

/// The contacts of one node: at most the four nearest.
struct NodeContacts {
  int count = 0;
  std::array<Contact<1>, 4> contacts;
  double solve(double friction, std::vector<Vec3>& v);
};

/// Contacts of corner `corner` of triangle `t`, nearest first. `clear` is lowered to the distance
/// of the nearest thing in front, metres.
NodeContacts node_contacts(const CollisionStep& step, int t, int corner, const NearTriangle& near,
                           double moved, double reach, double& clear);

/// Appends edges and triangles within `reach` that approach the subject faster than they may at
/// velocities `v`. `clear` is lowered as by node_contacts().
struct PairContacts {
  std::vector<Contact<2>> edges;
  std::vector<Contact<3>> vertices;
};
void pair_contacts(const CollisionStep& step, int t, const NearTriangle& near, double moved,
                   double reach, const std::vector<Vec3>& v, double slack, PairContacts& found,
                   double& clear);

}  // namespace toile
