// Where a garment starts: its panels clear of each other, and of what they are dressed onto.
#pragma once

#include <vector>

#include "cloth/start/draw_and_lift.h"
#include "geometry/distance_grid.h"
#include "geometry/types.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Moves panels that intersect each other or the collider, or are inside of it, apart: one after
/// another, the nearest to the collider first, each is moved on until it is clear of the collider
/// and of those before it, a centimetre at a time and up to 70 cm; a flat one along its normal,
/// away from the collider; one that bends around its body part, away from the bones, by 15 cm at
/// most. Panels that stand joined along a seam, and nowhere through each other, move as one. Panels
/// that stand clear stay where they are, as long as none that is moved comes to stand there; so do
/// those that meet only where they are sewn together. Exact where anything is near; `collider` is
/// the surface that `distance` tells the distance to. Notes the moves in `placement` and counts its
/// points_inside anew. Throws Error, naming the panels, when one finds no place.
void resolve_intersections(const PanelMesh& garment, const TriangleMesh& collider,
                           const DistanceGrid& distance, const Skeleton* skeleton,
                           Placement& placement);

/// Pairs of panels, by index and the lower first, that intersect as placed; sorted. Points that
/// are sewn together and in one place count as one.
std::vector<std::pair<int, int>> crossing_panels(const PanelMesh& garment,
                                                 const std::vector<Vec3>& placed);

}  // namespace toile
