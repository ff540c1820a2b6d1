// The mesh of one panel: a coarse mesh of its outline, subdivided.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh_polygon.h"
#include "pattern/mesh/cut_outs.h"
#include "pattern/mesh/panel_marks.h"
#include "pattern/pattern.h"

namespace toile {

/// A panel that cannot be meshed with as many subdivisions, and why.
struct Unmeshable {
  std::string panel;  ///< "panel 'front'", and its edge where one is at fault
  std::string problem;
  std::vector<int> edges = {};  ///< those that shorter steps may help, indices in the panel
  std::size_t index = 0;        ///< of the panel
};

/// The mesh of one panel. Indices count the points of this panel.
struct PanelTriangulation {
  PlanarMesh mesh;
  std::vector<std::vector<int>> along;      ///< per edge, points from its start to its end
  std::vector<std::vector<int>> cut_along;  ///< per curve of the cut-outs, likewise
  PointedMarks marks;                       ///< internal lines and drill holes
  int coarse_outline = 0;  ///< points of the outline on the coarsest level; they come first
};

/// How one panel is meshed.
struct PanelMeshing {
  bool mirrored = false;     ///< x to -x: the drawing shows the cloth's wrong side
  double coarse_length = 0;  ///< metres, triangle edges of the coarsest level
  int subdivisions = 0;
  std::vector<int> steps;          ///< per edge, on the coarsest level
  std::vector<int> split_corners;  ///< as mesh_polygon() takes them
  std::vector<CutOut> cut_outs;    ///< in the drawing
};

/// "panel 'front'", for messages.
std::string quoted(const PatternPanel& panel);

/// Meshes the panel. Border points lie on the curves of edges and cut-outs on every level. Points
/// of the finest level lie on what is drawn within. Throws Unmeshable where an outline crosses
/// itself or triangles would be needles. O(n log n).
PanelTriangulation triangulate_panel(const PatternPanel& panel, const PanelMeshing& how);

}  // namespace toile
