// The quantities of a worn garment at each point of its panels, with their colours.
#pragma once

#include <vector>

#include "io/view/viewer_page.h"
#include "tools/ease_map/report.h"

namespace toile {

/// The node of each material point of a dressed garment.
std::vector<int> nodes_of_points(const DressedGarment& garment);

/// The value that all but a few of the largest are below; 0 of none. Single points are far beyond
/// the rest at corners.
double scale_high(std::vector<double> values);

/// The ease as one scale from stretched over touching to loose, -1 to 1. Cloth that stands off the
/// skin has its gap over EaseReport::top. Cloth that touches has its stretch, negative; the bar
/// says how much -1 is. What lies inside the body is below the scale. Where loads are not known,
/// what touches is 0.
struct EaseScale {
  std::vector<double> points;  ///< one a material point
  std::vector<double> nodes;   ///< one a node: the most stretched of its points
  ColourBar bar;
};
EaseScale ease_scale(const EaseReport& report);

/// The maps of the page, that of ease first; then strain, tension, pressure and grain where loads
/// are known, contact and curvature. A value at a seam is that of its own panel.
std::vector<PageMap> ease_maps(const EaseReport& report);

}  // namespace toile
