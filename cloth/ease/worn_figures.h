// All girths, edges and lengths of a worn garment, each with its error.
#pragma once

#include <vector>

#include "cloth/ease/garment_levels.h"
#include "cloth/ease/girths.h"
#include "cloth/ease/lengths.h"

namespace toile {

struct WornFigures {
  Girths girths;
  std::vector<GarmentLevel> levels;
  std::vector<GarmentLength> lengths;
};

/// Metres: mean length of the mesh's edges on the flat.
double mean_edge(const DressedGarment& garment);

/// Measures a garment. `worn_as` has a role for each panel; `measures` are standing_measures().
/// Errors are those of figure_errors.h. Costs what measure_girths() does.
WornFigures measure_worn(const DressedGarment& garment, const TriangleMesh& body,
                         const Skeleton& skeleton, const std::vector<PanelRole>& worn_as,
                         const BodyMeasures& measures, const GirthOptions& options);

/// Takes the errors from other drapes of the same garment instead, on other meshes or from other
/// starts. An error is the half width within which the next drape's figure lies in nine of ten
/// cases, if drapes scatter normally. A figure that fewer than three drapes have keeps its error.
/// Quadratic in the figures of a kind.
void take_errors_from(const std::vector<WornFigures>& others, WornFigures& figures);

}  // namespace toile
