// Ease: how far the garment stands off the body.
#pragma once

#include <vector>

#include "geometry/surface_distance.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// One point of one panel with its gap: the distance to the nearest point of the body's surface,
/// negative inside the body. Where panels are sewn together, each panel has its own point.
///
/// - A gap is measured at the garment's points, against the body's flat facets.
/// - It is half the difference in diameter, not in girth. Cloth that stands off a round body by a
///   gap g all around is longer than the girth of the body by 2 pi g.
/// - The nearest point of the body need not be the one that the cloth covers. Under a hanging skirt
///   it may be on a leg to the side.
struct PointGap {
  int panel = 0;   ///< index into DressedGarment::panels
  int node = 0;    ///< index into DressedGarment::points
  int flat = 0;    ///< index into DressedGarment::flat
  double gap = 0;  ///< metres
};

/// Gaps over some cloth in metres, weighted with area. A point stands for a third of each triangle
/// around it, as draped.
struct EaseStatistics {
  int points = 0;        ///< count of the points
  double area = 0;       ///< m², as draped
  double mean = 0;       ///< metres
  double deviation = 0;  ///< metres, the standard deviation
  double min = 0;        ///< metres
  double max = 0;        ///< metres
  double p5 = 0;         ///< metres: 5 % of the area has a smaller gap
  double p50 = 0;        ///< metres: 50 % of the area has a smaller gap
  double p95 = 0;        ///< metres: 95 % of the area has a smaller gap
  double contact = 0;    ///< share of the area with a gap below EaseOptions::contact, in [0, 1]
  double inside = 0;     ///< share of the area with a negative gap, in [0, 1]
};

/// Options of measure_ease().
struct EaseOptions {
  /// Metres: cloth with a smaller gap touches the body. Cloth is draped with an offset of about 2
  /// mm from the skin, which stands for its thickness. So a contact limit has to be above 2 mm.
  double contact = 0.003;
};

/// All gaps of a garment.
struct EaseMap {
  std::vector<PointGap> points;        ///< by panel, then by index of the flat point
  std::vector<double> node_gaps;       ///< metres, per point of DressedGarment::points
  std::vector<EaseStatistics> panels;  ///< per panel of DressedGarment::panels
  EaseStatistics garment;              ///< of all panels together
};

/// Of some nodes, at least one, that which is farthest off the skin.
int farthest_node(const EaseMap& map, const std::vector<int>& nodes);

/// Measures the gaps of a dressed garment. The sign of a gap means something only for a closed
/// body; closed_surface_defect() checks that. Costs one query of the body per node, in parallel.
/// The result does not depend on the number of threads.
EaseMap measure_ease(const DressedGarment& garment, const SurfaceDistance& body,
                     const EaseOptions& options = {});

}  // namespace toile
