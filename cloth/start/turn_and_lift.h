// Turns sleeves and lifts panels, so that a garment starts around the body and clear of it.
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
  std::vector<Vec3> placed;  ///< per material point, metres
  /// Metres, per material point: where pattern and skeleton put them, before they were moved.
  std::vector<Vec3> initial;
  std::vector<PositionedPanel> positioned;  ///< panels that the skeleton positioned
  double lift = 0;                          ///< metres, of all panels together
  std::map<BodyPart, double> turned;        ///< radians, per arm whose sleeve was turned to it
  std::map<std::string, double> moved_off_layers;  ///< metres, per panel moved off a layer
  std::map<std::string, double> moved_clear;       ///< metres, per panel that intersected something
  int points_inside = 0;  ///< material points that are still inside the body
  int seams_inside = 0;   ///< pairs of sewn points that would meet inside the body
};

/// The number of `points` that are inside the body.
int points_inside(const std::vector<Vec3>& points, const DistanceGrid& body);

/// Turns and lifts panels that stand at `garment.placed`. `skeleton` null: sleeves stay.
///
/// - Sleeves turn to their arms (align_sleeves.h). With `skin`, they move square to the arms, until
///   these lie between their seams (centre_sleeves.h).
/// - All panels but those rolled around a limb are lifted together. The points to be sewn then meet
///   outside the body. A shoulder seam drawn below the body's shoulder would be pulled through it.
/// - Of the lifts up to 20 cm, the one wins for which the body obstructs the fewest pairs
///   (seam_paths.h). Of equal ones, the lowest wins. It has to be at most half of the pairs that
///   the body obstructs otherwise.
/// - A garment with seams above the chest hangs from the shoulders. It is lifted by `hang` metres
///   at least, unless tubes around limbs hold it where it is.
/// - A garment without such seams or sleeves is lifted only as long as no more of its points get
///   inside the body.
///
/// Linear in the points, times 20 lifts; a seam point costs some queries of `body` each time.
Placement turn_and_lift(const PanelMesh& garment, const DistanceGrid& body,
                        const Skeleton* skeleton, double hang = 0,
                        const TriangleMesh* skin = nullptr);

}  // namespace toile
