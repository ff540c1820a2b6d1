// Moves panels clear of each other and of the collider, for the start of a garment.
#pragma once

#include <vector>

#include "cloth/start/turn_and_lift.h"
#include "geometry/distance_grid.h"
#include "geometry/types.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Moves panels apart that intersect each other or the collider, or are inside it.
///
/// - One after another is moved, the nearest to the collider first. Each stops where it is clear of
///   the collider and of those before it.
/// - A flat one moves along its normal, away from the collider, in steps of 1 cm up to 70 cm. One
///   that bends around its body part moves away from the bones, by 15 cm at most.
/// - Panels that stand joined along a seam, and nowhere through each other, move as one.
/// - Panels that stand clear stay, as long as no moved one comes to stand there. So do panels that
///   meet only where they are sewn together.
///
/// `collider` is the surface to which `distance` measures. Exact where anything is near. Notes the
/// moves in `placement` and counts its points_inside again. Throws Error, naming the panels, when
/// one finds no place.
void resolve_intersections(const PanelMesh& garment, const TriangleMesh& collider,
                           const DistanceGrid& distance, const Skeleton* skeleton,
                           Placement& placement);

/// Pairs of panels, by index and the lower first, that intersect as placed; sorted. Points that
/// are sewn together and in one place count as one.
std::vector<std::pair<int, int>> crossing_panels(const PanelMesh& garment,
                                                 const std::vector<Vec3>& placed);

}  // namespace toile
