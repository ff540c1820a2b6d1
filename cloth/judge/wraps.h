// What each tube of a garment encloses: the figure that tells a shirt from a scarf.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The share of the directions square to a part's bones that meets the panels of that part.
struct WrapFigure {
  std::string part;
  double from = 0;  ///< metres along the bones from the part's first joint; negative before it
  double to = 0;    ///< metres along the bones from the first joint
  double fraction = 0;
  double slid = 0;    ///< metres down from where it was placed; 0: it hangs from shoulders or limbs
  bool tube = false;  ///< the part's panels are sewn to something that can go around it
};

/// Measures every part that panels belong to, over the stretch of bone that they are meant to
/// cover. Its length is that of the garment on the flat panels, not where the pattern placed them.
///
/// - Torso: the length is the shortest path from top to hem. It hangs from the base of the neck and
///   counts from the armpits down. The stretch is from 10 to 70 % of it.
/// - Skirt, which is a torso's panels placed below the armpits: the length counts from where the
///   top came to lie. It counts from where the top was placed if that slid off the torso. It does
///   so too if the top slid by more than half the length and 10 cm. The stretch is from 25 to 75 %.
/// - Arm or leg: the length is the shortest path from the seams at the torso to the cuff. It counts
///   from armpit or crotch. The stretch is from 25 to 75 %.
///
/// Ease, a hem that swings and folds take up the rest. Linear in the triangles times 32 stations.
std::vector<WrapFigure> measure_wraps(const PanelMesh& garment, const DressedGarment& dressed,
                                      const Skeleton& skeleton);

}  // namespace toile
