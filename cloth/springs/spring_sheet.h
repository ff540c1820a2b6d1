// The garment as masses and springs, whose seams are sewn by merging their nodes.
#pragma once

#include <array>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/springs/spring.h"
#include "geometry/disjoint_sets.h"
#include "geometry/types.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A mass-spring garment [Zhong & Xu 2009; Provot 1995]. Every material point starts as a node.
/// Where seams are sewn, two nodes are merged, and the one left takes the springs of the other
/// (fig. 5). A node is named by one of its material points. So arrays are as long as the garment
/// has points, and points merged away have no mass and no springs.
///
/// - *Structural and shear springs* are the edges of the triangles, which on an unstructured mesh
///   are both. Their stiffness is the fabric's modulus in their direction, times their area over
///   their length squared [Van Gelder 1998]. Along a gathered seam they take the shorter side's
///   length.
/// - *Bending springs* join the opposite corners of two adjacent triangles, also of a seam's two
///   panels once it is sewn. Such a spring resists a fold with the fourth power of the angle. So it
///   has the fabric's bending energy at one curvature only, 1/`matched_radius`, with less energy
///   below and more above. It is no stiffer than the step that the edges need can bear.
class SpringSheet {
 public:
  /// `model`: the garment as compiled, which says what is to be sewn. Both have to outlive this.
  SpringSheet(const PanelMesh& garment, const GarmentModel& model);

  /// Factor on the bending springs from the next refresh() on, as far as the step bears it.
  void stiffen_bending(double factor) { bending_factor_ = factor; }

  /// The nodes of two material points become one; springs change at the next refresh().
  void merge(int a, int b) { merged_.join(a, b); }
  /// Re-connects springs and triangles, and adds up the masses. Linear in the triangles.
  void refresh();

  int node(int point) const { return node_of_point_[point]; }
  int points() const { return static_cast<int>(node_of_point_.size()); }
  const std::vector<double>& mass() const { return mass_; }  ///< kg; 0: merged away
  const std::vector<double>& inverse_mass() const { return inverse_mass_; }
  const std::vector<Spring>& edges() const { return edges_; }            ///< structural and shear
  const std::vector<Spring>& bending() const { return bending_; }        ///< of what is sewn so far
  const std::vector<Triangle>& triangles() const { return triangles_; }  ///< of nodes
  /// Edges that are softer than the fabric, see soften_small_elements().
  int softened() const { return softened_; }

 private:
  struct Bend {
    std::array<int, 2> corners;  // material points
    std::array<int, 4> hinge;    // the edge's ends in the one and the other panel
    double rest;
    double stiffness;
    double damping;  // seconds
  };
  void lay_out_edges();
  void lay_out_bends();
  void soften_small_elements();

  const PanelMesh& garment_;
  const GarmentModel& model_;
  std::vector<double> point_mass_;
  std::vector<Spring> point_edges_;  // between material points
  std::vector<Bend> point_bends_;
  DisjointSets merged_;  // material points of one node
  double bending_factor_ = 1;
  double rate_ = 0;  // 1/s²: stiffness on a node over its mass, the median
  int softened_ = 0;

  std::vector<int> node_of_point_;
  std::vector<double> mass_;
  std::vector<double> inverse_mass_;
  std::vector<Spring> edges_;
  std::vector<Spring> bending_;
  std::vector<Triangle> triangles_;
};

}  // namespace toile
