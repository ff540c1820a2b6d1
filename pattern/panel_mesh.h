// A garment as meshed panels. The pattern room makes it, and the cloth room dresses it.
#pragma once

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "geometry/types.h"
#include "pattern/attachment.h"
#include "pattern/classify/panel_class.h"
#include "pattern/panel_placement.h"

namespace toile {

/// One flat pattern piece as meshed. Its material points and triangles are contiguous ranges.
struct MeshedPanel {
  std::string name;
  std::string fabric;  ///< name of its fabric; empty: the garment's
  double grain = 0;    ///< radians, angle of the warp direction against the flat +y axis
  int first_point = 0;
  int points = 0;
  int first_triangle = 0;
  int triangles = 0;
  PanelPlacement placement{};  ///< how the skeleton positions it; by default it does not
  bool layered = false;        ///< it lies upon other panels, as a facing or a pocket does
  PanelClass is = {};          ///< what it is, see classify.h
};

/// Two outline edges that are sewn together: the i-th point of side a meets the i-th of side b. The
/// two sides of a dart hold the same material point at its tip.
struct MeshedSeam {
  std::string name;     ///< "panel.edge-panel.edge" unless the pattern names it
  std::vector<int> a;   ///< material points along side a, at least two
  std::vector<int> b;   ///< as many along side b
  double length_a = 0;  ///< metres, of the pattern's curve
  double length_b = 0;  ///< metres, of the pattern's curve
};

/// An elastic that is sewn along an outline edge while stretched to the edge's length.
struct MeshedElastic {
  std::string name;         ///< "panel.edge"
  std::vector<int> points;  ///< material points along the edge, at least two
  double ratio = 1;         ///< length of the elastic at rest over that of the edge, at most 1
  double stiffness = 0;     ///< N: its tension is this times the strain
};

/// An internal line or a drill hole of a panel.
struct MeshedMark {
  std::string name;         ///< "panel.internal_line.0" or "panel.drill_hole.0"
  std::vector<int> points;  ///< material points: one of a hole, each of a line joined to the next
};

/// A hole that is cut into a panel.
struct MeshedCutOut {
  std::string name;         ///< "panel.cut_out.0"
  std::vector<int> points;  ///< material points in order around it
};

/// Panels as triangulated, before anything is sewn. A *material point* belongs to one panel and has
/// flat coordinates there. Where panels are sewn, two material points share one node. Flat
/// coordinates show the cloth's right side, so all triangles face out of the sewn garment.
///
/// The triangulation is nested in `subdivisions` = n levels. Every run of four triangles 4t..4t+3
/// splits triangle t of the next coarser level into three corners and the centre. Child i keeps the
/// parent's corner i at its index i. Child 0 is (c0, m01, m20), child 1 (m01, c1, m12), child 2
/// (m20, m12, c2), child 3 (m01, m12, m20). Within a panel the points of a coarser level come
/// before those of a finer one. n = 0 says that nothing is known of nesting.
struct PanelMesh {
  std::vector<Vec2> flat;  ///< metres, per material point
  /// Metres, per material point: where the pattern puts it in space, and place_panels() after it. A
  /// panel that the skeleton positions stands beside a schematic figure here.
  std::vector<Vec3> placed;
  std::vector<Triangle> triangles;  ///< of material points, counter-clockwise in flat coordinates
  std::vector<MeshedPanel> panels;  ///< in order of their ranges
  std::vector<MeshedSeam> seams;
  /// Per material point, not 0 where its seams are left open; empty: all seams are sewn.
  std::vector<char> unsewn;
  std::vector<MeshedElastic> elastics;
  std::vector<MeshedAttachment> attachments;
  std::vector<MeshedMark> marks;
  std::vector<MeshedCutOut> cut_outs;
  int subdivisions = 0;
  /// False: all panels of the pattern share one origin, as in files that state no places. Those
  /// that the skeleton positions do not count. Also where one has the place of a part that it is
  /// not for.
  bool has_places = true;
  double edge_length = 0;  ///< metres, the triangle edges that were asked for; 0: not known
};

/// Whether the seams at a material point are sewn, as far as it is on one.
inline bool is_sewn(const PanelMesh& garment, int point) {
  return garment.unsewn.empty() || garment.unsewn[point] == 0;
}

/// The material points at all cut-outs.
inline std::set<int> points_at_cut_outs(const PanelMesh& garment) {
  std::set<int> points;
  for (const MeshedCutOut& cut_out : garment.cut_outs) {
    points.insert(cut_out.points.begin(), cut_out.points.end());
  }
  return points;
}

/// Per material point, the index of its panel.
inline std::vector<int> panel_of_points(const PanelMesh& garment) {
  std::vector<int> panel_of;
  panel_of.reserve(garment.flat.size());
  for (std::size_t i = 0; i < garment.panels.size(); ++i) {
    panel_of.insert(panel_of.end(), garment.panels[i].points, static_cast<int>(i));
  }
  return panel_of;
}

/// Per triangle, the index of its panel.
inline std::vector<int> panel_of_triangles(const PanelMesh& garment) {
  std::vector<int> panel_of;
  panel_of.reserve(garment.triangles.size());
  for (std::size_t i = 0; i < garment.panels.size(); ++i) {
    panel_of.insert(panel_of.end(), garment.panels[i].triangles, static_cast<int>(i));
  }
  return panel_of;
}

/// Unit vectors of a flat panel along its yarns.
struct YarnDirections {
  Vec2 weft;
  Vec2 warp;
};

/// The yarns of a panel whose warp is `grain` radians counter-clockwise from +y. They are the flat
/// +x and +y axes turned by that angle.
inline YarnDirections yarn_directions(double grain) {
  const Vec2 weft(std::cos(grain), std::sin(grain));
  return {weft, Vec2(-weft.y(), weft.x())};
}

/// A dressed garment: faces in the garment's order, sewn points shared.
struct DressedGarment {
  std::vector<Vec3> points;              ///< nodes, metres
  std::vector<Triangle> triangles;       ///< of nodes
  std::vector<Vec2> flat;                ///< metres, per material point
  std::vector<Triangle> flat_triangles;  ///< of material points, as many as `triangles`
  std::vector<std::string> panels;       ///< names
  std::vector<int> panel_of_triangle;    ///< index into `panels`
  /// Names of the panels' fabrics, as many as `panels`, those that are not known empty. Empty: none
  /// is known. Files hold them for other programs; they are not read.
  std::vector<std::string> fabrics = {};
};

/// The garment with its nodes at `points`. `triangles` holds one triangle of nodes for each of the
/// garment's, in the same order. The fabric of panels that name none is not known.
DressedGarment as_dressed(const PanelMesh& garment, std::vector<Vec3> points,
                          std::vector<Triangle> triangles);

}  // namespace toile
