// The nested meshes of a garment, coarse to fine [see PanelMesh].
#pragma once

#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// The garment on the next coarser level of its nested mesh, with one subdivision less.
/// `fine.subdivisions` has to be at least 1. Linear.
PanelMesh coarsen(const PanelMesh& fine);

/// Leaves the seams at some points of the coarsest of the nested meshes open, on all of them.
/// `meshes`: the finest first. `unsewn`: as PanelMesh's, of the last mesh. Linear.
void leave_open(std::vector<PanelMesh>& meshes, std::vector<char> unsewn);

/// Positions (metres) of the nodes of a finer level. Old points stay, and new ones stand in the
/// middle of their edge. So the surface is the same set of points in space, and stays free of
/// intersections.
///
/// `coarse_nodes` and `fine_nodes` hold the node of each material point on the two levels.
/// `coarse_positions` holds one position per coarse node. `fine_node_count` is the number of fine
/// nodes.
std::vector<Vec3> refine_positions(const PanelMesh& coarse, const std::vector<int>& coarse_nodes,
                                   const std::vector<Vec3>& coarse_positions, const PanelMesh& fine,
                                   const std::vector<int>& fine_nodes, int fine_node_count);

/// The same of a vector per material point, such as a position or a displacement. Sewn points may
/// differ.
std::vector<Vec3> refine_points(const PanelMesh& coarse, const std::vector<Vec3>& of_points,
                                const PanelMesh& fine);

/// Metres, per fine material point: where the finer mesh stands when the coarser one was moved from
/// `coarse.placed` to `placed`. New points move by the mean of the two that they lie between.
std::vector<Vec3> refine_placed(const PanelMesh& coarse, std::vector<Vec3> placed,
                                const PanelMesh& fine);

}  // namespace toile
