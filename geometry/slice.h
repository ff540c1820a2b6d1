// Plane sections of a surface, and their girths.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// One polyline in which a plane cuts a surface.
struct Section {
  /// In order along the cut, without repeated neighbours; a closed one does not repeat its first.
  /// Where the surface is outward-oriented they run counter-clockwise around the material, seen
  /// against the plane's normal, so a cavity runs clockwise.
  std::vector<Vec3> points;
  std::vector<int> triangles;  ///< of the mesh, in the order in which the cut runs through them
  bool closed = false;         ///< always true for a closed mesh
  double length = 0;           ///< along the cut, metres
  double girth = 0;            ///< around its convex hull, metres: what a tape measure reads
  double area = 0;             ///< enclosed, m^2; negative for a cavity, 0 for an open polyline
  Vec3 centroid;               ///< of the enclosed area; of the line, where it encloses nothing
};

/// The sections of `mesh` with the plane through `origin` square to `normal` (of any length but
/// zero), the one of largest area first. A vertex that lies exactly in the plane counts as above
/// it, so a facet in the plane is cut only along its border. `mesh` has to be consistently
/// oriented. O(n) in the triangles, O(k log k) in those cut.
std::vector<Section> slice(const TriangleMesh& mesh, const Vec3& origin, const Vec3& normal);

/// The length of the convex hull of points in a plane of that normal.
double hull_length(const std::vector<Vec3>& points, const Vec3& normal);

}  // namespace toile
