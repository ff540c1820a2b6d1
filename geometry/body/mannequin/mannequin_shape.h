// The mannequin as a solid: tailoring cross-sections, lofted and joined.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "geometry/body/mannequin/loft.h"
#include "geometry/types.h"

namespace toile {

/// The lofts of which the mannequin is made; arms and legs stand for both sides.
enum class MannequinPart { torso, neck, arm, leg };

/// A girth that the mannequin is carved to: around the centre line of `part` at the loft's row
/// `row`, square to the part's axis. It goes around one limb, not around both.
struct GirthTarget {
  std::string_view name;
  MannequinPart part;
  double t;      ///< height of the row along the part's axis, metres
  double girth;  ///< metres
};

/// In the order from neck to ankle. Bust to knee are the measures of the body in Zhong & Xu 2009,
/// Fig. 12; the others are those of a woman of that build and 1.70 m.
const std::vector<GirthTarget>& girth_targets();

/// The mannequin: standing on y = 0, facing +z, left +x, arms out at 45 degrees. Metres.
class MannequinShape {
 public:
  /// From the tables, not yet carved to the girths.
  MannequinShape();

  /// About the distance to the skin; negative inside. Symmetric in x to the last bit.
  double distance(const Vec3& point) const;

  /// Its parts at rest, about the distance to each: trunk with head; the left arm with its hand,
  /// the left leg without its foot, the left foot with its sole cut flat at y = 0.
  double trunk_distance(const Vec3& point) const;
  double arm_distance(const Vec3& point) const;
  double leg_distance(const Vec3& point) const;
  double foot_distance(const Vec3& point) const;

  /// Where the girth is taken: the part's centre at its height, and the direction of its axis.
  Vec3 centre(const GirthTarget& target) const;
  Vec3 normal(const GirthTarget& target) const;
  /// What a tape around the shape there reads, metres. Sections are star-shaped about the centre.
  double girth(const GirthTarget& target) const;

  /// Scales sections until each girth is within `tolerance` metres of its target, and returns the
  /// greatest difference left.
  double carve(double tolerance);

 private:
  const Loft& part(MannequinPart which) const;
  Loft& part(MannequinPart which);

  std::array<Loft, 4> parts_;  // by MannequinPart
  Loft yoke_;
  Loft thumb_;
  Loft foot_;
};

}  // namespace toile
