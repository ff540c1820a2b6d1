// The levels of the trunk that tailors measure at, to a millimetre.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/body/body_frame.h"

namespace toile {

/// A level, or the reason why the trunk does not show it.
struct TrunkLevel {
  std::optional<double> height;  ///< metres above the floor
  double confidence = 0;         ///< 0 to 1
  std::string reason;            ///< why there is none, or why the confidence is low
};

/// Levels of the trunk.
/// - The bust stands out the most square to the line from the waist to the neck, which leans back
///   on most people. Noise would place a flat one: it is at a stated share of the way from waist to
///   neck. That is below the armpits, where ISO 8559-1 measures men and children.
/// - The hip is half-way between where the seat stands out the most and where the girth is
///   greatest.
/// - The waist is where a tape rests in the hollow, next to the least girth. Without a hollow,
///   proportion places it.
/// - Without joints the back is where the waist is more hollow, between seat and shoulder blades.
struct TrunkLevels {
  TrunkLevel bust;       ///< the bust points' level
  TrunkLevel underbust;  ///< below the breasts
  TrunkLevel waist;
  TrunkLevel abdomen;        ///< the front's foremost level between hip and waist
  TrunkLevel hip;            ///< the seat's level
  double lean = 0;           ///< metres forward a metre up, of the line from waist to neck
  double low = 0;            ///< metres: the trunk's lower end, the crotch of a body with legs
  double high = 0;           ///< metres: its upper end, the armpits of a body with arms
  bool is_backward = false;  ///< of a body without joints: its back is at +z
};

/// Finds the levels of the body in its frame. Without a skeleton, the trunk is where one section
/// holds nearly all that a level plane cuts. It then needs a waist between two wider levels.
/// Costs some 100 slices.
TrunkLevels trunk_levels(const BodyFrame& body);

/// The same. A body without joints whose back is at +z is turned first, `body` with it.
TrunkLevels facing_trunk_levels(BodyFrame& body);

/// The torso's joints, in its frame, of a body without others: `pelvis` at the trunk's lower end,
/// `waist`, and by proportion `chest` and `neck`. Nothing where it has no waist.
std::optional<Skeleton> torso_joints(const BodyFrame& body, const TrunkLevels& levels);

/// A level of the trunk by its name in ISO 8559-1: "bust", "waist" or "hip".
struct NamedLevel {
  std::string name;
  double height = 0;  ///< metres above the floor
};

/// Those of bust, waist and hip that trunk_levels() finds on a body that stands on y = 0 and faces
/// +z, in this order. Costs trunk_levels() and a copy of the body.
std::vector<NamedLevel> girth_levels(const TriangleMesh& body, const Skeleton& skeleton);

}  // namespace toile
