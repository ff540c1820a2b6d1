// A scene compiled against a garment: one flat array per term, empty where the scene has no use
// for the term.
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

/// Constant-strain triangle: warp and weft deformation w = Σ coefficient_i x_i over its corners
/// [Baraff & Witkin 1998, 4.2]. Stiffnesses are the fabric's times the area.
struct StretchTriangle {
  std::array<double, 3> weft;  ///< 1/m
  std::array<double, 3> warp;  ///< 1/m
  double area;                 ///< m², at rest
  double weft_stiffness = 0;   ///< N·m
  double warp_stiffness = 0;   ///< N·m
  double shear_stiffness = 0;  ///< N·m
  bool limited = true;         ///< by the scene's limits; false on a gathered seam, which gives way
};

/// Hinge of two triangles across an edge, at rest flat: Σ weight_i x_i is how the slope jumps
/// across it, square to the cloth as long as that is nearly flat.
struct BendHinge {
  std::array<int, 4> points;      ///< edge's ends, then the two opposite corners: material points
  std::array<double, 4> weights;  ///< 1/m, add up to 0
  /// N·m: were it to bend on its own, E = ½ stiffness |jump|², as if rolled square to its edge,
  /// half by the rigidity of either side. Only the springs of the paper's method are made from it.
  double stiffness = 0;
  bool across_seam;
};

/// A triangle's piece of a bent plate, E = ½ Σ stiffness_ij jump_i · jump_j over its hinges: the
/// plate's energy ½ area κᵀ D κ at the curvature κ that the three jumps tell of, that of the
/// quadratic surface through a triangle and its neighbours, so that a sheet bends as stiffly
/// whichever way its mesh is cut [Phaal & Calladine 1992, A Simple Class of Finite Elements for
/// Plate and Shell Problems]. Jumps are linear in the places, so the stiffness is constant [Bergou
/// et al. 2006, A Quadratic Bending Model for Inextensible Surfaces].
struct BendTriangle {
  std::array<int, 3> hinges;  ///< across from each corner; -1: a border
  Eigen::Matrix3d stiffness;  ///< N·m, see plate_stiffness()
};

/// A *material point* has a place in a flat panel; sewn points share a *node*, which moves. While
/// a seam closes, its points still stand apart: point p is at x[node_of_point[p]] +
/// open·offset[p], with `open` going from 1 to 0.
struct GarmentModel {
  int nodes = 0;
  int subdivisions = 0;  ///< of the nested mesh, as PanelMesh says
  std::vector<int> node_of_point;
  std::vector<Vec3> offsets;                 ///< per material point; empty: nothing is sewn
  std::vector<Triangle> triangles;           ///< of material points
  std::vector<Triangle> node_triangles;      ///< the same, of nodes
  std::vector<StretchTriangle> stretch;      ///< one per triangle
  std::vector<BendHinge> bend;               ///< empty: fabric without bending stiffness
  std::vector<BendTriangle> bend_triangles;  ///< those with stiffness and hinges
  std::vector<ElasticSegment> elastics;      ///< elastics; empty: the garment has none
  std::vector<AttachedPoint> attachments;    ///< what is held; empty: nothing is
  std::vector<double> mass;                  ///< kg, per node
  std::vector<double>
      stretch_diagonal;  ///< N/m, per node: bound of the row sum of the stiffness, elastics' too
  std::vector<double> bend_diagonal;   ///< N/m, per node: the same of what bends, with any share
                                       ///< from 0 to 1 of what is across seams
  std::vector<double> shortest_edge;   ///< metres at rest, per node, of its triangles
  std::vector<double> friction_skin;   ///< Coulomb, per node: the mean of its panels' by mass
  std::vector<double> friction_cloth;  ///< Coulomb, per node: the same, against cloth
  std::vector<Vec3> start;             ///< metres, per node
  Scene scene;
  double mean_weight = 0;      ///< N, of a node
  double body_offset = 0.002;  ///< metres kept between the skin and the middle of the cloth
  double self_gap = 0;         ///< metres kept between the middles of cloth and cloth
};

/// Place of every material point while seams are `open`.
std::vector<Vec3> point_positions(const GarmentModel& model, const std::vector<Vec3>& nodes,
                                  double open);

/// What was compiled, by term, with counts; a term that the scene does not use counts 0.
std::vector<std::pair<std::string, int>> term_counts(const GarmentModel& model);

}  // namespace toile
