// Where edges and levels of a garment were drafted to lie on the body.
#pragma once

#include <optional>
#include <vector>

#include "cloth/ease/garment_levels.h"
#include "cloth/ease/girths.h"
#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Metres above the floor, per node: where its cloth started, the mean of the panels' sides where
/// they are sewn.
std::vector<double> start_heights(const PanelMesh& pattern, const DressedGarment& dressed);

/// Metres by which an edge around the trunk came down since the start, at the centre of front and
/// back. `middle` is the x of the body's middle. At the sides flat panels droop, so they do not
/// count. The mean of all nodes where the edge does not cross the middle. `starts` is of
/// start_heights().
double came_down_at_centre(const std::vector<int>& loop, const std::vector<double>& starts,
                           const DressedGarment& dressed, double middle);

/// Whether an edge of the trunk hangs so far from where it was drafted to lie that it is said.
/// Below the trunk the body tells no more where that is. `height_error` is that of the mesh,
/// metres.
bool left_its_place(const GarmentLevel& level, double height_error);

/// Sets GarmentLevel::drafted and the drafted girths of the body.
///
/// - The hem of what hangs from the shoulders lies below the side of the neck by the length of the
///   panels. The length runs over the body as a taut thread does, over bust or shoulder blades, and
///   then straight down. Where front and back differ by less than 5 cm, the hem is meant level, and
///   the shorter of them holds it.
/// - The top edge of what does not: where it started, at the centre of front and back.
/// - A waist seam has none, nor what hangs from it: a bodice may blouse over it, a peplum stands
/// off. It gets GarmentLevel::waist.
///
/// `skeleton` has all limbs. Costs four slices, and one pass over the body a level.
void set_drafted(const PanelMesh& pattern, const DressedGarment& dressed, const TriangleMesh& body,
                 const Skeleton& skeleton, std::vector<Girth>& girths,
                 std::vector<GarmentLevel>& levels);

}  // namespace toile
