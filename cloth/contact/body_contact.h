// Contact of one vertex of the cloth with the body, or with the floor: push and friction.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "cloth/contact/constants.h"
#include "cloth/scene/scene.h"
#include "geometry/types.h"
#include "geometry/vec4.h"

namespace toile {

/// Contact of one vertex of the cloth with the body, through a run. A plane stands for the body
/// near the vertex, until the vertex has moved on too far. Where the scene's floor is nearer, it is
/// the floor that counts as the body.
class alignas(64) BodyContact {
 public:
  /// Finds the plane that stands for the body near the vertex at `p` (metres). It is parallel to
  /// the skin, `offset` metres off it, and valid within `linearization_radius` metres. Where the
  /// body curves away on both sides, it is valid at `p` only. The contact is stiff, without a push,
  /// within `approach_bound` metres of the plane, by which the vertex may approach in a step. The
  /// scene has a body. With `firm` the push beyond `firm_depth` is firm.
  void linearize(const Scene& scene, const Vec3& p, double offset, double linearization_radius,
                 double approach_bound, bool firm);

  /// Metres that the vertex at `p` may still move before linearize() is due. It is due at 0 and
  /// below.
  double remaining(const Vec3& p) const { return reach_ - (p - linearized_at_).norm(); }

  /// Whether the body is near enough to push within the remaining distance.
  bool near() const { return near_; }

  /// Makes linearize() due. The anchor stays.
  void forget() { reach_ = -1; }

  /// N/m: a bound of the stiffness that add() adds where a plane stands for the body, and the
  /// vertex is no deeper than `firm_depth`.
  static constexpr double max_stiffness = body_push_stiffness + body_friction_stiffness;

  /// The point (metres) that friction holds the vertex to; none where it does not stick.
  std::optional<Vec3> anchor() const {
    return anchored_ ? std::optional<Vec3>(as_vec3(anchor_)) : std::nullopt;
  }
  /// Makes the vertex stick to `anchor` (metres), instead of to where it first touches the body.
  void set_anchor(const Vec3& anchor) {
    anchored_ = true;
    anchor_ = as_vec4(anchor);
  }

  /// Adds the force (N) on the vertex at `p` (metres), and a bound of its stiffness (N/m). The push
  /// grows with the depth, and beyond `firm_depth` `firm_push_factor` times as fast if it is firm.
  /// Coulomb's friction is a spring to the anchor, which slides along when the spring pulls too
  /// hard. `friction` is the coefficient; 0: no friction.
  [[gnu::always_inline]] void add(const Vec4& p, double friction, Vec4& force, double& stiffness) {
    if (!near_) return;
    // Also before the touch: a step that ignores this stiffness would throw the vertex back.
    stiffness += stiffness_;
    const double depth = level_ - slope_ * dot(normal_, p);
    if (depth <= 0) {
      anchored_ = false;
      return;
    }
    const double beyond = firm_ ? std::max(depth - firm_depth, 0.0) : 0.0;
    const double push = body_push_stiffness * slope_ * (depth + (firm_push_factor - 1) * beyond);
    force += push * normal_;
    if (friction <= 0) return;
    if (!anchored_) {
      anchored_ = true;
      anchor_ = p;
    }
    const Vec4 away = p - anchor_;
    Vec4 slip = away - dot(normal_, away) * normal_;
    const double max_slip = friction * push / body_friction_stiffness;
    const double squared = squared_length(slip);
    if (squared > max_slip * max_slip) {
      slip *= max_slip / std::sqrt(squared);
      anchor_ = p - slip;
    }
    force -= body_friction_stiffness * slip;
    stiffness += body_friction_stiffness;
  }

 private:
  // What every iteration reads comes first, in one line of the cache.
  Vec4 normal_ = {0, 0, 0, 0};  // of the plane that stands for the body
  double slope_ = 1;  // of the distance along the normal; less than 1 with the body on both sides
  double level_ = 0;  // metres: depth of the origin below the plane
  double stiffness_ = 0;  // N/m: a bound of the push's stiffness
  bool near_ = false;
  bool firm_ = false;
  bool anchored_ = false;
  Vec4 anchor_ = {0, 0, 0, 0};
  double reach_ = -1;
  Vec3 linearized_at_ = Vec3::Zero();
};

}  // namespace toile
