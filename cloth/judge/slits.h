// What looks left out along the border of a sewn garment: slits, and bands that end early.
#pragma once

#include <string>
#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// Two open edges that begin at one point and lie side by side in the flat cloth. A vent has them,
/// a dart that is not sewn, and a seam that was left open.
struct Slit {
  std::string panel_a;  ///< beside one edge, at the slit's end
  std::string panel_b;  ///< beside the other
  double length = 0;    ///< metres, of the shorter edge on the flat panels
  Vec3 tip{0, 0, 0};    ///< metres, where the slit ends, as worn
  int node = 0;         ///< of DressedGarment::points, at the tip
  double rest = 0;      ///< metres of the ring's border beside the slit's two edges, flat
};

/// The slits of at least `min_slit` metres. A slit ends where the cloth around a point of the
/// border turns by 310 degrees and more. Its edges run from there to the next corner, as far as the
/// shorter one goes. A curve is no corner. A narrow V of a neckline is one, too: what `rest` leaves
/// open tells them apart. About O(n log n) in the triangles.
std::vector<Slit> find_slits(const PanelMesh& garment, const DressedGarment& dressed);

/// An end of a band that is sewn to nothing, beside an edge that goes on without it. The other half
/// of the band is missing, or one end of the edge is sewn wrongly. Where the edge ends with the
/// band, as at the front of a jacket, it is no such end.
struct BandEnd {
  std::string band;     ///< the panel
  std::string goes_on;  ///< the panel whose edge goes on
  Vec3 at{0, 0, 0};     ///< metres, as worn
};

/// The ends of waistbands and cuffs, by PanelClass::role, of the panels that are not layered. About
/// O(n log n) in the triangles.
std::vector<BandEnd> find_band_ends(const PanelMesh& garment, const DressedGarment& dressed);

}  // namespace toile
