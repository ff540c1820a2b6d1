// The body against one vertex of the cloth: it keeps it off and holds it by friction.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "cloth/scene/scene.h"
#include "geometry/types.h"
#include "geometry/vec4.h"

namespace toile {

/// One vertex of the cloth against the body, through a run. The body is looked at where the vertex
/// is, and stands as a plane until the vertex has moved on by `reach`.
class alignas(32) BodyContact {
 public:
  /// Takes the body's surface, `offset` metres out, near the vertex at `p`, for a plane along
  /// `linearization_radius` metres; for less where it bends away on both sides. The vertex, which
  /// may come down by `approach_bound` metres in a step, counts as held by the body from so far
  /// off. The scene has a body.
  void linearize(const Scene& scene, const Vec3& p, double offset, double linearization_radius,
                 double approach_bound);

  /// Metres that the vertex may still move before the body has to be looked at again; 0 and less
  /// when it is due.
  double remaining(const Vec3& p) const { return reach_ - (p - linearized_at_).norm(); }

  /// Whether the body is near enough to push within what remains.
  bool near() const { return near_; }

  /// Has the body looked at again before the next force; where the vertex sticks stays.
  void forget() { reach_ = -1; }

  /// A bound of the stiffness that add() adds where the body stands as a plane, N/m.
  static constexpr double max_stiffness = 1200;

  /// Where friction holds the vertex; nothing: it does not.
  std::optional<Vec3> anchor() const {
    return anchored_ ? std::optional<Vec3>(as_vec3(anchor_)) : std::nullopt;
  }
  /// Lets friction hold it there, instead of where it comes to touch the body.
  void set_anchor(const Vec3& anchor) {
    anchored_ = true;
    anchor_ = as_vec4(anchor);
  }

  /// Adds the force (N) on the vertex at `p`, and a bound of its stiffness (N/m): a push off the
  /// body, by what half the square of the depth falls along the way, and Coulomb's friction as a
  /// spring to the place where the vertex stuck, which slides along when it pulls too hard.
  /// `friction` 0: none.
  [[gnu::always_inline]] void add(const Vec4& p, double friction, Vec4& force, double& stiffness) {
    if (!near_) return;
    // Before it touches, too: a step that does not reckon with it would throw the vertex back off.
    stiffness += stiffness_;
    const double depth = level_ - slope_ * dot(normal_, p);
    if (depth <= 0) {
      anchored_ = false;
      return;
    }
    const double push = push_stiffness * slope_ * depth;
    force += push * normal_;
    if (friction <= 0) return;
    if (!anchored_) {
      anchored_ = true;
      anchor_ = p;
    }
    const Vec4 away = p - anchor_;
    Vec4 slip = away - dot(normal_, away) * normal_;
    const double max_slip = friction * push / anchor_stiffness;
    const double squared = squared_length(slip);
    if (squared > max_slip * max_slip) {
      slip *= max_slip / std::sqrt(squared);
      anchor_ = p - slip;
    }
    force -= anchor_stiffness * slip;
    stiffness += anchor_stiffness;
  }

 private:
  /// N/m. A node of 1 cm² that 100 Pa press to the skin sinks in by 0.01 mm.
  static constexpr double push_stiffness = 1000;
  /// N/m, of the spring that holds a sticking vertex to its anchor on the skin.
  static constexpr double anchor_stiffness = 200;
  static_assert(push_stiffness + anchor_stiffness <= max_stiffness);

  Vec4 normal_ = {0, 0, 0, 0};  // of the plane that stands for the body
  Vec4 anchor_ = {0, 0, 0, 0};
  double slope_ = 1;      // of the distance along the normal: less where the body is on both sides
  double level_ = 0;      // metres of depth at the origin
  double stiffness_ = 0;  // N/m, a bound of the push's
  double reach_ = -1;
  Vec3 linearized_at_ = Vec3::Zero();
  bool near_ = false;
  bool anchored_ = false;
};

}  // namespace toile
