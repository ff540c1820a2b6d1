// Makes one closed surface of loose polygons.
#pragma once

#include <string>
#include <vector>

#include "geometry/types.h"

namespace toile {

struct RepairOptions {
  /// Share of the surface's longest side: the largest diagonal of the bounding box of a hole that
  /// is filled. A larger hole is an Error. 0.2 is 34 cm on a body of 1.70 m. That takes in the
  /// soles that a scanner can't see, a missing hand or the crown of the head, but no open back.
  double largest_hole = 0.2;
  /// Share of the surface's longest side: the largest distance between the surfaces before and
  /// after a repair of self-intersections that is kept. 0.003 is 5 mm on a body.
  double largest_move = 0.003;
};

/// A hole that was filled. What is there now is a guess.
struct FilledHole {
  Vec3 middle{0, 0, 0};  ///< of its bounding box; file's unit, as all of a RepairReport
  double across = 0;     ///< the diagonal of that box
};

/// The changes that repair() made. A count of zero means that nothing had to be done.
struct RepairReport {
  int points_read = 0;
  int polygons_read = 0;
  int points_merged = 0;          ///< points that coincided exactly, or that no polygon used
  int polygons_removed = 0;       ///< polygons without area or listed twice
  int points_split = 0;           ///< where an edge had over two polygons, or a point over one fan
  int polygons_triangulated = 0;  ///< polygons of four or more corners
  int borders_stitched = 0;       ///< pairs of border edges
  int components_dropped = 0;     ///< all but the component of largest area
  double dropped_area = 0;        ///< share of the whole area that was dropped
  std::vector<FilledHole> holes_filled;
  int self_intersections_found = 0;  ///< pairs of triangles
  int self_intersections_left = 0;
  double largest_move = 0;         ///< of the surface, by the repair of intersections; file's unit
  bool turned_inside_out = false;  ///< whether its normals pointed inward
};

struct RepairedSurface {
  TriangleMesh mesh;  ///< closed, 2-manifold, one component, outward-oriented; file's unit
  RepairReport report;
};

/// Repairs a polygon soup with CGAL's polygon mesh processing. A sound surface keeps its points,
/// their order and its triangles; coordinates below 1e-30 become 0. It throws Error, with the place
/// `name`, for no polygons, coordinates beyond 1e9, and a one-sided surface. Holes too large to
/// fill and a surface that encloses no volume are Errors, too. About O(n log n); filling a hole
/// costs more than linear time in its border.
RepairedSurface repair(const PolygonSoup& soup, const std::string& name,
                       const RepairOptions& options = {});

}  // namespace toile
