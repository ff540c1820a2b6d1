// Lengths of a garment along the body: sleeves, shoulders, centre front and back, legs, crotch.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloth/ease/cloth_line.h"
#include "cloth/ease/garment_levels.h"
#include "geometry/body/body_measures.h"
#include "geometry/body/skeleton.h"
#include "pattern/classify/panel_class.h"

namespace toile {

/// How far a length's end lies beyond a place of the body, in metres; negative: short of it. Of the
/// floor it is the height above, of a knee the height below.
struct EndsBeyond {
  std::string place;  ///< "left elbow", "left wrist", "left shoulder point", "knee", "floor"
  double by = 0;
  double error = 0;  ///< see worn_figures.h
};

/// A length of the garment. Metres.
struct GarmentLength {
  /// "left sleeve", "left shoulder", "across shoulder", "centre back", "centre back to waist seam"
  /// or "back neck drop". Of trousers "left outseam", "left inseam", "crotch length" or "back
  /// rise". Front and right as well.
  std::string name;
  /// On the flat panels, straight across each; of crotch length and rises along their seam. None:
  /// no one panel holds it.
  std::optional<double> as_cut = {};
  /// Along the cloth; across shoulder straight through the air. Of a neck drop the height;
  /// negative: the centre lies higher.
  double worn = 0;
  /// The body's own length: arm, shoulder, over the back from shoulder to shoulder, neck to waist,
  /// inside leg, crotch length.
  std::optional<double> body = {};
  std::vector<EndsBeyond> ends = {};  ///< where its lower or outer end lies
  double error = 0;                   ///< of `worn`, see worn_figures.h
};

/// The lengths that the garment has, each along the line in which a plane meets it.
///
/// - A sleeve: over the arm from the armhole to its end, in the plane of shoulder and wrist. Within
///   the same plane the shoulder leads on to the neck.
/// - Across shoulder: from the top of an armhole straight to the centre back, and on to the other.
///   The centre's point is level with the armhole's top on the flat, or is the centre's own top.
/// - Centre front and back: from the highest edge to the hem, and to the waist seam if there is
/// one.
/// - Neck drop: the height of the neck's sides over the neckline's centre. The sides are where a
///   panel of the front's centre meets one of the back's. So there is none of collars, hoods and
///   yokes.
/// - Seams of legs: from the hem to waist and crotch, in the plane of the leg.
/// - Crotch length: from the waist's edge at the front between the legs to that at the back, along
///   the seam of left and right legs. A plane does not do: near the crotch both legs' cloth lies
///   along it. Front and back rise are its parts where front panels meet back panels, or else at
///   its lowest point.
///
/// `skeleton` has all limbs, or the result is empty. `measures` are standing_measures(); empty: no
/// length has the body's. `worn_as` has a role for each panel. `levels` are
/// measure_garment_levels(), for neckline and armholes. Costs a slice of the garment a plane.
std::vector<GarmentLength> measure_lengths(const DressedGarment& garment, const Skeleton& skeleton,
                                           const BodyMeasures& measures,
                                           const std::vector<PanelRole>& worn_as,
                                           const std::vector<GarmentLevel>& levels);

}  // namespace toile
