// Where within its panels the cloth cannot be held to the scene's strain limit, and by how much it
// is too short there.
#pragma once

#include <string>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/model/stretch.h"

namespace toile {

/// A limit is kept where the strain is at most this times it.
inline constexpr double limit_is_kept = 1.1;

/// A connected piece of a panel that is strained beyond the limit along one of its yarns.
struct TightRegion {
  std::string panel;
  bool along_warp = false;  ///< or else weft
  Vec2 flat;                ///< metres, its centre in the flat panel
  double height = 0;        ///< metres, y of its centre as worn
  double area = 0;          ///< m² of the flat panel
  double largest = 0;       ///< strain, a fraction
  double mean = 0;          ///< likewise, over the area
  double missing = 0;       ///< metres along the yarns: strain beyond the limit, where that is most
};

struct TightRegions {
  std::vector<TightRegion> places;  ///< the most strained first
  int specks = 0;                   ///< others, of less than 1 cm²
};

/// The places of a garment whose warp or weft stays beyond the scene's strain limit by more than
/// `limit_is_kept` though `held`, what holds each triangle to it, is at its most. Triangles that
/// share a corner belong together. Gathered seams, which are not held, are left out; so is what
/// only has not come to rest. `nodes` are the model's. Empty without a limit or what holds to it.
/// Linear in the triangles, but for those of a place: 24 lines are laid through each.
TightRegions tight_regions(const PanelMesh& garment, const GarmentModel& model,
                           const std::vector<Vec3>& nodes,
                           const std::vector<LimitMultiplier>& held);

}  // namespace toile
