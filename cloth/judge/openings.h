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
  double drafted = 0;       ///< metres above the floor, mean: where it was at the start
  double passes = 0;        ///< metres, girth of what has to pass through; 0: not known
  int component = 0;        ///< connected component of the garment, from 0
  std::vector<int> panels;  ///< panel beside each of `nodes`, an index
  bool is_cut_out = false;  ///< the pattern cuts it into a panel
};

/// All openings of a dressed garment without its layered panels. `skeleton` has all limbs. About
/// O(n log n) in the triangles.
std::vector<Opening> find_openings(const PanelMesh& garment, const DressedGarment& dressed,
                                   const Skeleton& skeleton);

/// Metres: the body's largest girth between two heights of the trunk; 0: it has no section there.
/// Costs 13 passes over the body.
double largest_girth(const TriangleMesh& body, double low, double high);

/// Measures `passes` of each opening: the head's girth for a neckline, and the trunk's for what
/// goes around it. The trunk counts at its widest between where the edge lies and where it was
/// drafted to lie. A ring that is too small rides up to where the body is slimmer. Hips do not have
/// to pass a waist, as seams may hold a closure there. `skeleton` has all limbs. Costs about 60
/// passes over the body.
void measure_passing(std::vector<Opening>& openings, const TriangleMesh& body,
                     const Skeleton& skeleton);

/// Whether a ring of that length in metres, cut flat, is too short for what has to pass the
/// opening.
bool is_too_small(const Opening& opening, double length);

/// Per node, the connected component of the garment that it belongs to, from 0. -1: to no triangle.
std::vector<int> connected_components(const DressedGarment& dressed);

}  // namespace toile
