// Strain, tension and pressure of worn cloth by panel and by level: mean, largest, and where.
#pragma once

#include <string>
#include <vector>

#include "cloth/ease/girths.h"
#include "cloth/loads/loads.h"

namespace toile {

/// m²: the largest of a load is its largest mean over so much cloth. A fingertip covers a tenth of
/// it, a palm ten times as much. Of the largest pressure of three tight garments at 15 mm, half of
/// it reads up to 48 % more, double up to 29 % less.
inline constexpr double load_patch = 0.001;

/// A load over a part of the garment.
struct LoadFigure {
  double mean = 0;     ///< weighted with area
  double largest = 0;  ///< mean over the `load_patch` of cloth where it is largest
  int node = -1;       ///< in the middle of that patch; -1: the part has no node
};

/// The loads of a panel or a level. Strains are fractions, tension is N/m, pressure is Pa.
struct LoadRow {
  std::string name;
  LoadFigure strain_warp;
  LoadFigure strain_weft;
  LoadFigure strain_bias;
  LoadFigure tension;  ///< the larger principal one; of a level along the level
  LoadFigure pressure;
  double touching = 0;  ///< share of the area that touches the skin, in [0, 1]
};

/// The loads at the nodes: means of the triangles around them.
struct NodeLoads {
  std::vector<double> strain_warp, strain_weft, strain_bias;  ///< fractions
  std::vector<double> tension_warp, tension_weft;             ///< N/m
  std::vector<double> tension_most;                           ///< N/m, the larger principal one
};
NodeLoads loads_at_nodes(const DressedGarment& garment, const Loads& loads);

struct LoadRows {
  std::vector<LoadRow> panels;  ///< one a panel, in the order of DressedGarment::panels
  std::vector<LoadRow> levels;  ///< one for each girth: of the triangles that it cuts
};
/// Largest values may lie in a patch that reaches across a seam. Linear in the nodes times those in
/// a patch.
LoadRows load_rows(const DressedGarment& garment, const Loads& loads, const Girths& girths);

}  // namespace toile
