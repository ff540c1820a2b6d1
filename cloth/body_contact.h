// What the body does to the cloth: it keeps it off, holds it by friction, and draws it near while
// it is wrapped.
#pragma once

#include "cloth/scene.h"
#include "geometry/types.h"

namespace toile {

/// A force on one vertex of the cloth, and a bound of its stiffness.
struct VertexForce {
  Vec3 force = Vec3::Zero();  ///< N
  double stiffness = 0;       ///< N/m
};

/// One vertex of the cloth against the body, through a run.
class BodyContact {
 public:
  /// Counts a move of the vertex, metres, against the clearance that is known.
  void moved(double distance) { clearance_ -= distance; }

  /// The force on the vertex at `p`: a push out of the body and `offset` (metres) away from it, and
  /// Coulomb's friction (coefficient `friction`; 0: none) as a spring to the place where the vertex
  /// stuck, which slides along when it pulls too hard. Asks the body only where the vertex may have
  /// come near since it was last asked. The scene has a body.
  VertexForce force(const Scene& scene, const Vec3& p, double offset, double friction);

 private:
  double clearance_ = 0;  // metres the vertex may move before the body has to be asked again
  Vec3 anchor_ = Vec3::Zero();
  bool anchored_ = false;
};

/// The force that draws a vertex of weight `weight` (N) at `p` toward the skin: that weight from
/// 5 cm on, less nearer by [Zhong & Xu 2009, wrapping: adaptive to the distance].
Vec3 pull_to_body(const Scene& scene, const Vec3& p, double weight);

}  // namespace toile
