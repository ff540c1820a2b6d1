// Ease: how far the garment stands off the body.
#pragma once

#include <vector>

#include "geometry/surface_distance.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// One point of one panel with its gap: the distance to the nearest point of the body's surface,
/// negative inside the body. Where panels are sewn together, each has a point of its own there.
///
/// A gap is measured at the garment's points, against the body's flat facets. It is half the
/// difference in diameter, not in girth: cloth that stands off a round body by a gap g all around
/// is longer than it by 2 pi g. Nearest means nearest: under a hanging skirt that may be a leg to
/// the side.
struct PointGap {
  int panel = 0;   ///< index into DressedGarment::panels
  int node = 0;    ///< index into DressedGarment::points
  int flat = 0;    ///< index into DressedGarment::flat
  double gap = 0;  ///< metres
};

/// Gaps over a piece of cloth, weighted with the area that the points stand for: a third of each
/// triangle around them, as draped. Lengths in metres.
struct EaseStatistics {
  int points = 0;
  double area = 0;  ///< m^2, as draped
  double mean = 0;
  double deviation = 0;  ///< standard deviation
  double min = 0;
  double max = 0;
  double p5 = 0;  ///< percentiles of the area: 5 % of it has a gap below this
  double p50 = 0;
  double p95 = 0;
  double contact = 0;  ///< share of the area with a gap below EaseOptions::contact, in [0, 1]
  double inside = 0;   ///< share of the area with a negative gap, in [0, 1]
};

struct EaseOptions {
  /// Cloth nearer than this touches, metres. Cloth is draped with an offset of about 2 mm from the
  /// skin, which stands for its thickness; a contact limit has to be above it.
  double contact = 0.003;
};

struct EaseMap {
  std::vector<PointGap> points;        ///< by panel, then in the order of the panel's flat points
  std::vector<double> node_gaps;       ///< as many as DressedGarment::points, metres
  std::vector<EaseStatistics> panels;  ///< as many as DressedGarment::panels
  EaseStatistics garment;              ///< of all panels together
};

/// `body` has to be closed for the sign to mean anything (closed_surface_defect says). One query of
/// the body a node, run in parallel; the result does not depend on the number of threads.
EaseMap measure_ease(const DressedGarment& garment, const SurfaceDistance& body,
                     const EaseOptions& options = {});

}  // namespace toile
