// What is measured on a garment: areas, perimeters, strains, seams.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cloth/model/elastics.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Area of each panel, m², flat or with its material points at `points`.
std::vector<double> panel_areas(const PanelMesh& garment);
std::vector<double> panel_areas(const PanelMesh& garment, const std::vector<Vec3>& points);

/// Length of each panel's outline, its seam edges included, metres.
std::vector<double> panel_perimeters(const PanelMesh& garment);
/// The edges of each panel's outline, for those who measure often.
using Outlines = std::vector<std::vector<std::array<int, 2>>>;
Outlines panel_outlines(const PanelMesh& garment);
std::vector<double> panel_perimeters(const Outlines& outlines, const std::vector<Vec3>& points);

/// Sum over each panel of the perimeters of all its triangles, metres: the perimeter of
/// [Zhong & Xu 2009, fig. 10].
std::vector<double> triangle_perimeters(const PanelMesh& garment);
std::vector<double> triangle_perimeters(const PanelMesh& garment, const std::vector<Vec3>& points);

/// Largest |now/rest - 1| in percent.
double largest_change_percent(const std::vector<double>& rest, const std::vector<double>& now);

/// |length/rest - 1| over a set of mesh edges.
struct StrainFigures {
  double max = 0;
  double p99 = 0;
  double rms = 0;
};

struct OpenSeam {
  std::string name;
  double missing_cm = 0;  ///< widest gap between two points that should be one
};

struct SeamFigures {
  int sewn = 0;
  int open = 0;
  double max_gap_mm = 0;
  std::vector<OpenSeam> open_seams;
};

/// Two points of a seam are sewn when they are nearer than this, metres [Zhong & Xu 2009].
inline constexpr double sewn_gap = 1e-5;

struct GarmentFigures {
  StrainFigures strain;  ///< of all mesh edges
  /// Without edges that have both ends on a seam; of those beside a gathered one or an elastic,
  /// whose fullness lies in folds finer than the mesh, only how much longer they became.
  StrainFigures strain_off_seams;
  /// Off the gathered seams, per triangle: how much longer its warp or weft is, whichever is more;
  /// 0 where both are slack. And radians off the right angle between them.
  StrainFigures warp_weft_strain;
  StrainFigures shear;
  double area_total_percent = 0;  ///< signed; the others are the largest |change|
  double area_max_panel_percent = 0;
  double perimeter_max_panel_percent = 0;
  double triangle_perimeter_max_panel_percent = 0;
  SeamFigures seams;
  std::vector<ElasticFigures> elastics;  ///< elastics
  int borders = 0;                       ///< open border loops
};

/// Measures a dressed garment against its pattern. Throws Error when the two have different faces.
GarmentFigures measure_garment(const PanelMesh& pattern, const DressedGarment& dressed);

/// Loops of edges that belong to one triangle only. Loops that meet in a point count as one.
int border_loops(const std::vector<Triangle>& triangles, std::size_t points);

}  // namespace toile
