// The nested meshes of a garment, coarse to fine [see PanelMesh].
#pragma once

#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// The garment on the next coarser level of its nested mesh, with subdivisions one less. The
/// caller makes sure that there is one.
PanelMesh coarsen(const PanelMesh& fine);

/// Node positions of a finer level from those of the coarser one it subdivides: old points stay,
/// new ones stand in the middle of their edge, so the surface is the same set of points in space
/// and what was free of intersections stays so. `node_of_point` are those of the two levels.
std::vector<Vec3> refine_positions(const PanelMesh& coarse, const std::vector<int>& coarse_nodes,
                                   const std::vector<Vec3>& coarse_positions, const PanelMesh& fine,
                                   const std::vector<int>& fine_nodes, int fine_node_count);

/// The same of what each material point has of its own: places, or moves.
std::vector<Vec3> refine_points(const PanelMesh& coarse, const std::vector<Vec3>& of_points,
                                const PanelMesh& fine);

/// Where a finer mesh of the panels stands when the coarser one was moved from where its garment
/// puts it to `placed`: each point is moved as those around it were.
std::vector<Vec3> refine_placed(const PanelMesh& coarse, std::vector<Vec3> placed,
                                const PanelMesh& fine);

}  // namespace toile
