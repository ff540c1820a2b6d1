// Sections of a surface with a plane, and their girths.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// One polyline along which a plane cuts a surface.
struct Section {
  /// Metres, in order along the cut, without repeated neighbours. A closed polyline does not repeat
  /// its first point. On an outward-oriented surface the points run counter-clockwise around the
  /// material, seen against the plane's normal. So a cavity's points run clockwise.
  std::vector<Vec3> points;
  std::vector<int> triangles;  ///< of the mesh, in order along the cut
  bool closed = false;         ///< true for every section of a closed mesh
  double length = 0;           ///< metres along the cut
  double girth = 0;            ///< metres around its convex hull, as a tape measures
  double area = 0;             ///< m^2 enclosed; negative for a cavity, 0 for an open polyline
  Vec3 centroid;               ///< of the enclosed area, or of the line if it encloses nothing
};

/// The sections of `mesh` with the plane through `origin` square to `normal`, in falling area.
/// `normal` may have any length but zero. A vertex in the plane counts as above it, so a facet in
/// the plane is cut only along its border. `mesh` has to be consistently oriented. O(n) in the
/// triangles, O(k log k) in those cut.
std::vector<Section> slice(const TriangleMesh& mesh, const Vec3& origin, const Vec3& normal);

/// Whether the section is closed and runs around `point`. `normal` is its plane's, of any length
/// but zero. Linear in its points.
bool contains(const Section& section, const Vec3& point, const Vec3& normal);

/// Metres between the two points of a section that are farthest apart. O(n^2) in its points.
double widest_chord(const Section& section);

/// Metres around the convex hull of points in a plane square to `normal`. O(n log n).
double hull_length(const std::vector<Vec3>& points, const Vec3& normal);

}  // namespace toile
