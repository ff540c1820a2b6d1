// Where a garment that is pressed flat has its openings and its shoulders.
#pragma once

#include <vector>

#include "cloth/start/flat_layout.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A loop of the sewn border, in the picture of a FlatLayout. Metres.
struct FlatOpening {
  double length = 0;  ///< along the border
  double low = 0;     ///< lowest and highest point
  double high = 0;
  double left = 0;  ///< smallest and largest x
  double right = 0;
  double mean_height = 0;
  bool both_faces = false;  ///< front and back border it
};

/// The openings of the sewn panels of `layout`, the highest mean first. Holes of less than 15 cm
/// and cut-outs do not count. O(n log n).
std::vector<FlatOpening> flat_openings(const PanelMesh& garment, const FlatLayout& layout);

/// Points of the picture on seams between the faces that have cloth below them and none above, and
/// run more across than up. On what is worn on the shoulders these are shoulder seams, and the
/// upper ones of sleeves.
std::vector<Vec2> shoulder_points(const PanelMesh& garment, const FlatLayout& layout);

/// Metres: height of the uppermost cloth of one face within 3 cm of `x`; -infinity: there is none.
double face_top(const PanelMesh& garment, const FlatLayout& layout, bool back, double x);

}  // namespace toile
