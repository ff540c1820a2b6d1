// Where a garment starts: its panels around the body, clear of it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cloth/start/positioning.h"
#include "geometry/body/skeleton.h"
#include "geometry/distance_grid.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Where the panels start, and how they were moved from where the pattern puts them.
struct Placement {
  std::vector<Vec3> placed;                 ///< per material point, metres
  std::vector<PositionedPanel> positioned;  ///< panels that the skeleton positioned
  double lift = 0;                          ///< metres, of all panels together
  std::map<std::string, double> turned;     ///< radians, per arm whose sleeve was turned to it
  std::map<std::string, double> drawn_out;  ///< metres along the limb, per part that was
  std::map<std::string, double> moved_off_layers;  ///< metres, per panel that was in a layer's way
  std::map<std::string, double> moved_clear;       ///< metres, per panel that intersected something
  int points_inside = 0;  ///< material points that are still inside the body
  int seams_inside = 0;   ///< pairs of sewn points that would meet inside the body
};

/// Positions the panels that ask for it by the skeleton (positioning.h, whose Errors it throws).
/// Turns sleeves to their arms (turned_sleeves.h). Then draws the panels of arms and legs out along
/// their bones until none of their seam points has to pass its partner on the torso, behind which
/// it would be caught; `skeleton` null: stays. Then lifts all panels together, but for those rolled
/// around a limb, until the points that are to be sewn come to each other outside the body: a
/// shoulder seam drawn below the body's shoulder would be pulled through it. Takes the lowest lift,
/// up to 20 cm, for which the body bars the fewest pairs (sewing_ways.h). A garment with seams
/// above the chest hangs from the shoulders: `hang` metres at least, unless it has tubes around
/// limbs, which hold it where it is; one without seams there or sleeves is lifted only to where no
/// more of its points are inside the body.
Placement place_panels(const PanelMesh& garment, const DistanceGrid& body, const Skeleton* skeleton,
                       double hang = 0);

/// The same of panels that stand where `garment.placed` says, whoever positioned them.
Placement draw_out_and_lift(const PanelMesh& garment, const DistanceGrid& body,
                            const Skeleton* skeleton, double hang = 0);

}  // namespace toile
