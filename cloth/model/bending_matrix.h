// The hinges of a compiled garment, and what they make of the stiffness matrix.
#pragma once

#include <cstddef>
#include <vector>

#include "cloth/model/garment_model.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Fills the model's hinges, bend triangles and bend diagonal; the rest of it but the elastics
/// has to be there. Linear in the triangles but for sorting.
void lay_out_bending(const PanelMesh& garment, GarmentModel& model);

/// Off-diagonal entries of a stiffness matrix, by rows in order; those of a row add up to minus its
/// diagonal, for the force on a sheet that is only moved is none.
struct BendRows {
  std::vector<int> first;         ///< per vertex and one more: of the entries; empty: no hinges
  std::vector<int> vertex;        ///< per entry, ascending in a row
  std::vector<double> stiffness;  ///< N/m, positive pulls together
};

/// Rows of what bends across seams and of all else, apart. What couples a hinge across a seam to
/// one that is not counts as the seam's.
struct BendMatrix {
  BendRows inside;
  BendRows seams;
};

/// `vertex`: of each material point, from 0 to below `vertices`. Unless `seams_apart`, all rows are
/// in `inside`.
BendMatrix bend_matrix(const GarmentModel& model, const std::vector<int>& vertex,
                       std::size_t vertices, bool seams_apart);

}  // namespace toile
