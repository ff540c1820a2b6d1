// Regions of panels whose cloth stays beyond the scene's strain limit, and how much is missing
// there.
#pragma once

#include <string>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/model/stretch.h"

namespace toile {

/// A connected region of a panel that is strained beyond the limit along one of its yarns.
struct TightRegion {
  std::string panel;
  bool along_warp = false;  ///< false: along the weft
  Vec2 flat;                ///< metres, its centre in the flat panel
  double height = 0;        ///< metres, y of its centre as dressed
  double area = 0;          ///< m² of the flat panel
  double largest = 0;       ///< largest strain, a fraction
  double mean = 0;          ///< mean strain over the area, a fraction
  double missing = 0;       ///< metres along the yarn that lacks the most: strain beyond the limit
};

struct TightRegions {
  std::vector<TightRegion> regions;  ///< the most strained first
  int specks = 0;                    ///< count of further regions, of less than 1 cm² each
};

/// The regions whose warp or weft stays beyond the scene's strain limit. A triangle counts when its
/// strain exceeds `kept_limit` times the limit and its multiplier is at `max_limit_multiplier`. A
/// smaller multiplier says that the cloth has not come to rest. Triangles that share a corner
/// belong to one region. Gathered seams have no limit and are left out.
///
/// `nodes` are the model's, `multipliers` one a triangle. The result is empty without a limit or
/// without multipliers. Linear in the triangles, but each region is cut by 24 lines.
TightRegions tight_regions(const PanelMesh& garment, const GarmentModel& model,
                           const std::vector<Vec3>& nodes,
                           const std::vector<LimitMultiplier>& multipliers);

}  // namespace toile
