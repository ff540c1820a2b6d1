// A scene compiled against a garment. There is one flat array per term, empty where the scene does
// not use the term.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "cloth/model/attachments.h"
#include "cloth/model/elastics.h"
#include "cloth/scene/scene.h"
#include "geometry/types.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A constant-strain triangle. The deformations of weft and warp are w = Σ coefficient_i x_i over
/// its corners [Baraff & Witkin 1998, 4.2]. Stiffnesses are the fabric's times the area.
struct StretchTriangle {
  std::array<double, 3> weft;  ///< 1/m
  std::array<double, 3> warp;  ///< 1/m
  double area;                 ///< m², at rest
  double weft_stiffness = 0;   ///< N·m
  double warp_stiffness = 0;   ///< N·m
  double shear_stiffness = 0;  ///< N·m
  /// Whether the scene's strain limits act. They do not on gathered seams, which give way.
  bool limited = true;
};

/// A hinge of two triangles across an edge, flat at rest. Its jump Σ weight_i x_i is the change of
/// slope across the edge. It is square to the cloth as long as the hinge is nearly flat.
struct BendHinge {
  std::array<int, 4> points;  ///< material points: the edge's ends, then the two opposite corners
  std::array<double, 4> weights;  ///< 1/m, add up to 0
  bool across_seam;               ///< the edge lies on a seam
};

/// A triangle's piece of a bent plate: E = ½ Σ stiffness_ij jump_i · jump_j over its hinges.
///
/// It is the plate's energy ½ area κᵀ D κ at the curvature κ that the three jumps determine. That
/// is the curvature of the quadratic surface through the triangle and its neighbours. So a sheet
/// bends as stiffly however its mesh is cut [Phaal & Calladine 1992, A Simple Class of Finite
/// Elements for Plate and Shell Problems].
///
/// Jumps are linear in the positions, so the stiffness is constant [Bergou et al. 2006, A Quadratic
/// Bending Model for Inextensible Surfaces].
struct BendTriangle {
  std::array<int, 3>
      hinges;  ///< indices into GarmentModel::bend, opposite to each corner; -1: a border
  Eigen::Matrix3d stiffness;  ///< N·m, see plate_stiffness()
};

/// A garment and its scene as the solver reads them. A *material point* has a place in a flat
/// panel. Sewn points share a *node*, which moves. While a seam closes, its points still stand
/// apart: point p is at x[node_of_point[p]] + open · offsets[p], and `open` goes from 1 to 0.
struct GarmentModel {
  int nodes = 0;
  int subdivisions = 0;                      ///< of the nested mesh, as PanelMesh says
  std::vector<int> node_of_point;            ///< per material point
  std::vector<Vec3> offsets;                 ///< metres, per material point; empty: nothing is sewn
  std::vector<Triangle> triangles;           ///< of material points
  std::vector<Triangle> node_triangles;      ///< the same triangles, of nodes
  std::vector<StretchTriangle> stretch;      ///< one per triangle
  std::vector<BendHinge> bend;               ///< empty: fabric without bending stiffness
  std::vector<BendTriangle> bend_triangles;  ///< triangles with stiffness and hinges
  std::vector<ElasticSegment> elastics;      ///< empty: the garment has none
  std::vector<AttachedPoint> attachments;    ///< points on springs; empty: none
  std::vector<double> mass;                  ///< kg, per node
  /// N/m, per node: bound of the row sum of the stretch stiffness, elastics included.
  std::vector<double> stretch_diagonal;
  /// N/m, per node: bound of the row sum of the bending stiffness. It holds for any share from 0 to
  /// 1 of the hinges across seams.
  std::vector<double> bend_diagonal;
  std::vector<double> shortest_edge;  ///< metres at rest, per node: of its triangles
  std::vector<double>
      friction_skin;  ///< Coulomb, per node: against skin, the mean by mass of its panels
  std::vector<double>
      friction_cloth;       ///< Coulomb, per node: against cloth, the mean by mass of its panels
  std::vector<Vec3> start;  ///< metres, per node
  Scene scene;
  double mean_weight = 0;      ///< N, the mean of the nodes
  double body_offset = 0.002;  ///< metres kept between the skin and the middle of the cloth
  double self_gap = 0;         ///< metres kept between the middles of cloth and cloth
};

/// Metres, per material point: its position for node positions `nodes` and seams that are `open` at
/// each node, from 0 (closed) to 1 (as placed). Empty: all are closed.
std::vector<Vec3> point_positions(const GarmentModel& model, const std::vector<Vec3>& nodes,
                                  const std::vector<double>& open = {});

/// The terms of a model by name, with the count of their elements. A term that the scene does not
/// use counts 0.
std::vector<std::pair<std::string, int>> term_counts(const GarmentModel& model);

}  // namespace toile
