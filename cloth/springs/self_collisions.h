// Collisions of the mass-spring garment with itself.
#pragma once

#include <vector>

#include "cloth/contact/proximity.h"
#include "cloth/model/garment_model.h"
#include "geometry/types.h"

namespace toile {

/// Keeps the cloth's points and edges `gap` metres from its other triangles and edges, by impulses
/// on their velocities [Bridson et al. 2002]. It also bounds every move: things that are apart stay
/// apart, whatever the velocities. `model` has to outlive it.
class SelfCollisions {
 public:
  SelfCollisions(const GarmentModel& model, double gap);

  /// Leaves neighbours across a seam out, of the bounds too: while seams close, they have to come
  /// past each other. This is how it begins.
  void leave_out_neighbours(bool leave_out);

  /// Changes velocities so that no pair of points comes nearer than the gap. A pair that is nearer
  /// already comes no nearer and is let out. `node` holds the node of each material point; the
  /// other arrays are per node. Merged points have to be where their nodes are.
  void respond(const std::vector<Vec3>& x, const std::vector<int>& node,
               const std::vector<double>& inverse_mass, double dt, std::vector<Vec3>& v);

  /// Shortens the moves dt·v that exceed what is known to be free. To be called after respond().
  void bound(const std::vector<Vec3>& x, const std::vector<int>& node, double dt,
             std::vector<Vec3>& v);

  long searches() const { return searches_; }

 private:
  void search(const std::vector<Vec3>& x);

  ProximitySearch proximity_;
  double gap_;
  double radius_;
  bool leave_out_ = true;
  std::vector<ContactPair> pairs_;
  std::vector<double> bound_;  // metres from searched_, per material point
  std::vector<Vec3> searched_;
  int since_search_ = 0;
  long searches_ = 0;
};

}  // namespace toile
