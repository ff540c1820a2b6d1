// The mannequin as a solid of lofted and joined tailoring cross-sections.
#pragma once

#include <string_view>
#include <vector>

#include "geometry/body/mannequin/mannequin_bones.h"
#include "geometry/body/mannequin/mannequin_solids.h"
#include "geometry/types.h"

namespace toile {

/// The point on the other side of the mid-plane x = 0.
inline Vec3 mirrored(const Vec3& p) { return {-p.x(), p.y(), p.z()}; }

/// A girth that the mannequin is scaled to. It goes around the centre line of `part` at a row of
/// the loft, square to the part's axis. It goes around one limb, not around both.
struct GirthTarget {
  std::string_view name;
  MannequinPart part;
  double t;      ///< metres: height of the row along the part's axis
  double girth;  ///< metres
};

/// The target girths in the order from neck to ankle. Bust to knee are the body's measures in
/// [Zhong & Xu 2009, Fig. 12]. The others are those of a woman of that build and of 1.70 m.
const std::vector<GirthTarget>& girth_targets();

/// The mannequin in metres. It stands on y = 0 and faces +z, with left +x and arms out at 45
/// degrees.
class MannequinShape {
 public:
  /// The shape from the tables, not yet scaled to the girths.
  MannequinShape();
  MannequinShape(MannequinSolids solids, MannequinBones bones, std::vector<GirthTarget> girths);

  /// About the distance to the skin, negative inside. It is symmetric in x to the last bit.
  double distance(const Vec3& point) const;

  /// About the distance to the trunk with the head, at rest.
  double trunk_distance(const Vec3& point) const;
  /// About the distance to the left arm with its hand, at rest.
  double arm_distance(const Vec3& point) const;
  /// About the distance to the left leg without its foot, at rest.
  double leg_distance(const Vec3& point) const;
  /// About the distance to the left foot, its sole cut flat at y = 0, at rest.
  double foot_distance(const Vec3& point) const;

  /// The part's centre at the height of the girth.
  Vec3 centre(const GirthTarget& target) const;
  /// The direction of the part's axis, square to the girth's plane.
  Vec3 normal(const GirthTarget& target) const;
  /// Metres that a tape around the shape reads there. Sections have to be star-shaped about the
  /// centre.
  double girth(const GirthTarget& target) const;

  /// Scales sections until each girth is within `tolerance` metres of its target. It returns the
  /// greatest difference left. It throws Error when 30 rounds are not enough.
  double carve(double tolerance);

  const MannequinSolids& solids() const { return solids_; }
  const MannequinBones& bones() const { return bones_; }
  /// Where it has the girths of girth_targets(), in their order.
  const std::vector<GirthTarget>& girths() const { return girths_; }

 private:
  MannequinSolids solids_;
  MannequinBones bones_;
  std::vector<GirthTarget> girths_;
};

/// The sample mannequin, carved to girth_targets(). Made once.
const MannequinShape& sample_shape();

}  // namespace toile
