// Lengths of a garment along the body: sleeves, shoulders, centre front and back, legs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloth/ease/cloth_line.h"
#include "geometry/body/measures.h"
#include "geometry/body/skeleton.h"
#include "pattern/classify/panel_class.h"

namespace toile {

/// How far a length's end lies beyond a place of the body, in metres; negative: short of it. Of the
/// floor it is the height above.
struct EndsBeyond {
  std::string place;  ///< "left elbow", "left wrist", "left shoulder point", "floor"
  double by = 0;
};

/// A length of the garment. Metres.
struct GarmentLength {
  /// "left sleeve", "left shoulder", "centre back", "centre back to waist seam", "left outseam" or
  /// "left inseam"; front and right as well.
  std::string name;
  double as_cut = 0;  ///< on the flat panels, straight across each
  double worn = 0;    ///< along the cloth
  /// The body's own length: arm, shoulder, neck to waist, inside leg.
  std::optional<double> body = {};
  std::vector<EndsBeyond> ends = {};  ///< where its lower or outer end lies
};

/// The lengths that the garment has, each along the line in which a plane meets it.
///
/// - A sleeve: over the arm from the armhole to its end, in the plane of shoulder and wrist. Within
///   the same plane the shoulder leads on to the neck.
/// - Centre front and back: from the highest edge to the hem, and to the waist seam if there is
/// one.
/// - Seams of legs: from the hem to waist and crotch, in the plane of the leg.
///
/// `skeleton` has all limbs, or the result is empty. `measures` are standing_measures(); empty: no
/// length has the body's. `worn_as` has a role for each panel. Costs a slice of the garment a
/// plane.
std::vector<GarmentLength> measure_lengths(const DressedGarment& garment, const Skeleton& skeleton,
                                           const std::vector<Measure>& measures,
                                           const std::vector<PanelRole>& worn_as);

}  // namespace toile
