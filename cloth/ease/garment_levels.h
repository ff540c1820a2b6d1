// Girths at levels of the garment itself: its top edge, its waist seam, its hem, its cuffs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A line of the garment that runs once around the trunk, both legs or one limb. It need not lie
/// level. Lengths in metres.
struct GarmentLevel {
  /// "top edge", "waist seam" or "hem"; of a limb "left cuff", "left armhole" or "left leg hem".
  std::string name;
  double height = 0;           ///< above the floor, mean
  double garment = 0;          ///< length as worn
  double as_cut = 0;           ///< length on the flat panels; of a gathered seam, its shorter side
  std::optional<double> body;  ///< girth of trunk or limb there; none: not on the trunk, an armhole
  std::vector<int> nodes;      ///< of the garment, along the line
  bool is_of_limb = false;     ///< one limb passes through it
  /// Height at which it was drafted to lie (judge/drafted.h); none: not known.
  std::optional<double> drafted;
  std::optional<double> drafted_body;  ///< the body's girth there; none: not known

  /// How much higher it hangs than drafted; negative: lower.
  std::optional<double> risen() const {
    return drafted ? std::optional<double>(height - *drafted) : std::nullopt;
  }
};

/// Per panel, whether it hangs from the waist: waistband, skirt, trousers.
std::vector<char> worn_below_waist(const PanelMesh& pattern);
/// The same by the names of the panels alone.
std::vector<char> worn_below_waist(const std::vector<std::string>& panels);

/// The levels that the garment has, from the top down, those of limbs last. The waist seam is where
/// panels that hang from the waist are sewn to others. Empty unless the skeleton has all limbs.
/// Costs one pass over the body a level.
std::vector<GarmentLevel> measure_garment_levels(const DressedGarment& garment,
                                                 const TriangleMesh& body, const Skeleton& skeleton,
                                                 const std::vector<char>& below_waist);

}  // namespace toile
