// Slits of a sewn garment: two edges that look like a seam that was left open.
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

}  // namespace toile
