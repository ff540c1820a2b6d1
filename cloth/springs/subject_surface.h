// The motionless surface that a garment is dressed over, prepared for collisions. It knows its
// edges, its normals, and which directions off an edge or a vertex are outward.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/adjacency.h"
#include "geometry/surface_distance.h"
#include "geometry/types.h"

namespace toile {

/// An edge of the subject and the triangles at it.
struct SubjectEdge {
  int a = 0;
  int b = 0;
  Vec3 normal = Vec3::Zero();  ///< mean of its triangles' normals, of unit length
  /// Where each triangle lies, seen from the edge: of unit length, square to it, in the triangle.
  std::array<Vec3, 2> inward = {Vec3::Zero(), Vec3::Zero()};
  std::array<int, 2> facets = {-1, -1};
  /// Not exactly two triangles: the border of an open sheet, which has no side that is inside.
  bool rim = false;
  /// Something straight across it can touch it before anything else: it is a rim, or convex.
  bool ridge = true;
};

/// What of a triangle is nearest to a point: its inside, an edge, or a vertex.
struct SubjectNearest {
  Vec3 point;
  double distance = 0;  ///< metres; negative behind the surface
  Vec3 direction;       ///< of unit length, outward: from the point on the surface when in front
  bool local = false;   ///< no neighbouring triangle comes nearer
};

/// The body and the sheets of cloth that are already dressed, as one outward-oriented mesh. Sheets
/// may be open and may lie over each other. So the nearest feature alone decides whether a point is
/// in front of the surface or behind it. Triangles without area take no part.
class SubjectSurface {
 public:
  /// Keeps a copy. Throws Error when no triangle has an area, or a point is not finite.
  explicit SubjectSurface(const TriangleMesh& mesh);

  const TriangleMesh& mesh() const { return mesh_; }
  const Vec3& point(int vertex) const { return mesh_.points[vertex]; }
  const Vec3& facet_normal(int facet) const { return facet_normals_[facet]; }
  /// Mean of the normals of the facets around the vertex [Zhong & Xu 2009].
  const Vec3& vertex_normal(int vertex) const { return vertex_normals_[vertex]; }
  bool on_rim(int vertex) const { return vertex_on_rim_[vertex] != 0; }
  /// Something flat over it can touch it before anything else at it.
  bool is_tip(int vertex) const { return vertex_is_tip_[vertex] != 0; }
  /// Vertices joined to `vertex` by an edge.
  std::span<const int> neighbours(int vertex) const { return ring_[vertex]; }
  const SubjectEdge& edge(int number) const { return edges_[number]; }
  /// Side i of a facet runs from its corner i to the next.
  const std::array<int, 3>& facet_edges(int facet) const { return facet_edges_[facet]; }
  /// Each edge and vertex belongs to one facet, so that a list of facets counts them once.
  bool owns_edge(int facet, int side) const { return (owned_[facet] >> side & 1) != 0; }
  bool owns_vertex(int facet, int corner) const { return (owned_[facet] >> (3 + corner) & 1) != 0; }

  /// Distance of `p` to the whole surface, metres, never negative.
  double distance(const Vec3& p) const;
  /// Facets that meet the box, ascending. Those without area are left out.
  void facets_in_box(const Vec3& low, const Vec3& high, std::vector<int>& found) const;
  /// What of the facet is nearest to `p`.
  SubjectNearest nearest(const Vec3& p, int facet) const;

  /// Whether `direction` points to where the edge or vertex is the nearest feature of the surface.
  bool faces(const SubjectEdge& edge, const Vec3& direction) const;
  bool faces(int vertex, const Vec3& direction) const;

 private:
  void build_edges();
  void build_vertices();
  bool find_tip(int vertex) const;
  SubjectNearest at_edge(const Vec3& p, const Vec3& point, const SubjectEdge& edge) const;
  SubjectNearest at_vertex(const Vec3& p, int vertex) const;

  TriangleMesh mesh_;
  SurfaceDistance distance_;
  std::vector<Vec3> facet_normals_;
  std::vector<SubjectEdge> edges_;
  std::vector<std::array<int, 3>> facet_edges_;
  std::vector<unsigned char> owned_;
  std::vector<Vec3> vertex_normals_;
  std::vector<Vec3> side_normals_;  // of the vertices, weighted by angle: they tell the side
  std::vector<char> vertex_on_rim_;
  std::vector<char> vertex_is_tip_;
  Adjacency<int> ring_;  // at each vertex, those joined to it by an edge
};

}  // namespace toile
