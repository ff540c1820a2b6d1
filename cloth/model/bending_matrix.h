// The hinges of a compiled garment, and the stiffness matrix of its bending.
#pragma once

#include <cstddef>
#include <vector>

#include "cloth/model/garment_model.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Fills the model's hinges, bend triangles and bend diagonal. Every other field has to be filled
/// before, except `elastics`. O(n log n) in the triangles.
void lay_out_bending(const PanelMesh& garment, GarmentModel& model);

/// Off-diagonal entries of a stiffness matrix, row by row. The entries of a row add up to minus its
/// diagonal, for a sheet that is only moved feels no force.
struct BendRows {
  std::vector<int> first;  ///< per vertex, and one more: index of its first entry; empty: no hinges
  std::vector<int> vertex;        ///< per entry: its column; ascending in a row
  std::vector<double> stiffness;  ///< N/m, per entry; positive pulls together
};

/// Rows of the hinges across seams, and rows of all other hinges. An entry that couples a hinge
/// across a seam to another one counts as the seam's.
struct BendMatrix {
  BendRows inside;
  BendRows seams;
};

/// The stiffness matrix of all bend triangles. `vertex` holds, per material point, a number in [0,
/// vertices). Unless `seams_apart`, all rows are in `inside`. O(n log n) in the triangles.
BendMatrix bend_matrix(const GarmentModel& model, const std::vector<int>& vertex,
                       std::size_t vertices, bool seams_apart);

}  // namespace toile
