// Regions of panels whose cloth is strained beyond a limit, and how much is missing there.
#pragma once

#include <string>
#include <vector>

#include "cloth/model/stretch.h"
#include "pattern/panel_mesh.h"

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

/// The regions of a garment at `points` (material points, metres) whose warp or weft is strained
/// beyond `limit`, a fraction. Triangles that share a corner belong to one region. Gathered seams
/// are left out.
///
/// `multipliers`, one a triangle: those that held the limit while the cloth came to rest. With them
/// a triangle counts when its strain exceeds `kept_limit` times the limit and its multiplier is at
/// `max_limit_multiplier`. A smaller multiplier says that the cloth has not come to rest.
///
/// Linear in the triangles, but each region is cut by 24 lines.
TightRegions tight_regions(const PanelMesh& garment, const std::vector<Vec3>& points, double limit,
                           const std::vector<LimitMultiplier>& multipliers = {});

/// The regions that are stretched by more than `max_worn_strain` over more than a hand's breadth
/// square. Of whatever fabric, nobody wears such cloth.
std::vector<TightRegion> overstretched(const PanelMesh& garment, const std::vector<Vec3>& points);

}  // namespace toile
