// A body with its arms raised, so that they are out of the way while a garment is sewn around it.
#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

/// Raises the arms of a standing body to about the horizontal, and lowers them again, with all of
/// the space around them. Each arm turns about its shoulder, in the plane that parts front and
/// back. One that leaves that plane, as bent arms do, is brought into it. The space between the arm
/// and the trunk is stretched, the space above the arm compressed. Trunk, head and legs stay.
///
/// The map of space is continuous and has an inverse. So what is clear of the body and of itself
/// stays clear of it, but for what a straight edge cuts off a bent one.
class ArmRaise {
 public:
  /// Radians above the horizontal to which arms are raised where nothing stands above them.
  static constexpr double usual_angle = 10 * std::numbers::pi / 180;
  /// Radians beyond which space above the arms would be pressed to less than half.
  static constexpr double max_angle = 60 * std::numbers::pi / 180;

  /// The skeleton is that of the body as it stands. A body without arms, or with arms raised
  /// already, is left as it is. `raised_angle`: radians above the horizontal, up to max_angle.
  ArmRaise(const Skeleton& skeleton, const TriangleMesh& body, double raised_angle = usual_angle);

  /// Whether an arm is raised at all.
  bool any() const { return !arms_.empty(); }
  /// Metres: where raising the arms takes `p`.
  Vec3 raised(const Vec3& p) const;
  /// Metres: where lowering the arms takes `p`. The inverse of raised(), up to rounding.
  Vec3 lowered(const Vec3& p) const;
  /// Metres: `p` turned with the arm of the part `left_arm` or `right_arm`, as if it were rigid;
  /// `p` itself for other parts.
  Vec3 turned_with(BodyPart part, const Vec3& p) const;

  /// The body's points, raised.
  TriangleMesh raised(TriangleMesh body) const;
  /// The joints, raised.
  Skeleton raised(Skeleton skeleton) const;

 private:
  struct Arm {
    BodyPart part = BodyPart::none;
    Vec3 shoulder;
    double side;                 ///< 1: left, -1: right
    double angle;                ///< radians above the horizontal, as the arm hangs
    double turn;                 ///< radians by which it is raised
    std::array<Vec3, 3> joints;  ///< shoulder, elbow, wrist
    Vec3 axis = Vec3::Zero();    ///< unit vector from shoulder to wrist, raised
    bool leaves_plane = false;   ///< forward or backward, as an arm bent at the elbow
    double radius = 0;           ///< metres around the axis within which the arm lies
  };
  static Vec3 slimmed(const Arm& arm, const Vec3& p, bool back);
  static double shift(const Arm& arm, double radius, double angle);
  static double depth_of(const Arm& arm, double radius);
  static Vec3 turned(const Arm& arm, const Vec3& p, bool back);

  std::vector<Arm> arms_;
};

}  // namespace toile
