// From loose polygons to one closed surface.
#pragma once

#include <string>

#include "geometry/types.h"

namespace toile {

struct RepairOptions {
  /// A hole whose bounding box's diagonal is at most this share of the surface's longest side is
  /// filled; a larger one is an Error. 0.2 is 34 cm on a body of 1.70 m: the soles that a scanner
  /// can't see, a missing hand, the crown of the head; not an open back.
  double largest_hole = 0.2;
  /// A local repair of self-intersections is kept when no point of the surface as it was ends
  /// farther from the surface as it is than this share of its longest side (0.003: 5 mm on a body).
  double largest_move = 0.003;
};

/// What repair() changed. Counts are zero where nothing had to be done.
struct RepairReport {
  int points_read = 0;
  int polygons_read = 0;
  int points_merged = 0;     ///< that coincided exactly, or that no polygon used
  int polygons_removed = 0;  ///< without area or listed twice
  int points_split = 0;      ///< where more than two polygons met at an edge, or fans at a point
  int polygons_triangulated = 0;  ///< that had four or more corners
  int borders_stitched = 0;       ///< pairs of border edges
  int components_dropped = 0;     ///< all but the one of largest area
  double dropped_area = 0;        ///< their share of the whole area
  int holes_filled = 0;
  double largest_hole_filled = 0;    ///< diagonal, in the file's unit
  int self_intersections_found = 0;  ///< pairs of triangles
  int self_intersections_left = 0;
  double largest_move = 0;         ///< of the surface, by repairing intersections; file's unit
  bool turned_inside_out = false;  ///< its normals pointed inward
};

struct RepairedSurface {
  TriangleMesh mesh;  ///< closed, 2-manifold, one component, outward-oriented; the soup's unit
  RepairReport report;
};

/// Repairs a polygon soup with CGAL's polygon mesh processing. A surface that needs nothing keeps
/// its points, their order and its triangles. `name` is the place of Errors: no polygons,
/// coordinates beyond 1e9, a surface that is one-sided, that has holes too large to fill, or that
/// encloses no volume. About O(n log n); hole filling is more than linear in the hole's border.
RepairedSurface repair(const PolygonSoup& soup, const std::string& name,
                       const RepairOptions& options = {});

}  // namespace toile
