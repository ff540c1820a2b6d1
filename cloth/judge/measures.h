// Measures of a garment: areas, perimeters, strains, seams.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cloth/judge/tight_regions.h"
#include "cloth/model/elastics.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// m², per panel: its area, flat or with its material points at `points`.
std::vector<double> panel_areas(const PanelMesh& garment);
std::vector<double> panel_areas(const PanelMesh& garment, const std::vector<Vec3>& points);

/// Metres, per panel: the length of its outline, its seam edges included.
std::vector<double> panel_perimeters(const PanelMesh& garment);
/// Per panel, the edges of its outline. Callers that measure often compute them once.
using Outlines = std::vector<std::vector<std::array<int, 2>>>;
Outlines panel_outlines(const PanelMesh& garment);
std::vector<double> panel_perimeters(const Outlines& outlines, const std::vector<Vec3>& points);

/// Metres, per panel: the sum of the perimeters of all its triangles. This is the perimeter of
/// [Zhong & Xu 2009, fig. 10].
std::vector<double> triangle_perimeters(const PanelMesh& garment);
std::vector<double> triangle_perimeters(const PanelMesh& garment, const std::vector<Vec3>& points);

/// A fraction: the largest |now/rest - 1|.
double largest_change(const std::vector<double>& rest, const std::vector<double>& now);

/// Statistics of a set of strains, fractions. Of mesh edges a strain is |length/rest - 1|.
struct StrainStatistics {
  double max = 0;
  double p99 = 0;
  double rms = 0;
};

struct OpenSeam {
  std::string name;
  double gap = 0;  ///< metres: widest gap between two points that should be one
};

struct SeamMeasurements {
  int sewn = 0;
  int open = 0;
  double max_gap = 0;  ///< metres
  std::vector<OpenSeam> open_seams;
};

struct GarmentMeasurements {
  StrainStatistics strain;  ///< of all mesh edges
  /// Of all mesh edges but those with both ends on a seam. Beside a gathered seam or an elastic,
  /// fullness lies in folds finer than the mesh. An edge there counts only by how much longer it
  /// is.
  StrainStatistics strain_off_seams;
  /// Per triangle off the gathered seams: by how much its warp or weft is longer, whichever is
  /// more. 0 where both are slack.
  StrainStatistics warp_weft_strain;
  StrainStatistics shear;  ///< radians off the right angle of warp and weft, of the same
  std::vector<TightRegion> overstretched;  ///< of more than a hand's breadth square, if any
  double area_total = 0;                   ///< change of the whole area, a signed fraction
  /// Largest |change| of any panel, fractions.
  double area_max_panel = 0;
  double perimeter_max_panel = 0;
  double triangle_perimeter_max_panel = 0;
  SeamMeasurements seams;
  std::vector<ElasticMeasurement> elastics;  ///< one an elastic of the pattern
  int borders = 0;                           ///< open border loops
};

/// Measures a dressed garment against its pattern. Throws Error when the two have different faces.
GarmentMeasurements measure_garment(const PanelMesh& pattern, const DressedGarment& dressed);

}  // namespace toile
