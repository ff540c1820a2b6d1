// What each tube of a garment encloses: the figure that tells a shirt from a scarf.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Of the directions square to a part's bones, the share that meets the panels of that part.
struct WrapFigure {
  std::string part;
  double from = 0;  ///< metres along the bones from the part's first joint; negative before it
  double to = 0;
  double fraction = 0;
  double slid = 0;    ///< metres down from where it was placed, of what has no shoulders or limbs
  bool tube = false;  ///< the part's panels are sewn to something that can go around it
};

/// Measures every part that panels belong to, over the stretch of bone that they are meant to
/// cover. How far a garment reaches is its length on the flat panels, not where the pattern placed
/// them: on the torso the shortest way from its top to its hem, hung from the base of the neck and
/// counted from the armpits down, or, of what is placed below the armpits, as a skirt is, from
/// where its top came to lie, or from where it was placed if it slid by more than half its length
/// and 10 cm, or off the torso; on an arm or leg the shortest way from the seams to the torso to
/// the cuff, counted from armpit or crotch. Of that the torso's stretch is from 10 to 70 %, a
/// limb's and a skirt's from 25 to 75 %: the rest is what ease, a hem that swings and folds take
/// up. Linear in the triangles times 32 stations.
std::vector<WrapFigure> measure_wraps(const PanelMesh& garment, const DressedGarment& dressed,
                                      const Skeleton& skeleton);

}  // namespace toile
