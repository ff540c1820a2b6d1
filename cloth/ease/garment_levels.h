// Girths at levels of the garment itself: its top edge, its waist seam, its hem.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A line of the garment that runs once around the trunk or both legs. It need not lie level.
/// Lengths in metres.
struct GarmentLevel {
  std::string name;            ///< "top edge", "waist seam" or "hem"
  double height = 0;           ///< above the floor, mean
  double garment = 0;          ///< length as worn
  double as_cut = 0;           ///< length on the flat panels; of a gathered seam, its shorter side
  std::optional<double> body;  ///< girth of the trunk at `height`; none: not on the trunk
  std::vector<int> nodes;      ///< of the garment, along the line
  /// The body's girth where the line was drafted to lie (drafted_girths.h); none: not known.
  std::optional<double> drafted_body;
};

/// The levels that the garment has, from the top down. The waist seam is where panels of
/// waistband, skirt or trousers (panel_kind.h, by name) are sewn to others. Empty unless the
/// skeleton has all limbs. Costs one pass over the body a level.
std::vector<GarmentLevel> measure_garment_levels(const DressedGarment& garment,
                                                 const TriangleMesh& body,
                                                 const Skeleton& skeleton);

}  // namespace toile
