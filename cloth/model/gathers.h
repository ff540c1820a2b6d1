// Seams whose sides differ in length: which edges give way.
#pragma once

#include <map>
#include <utility>

#include "pattern/panel_mesh.h"

namespace toile {

/// Share of its flat length that each edge of material points (the lower index first) is left with
/// at rest.
using GatheredEdges = std::map<std::pair<int, int>, double>;

/// Edges on the longer side of a seam, where the two sides differ by more than 2 %. A gathered seam
/// takes the shorter side's length: the other side's fullness goes into folds beside it, not into
/// stretching its partner.
GatheredEdges gathered_edges(const PanelMesh& garment);

/// Edges along the garment's elastics and what is sewn to them, with the share that the elastic's
/// rest is of their length: cloth that an elastic draws up.
GatheredEdges elastic_edges(const PanelMesh& garment);

/// Triangles that touch a gathered edge, each with the direction of the seam there (a unit vector
/// of the flat panel). Drawn up by its thread, cloth lies in folds of a few millimetres, finer than
/// the mesh, which open within the depth of this row into those that the mesh can have. So the row
/// gives way in shear and, off the seam, along it, with `gathered_stiffness` times the fabric's
/// stiffness. With all of it the row pushes the seam into zigzags, 3.8 % longer than its shorter
/// side; so, 1.4 % [measured, weightless, 2 : 1 at 10 mm edges].
std::map<int, Vec2> gathered_rows(const PanelMesh& garment, const GatheredEdges& gathered);

inline constexpr double gathered_stiffness = 0.02;

}  // namespace toile
