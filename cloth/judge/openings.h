// The openings of a dressed garment, and which limbs pass through each.
#pragma once

#include <vector>

#include "geometry/body/limbs_through.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A border of the sewn surface: neckline, armhole, cuff, hem, or all of them in one where the
/// garment is open in front.
struct Opening {
  std::vector<int> nodes;   ///< indices into DressedGarment::points, in order around
  LimbsThrough limbs;       ///< those that pass through
  double length = 0;        ///< metres, on the flat panels
  Vec3 middle{0, 0, 0};     ///< metres, mean of the nodes as worn
  int component = 0;        ///< connected component of the garment, from 0
  std::vector<int> panels;  ///< panel beside each of `nodes`, an index
  bool is_cut_out = false;  ///< the pattern cuts it into a panel
};

/// All openings of a dressed garment without its layered panels. `skeleton` has all limbs. About
/// O(n log n) in the triangles.
std::vector<Opening> find_openings(const PanelMesh& garment, const DressedGarment& dressed,
                                   const Skeleton& skeleton);

/// Per node, the connected component of the garment that it belongs to, from 0. -1: to no triangle.
std::vector<int> connected_components(const DressedGarment& dressed);

}  // namespace toile
