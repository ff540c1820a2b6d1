// Whether a garment is worn where it belongs: sleeves on arms, trousers on legs, a skirt about
// waist or hips.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloth/judge/openings.h"
#include "cloth/judge/wraps.h"

namespace toile {

/// Something that is worn elsewhere than it belongs. Texts are for people.
struct Misplaced {
  BodyPart part = BodyPart::none;
  std::string at;         ///< where the cloth is
  std::string should_be;  ///< where it belongs
};

/// How far a top edge is from where it was drafted to lie, of a garment that hangs from waist, hips
/// or chest. It was drafted to lie where its panels start, at most at the waist for what has no
/// top. Lengths in metres.
struct Slid {
  double down = 0;    ///< negative: up
  double length = 0;  ///< of the top edge as cut
  double hip = 0;     ///< the largest girth of the body between crotch and waist; 0: not measured
  double error = 0;   ///< of a height on this mesh

  /// Whether it is worth a warning.
  bool is_far() const;
};

/// "slid down by 24 cm: its top edge is cut 114 cm long, the hips are 110 cm"
std::string text_of(const Slid& slid);

struct WearFindings {
  /// False: nothing tells where the garment belongs, such as a sheet or a cape, or the skeleton
  /// lacks joints.
  bool is_checked = false;
  std::vector<Opening> openings;
  std::optional<Misplaced> misplaced;  ///< the first thing that is in a wrong place
  std::optional<Slid> slid;            ///< none: it hangs from the shoulders, or has no top edge
  /// Where what hangs from the shoulders and closes below leaves much of the trunk bare.
  std::optional<BareLevel> bare;
  std::vector<std::string> turned;  ///< panels that hang the other way up than they are placed
  /// Body parts that cloth lies at and should go around, and does not.
  std::vector<BodyPart> unwrapped;
};

/// What a garment is comes from what its panels are (classify.h), and from
/// its openings. Where it is worn comes from the limbs that pass through the openings, and from
/// heights. Each connected component is checked by itself:
///
/// - Sleeves: an opening of theirs has their arm, and no other limb. Their crown, the part of the
///   armhole seam that is farthest from the line of the cuff, lies above the underarm.
/// - Trousers: an opening has the left leg alone, another one the right leg.
/// - What hangs from the shoulders: an opening separates an arm from the legs. Where it hangs, no
///   strap has slid off its shoulder.
/// - Strapless tops: the highest opening around the trunk lies a quarter of the way from waist to
///   armpits at least.
/// - Skirts and trousers without a top: the highest opening around the trunk lies above the crotch.
///   It lies below two thirds of the way from waist to armpits.
/// - What hangs from waist, hips or chest came down by 8 cm at most (Slid).
/// - Sleeves, skirts and tops that are not closed around their part meet 85 % of the directions.
///   A wrap skirt does. A shirt that lacks a quarter does not. Nor does a shirt whose sides are
///   open from the hem to its sleeves. What is open in front or at the back by its seams meets half
///   of them: each arm has an opening of its own there. So does an apron, which no arm passes
///   through, where it lies as it was drafted to.
/// - Of the cloth without sleeves, 13 % at most hang upside down in folds (hangs.h).
/// - Any other component: no two openings of 15 cm or more may have nothing in them. An opening
///   around both legs may not be its highest one and lie below the crotch.
/// - Panels named front and back lie there within 60 degrees. Those named left and right lie at the
///   sides, either at either.
/// - No component hangs below the floor. What lies at it reaches up to where it was drafted to lie.
///   Above the knees it reaches, too, unless a limb passes through it.
/// - Collars and hoods reach above the armpits.
/// - The cloth has two sides (two_sides.h).
///
/// `garment` has panels placed where they started. The hips of `body` are measured for a garment
/// that slid down; null: they are not. About O(n log n) in the triangles.
WearFindings check_worn(const PanelMesh& garment, const DressedGarment& dressed,
                        const Skeleton& skeleton, const TriangleMesh* body = nullptr);

}  // namespace toile
