// Where a garment starts: its panels around the body, clear of it.
#pragma once

#include <vector>

#include "geometry/distance_grid.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// How the panels were moved from where the pattern puts them.
struct Placement {
  std::vector<Vec3> placed;  ///< per material point, metres
  double lift = 0;           ///< metres, of all panels together
  int points_inside = 0;     ///< material points that are still inside the body
  int seams_inside = 0;      ///< pairs of sewn points that would meet inside the body
};

/// Lifts the panels together until the points that are to be sewn meet outside the body: a
/// shoulder seam drawn below the body's shoulder would be pulled through it. Takes the lowest lift,
/// up to 20 cm, for which the fewest pairs meet inside.
Placement place_panels(const PanelMesh& garment, const DistanceGrid& body);

}  // namespace toile
