// Cloth near cloth, its own or that of a motionless layer below: which vertices and edges come
// close, and how far each may move before they have to be looked for again.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// A vertex near a triangle, or an edge near an edge, of one surface or of two layers.
struct ContactPair {
  std::array<int, 4> vertices;  ///< vertex, then the triangle's corners; or both edges' ends
  bool edges;                   ///< two edges, not vertex and triangle
  double gap;                   ///< metres: nearer than this, they push each other apart
};

/// Nearest points of a pair as signed weights of its four vertices: their weighted sum is the
/// vector from the second side to the first, its length the distance.
struct NearestPoints {
  std::array<double, 4> weights;
  Vec3 apart;
};
/// Of a pair with its vertices at `at`: two edges, or vertex and triangle.
NearestPoints nearest_points(bool edges, const std::array<Vec3, 4>& at);
NearestPoints nearest_points(const ContactPair& pair, const std::vector<Vec3>& x);

/// Force (N) that pushes a pair at `distance` apart, a bound of its stiffness (N/m), which it has
/// `early` metres before it pushes, and its energy (J). The force is linear in how much of the gap
/// is used up; with `barrier`, beyond half the gap as 1/distance, so that nothing can press the two
/// to touch [Chen et al. 2025, the two-stage activation]. A barrier belongs to a state without
/// intersections: it would hold a tangle fast.
struct ContactPush {
  double force = 0;
  double stiffness = 0;
  double energy = 0;
};
ContactPush contact_push(double distance, double gap, bool barrier, double early = 0);

/// Finds the close pairs of a surface whose connectivity stays the same. Vertices that are one
/// node, or are to become one when a seam closes, never pair with what holds the other. Between
/// neighbours in the mesh the gap is reduced to what the flat mesh leaves between them, so that a
/// sheet does not push itself apart.
class ProximitySearch {
 public:
  /// `node` and `shortest_edge` (metres, at rest) per vertex; nodes are numbered from 0.
  ProximitySearch(const std::vector<Triangle>& triangles, const std::vector<int>& node,
                  const std::vector<double>& shortest_edge);

  /// Adds cloth that does not move. Its vertices follow the surface's own in all that find() takes
  /// and gives; `triangles` are numbered within the layer, of `vertices` vertices. Pairs of a layer
  /// with itself are not looked for; those with the surface keep `gap` metres, and only those come
  /// that are near enough to use it up before the bounds are.
  void add_layer(const std::vector<Triangle>& triangles, int vertices, double gap);

  /// `x` holds the surface's vertices and then the layer's. All pairs nearer than `radius`, in an
  /// order that does not depend on the threads, and for each vertex in `bound` how far it may move:
  /// as long as none moves farther than that, nothing that is apart can come to intersect [Chen et
  /// al. 2025, Offset Geometric Contact]. `gap` is what non-neighbours keep. With
  /// `skip_neighbours`, pairs that are neighbours across a seam or in a panel are left out, of the
  /// bounds too: while a seam closes, they have to come past each other, and can come to intersect.
  /// About O(n) while few things are near each other.
  void find(const std::vector<Vec3>& x, double radius, double gap, std::vector<ContactPair>& pairs,
            std::vector<double>& bound, bool skip_neighbours) const;

  /// As find(), but looks anew only at what has used up a good part of its bound, which is often a
  /// handful of vertices; the others keep theirs. `at` holds, per vertex, the place from where its
  /// bound counts: the `x` of a find(), or what an update() left. Costs the making of the grids and
  /// a search for what has moved.
  void update(const std::vector<Vec3>& x, double radius, double gap,
              std::vector<ContactPair>& pairs, std::vector<double>& bound, std::vector<Vec3>& at,
              bool skip_neighbours) const;

 private:
  struct NearPair {
    ContactPair pair;
    double distance;
  };
  using NearPairs = std::vector<NearPair>;

  /// What is asked for: pairs nearer than `radius` of which some vertex is `wanted`; none given:
  /// all.
  struct Query {
    const std::vector<Vec3>& x;
    double radius;
    const std::vector<char>& wanted;
    bool wants(std::size_t v) const { return wanted.empty() || wanted[v] != 0; }
  };
  void consider(const ContactPair& pair, const Query& query, NearPairs& found) const;
  void point_and_triangle(int v, int t, const Query& query, NearPairs& found) const;
  void two_edges(int e, int f, const Query& query, NearPairs& found) const;
  NearPairs triangles_near_vertices(const Query& query) const;
  NearPairs others_near_wanted_triangles(const Query& query) const;
  NearPairs edges_near_edges(const Query& query) const;
  NearPairs near_pairs(const Query& query) const;
  /// What a pair keeps, metres; negative: it needs no force before the next search.
  double gap_to_keep(const NearPair& found, double gap) const;
  bool of_layer(int vertex) const { return vertex >= moving_vertices_; }
  bool of_layer(const ContactPair& pair) const {
    return of_layer(pair.vertices[0]) || of_layer(pair.vertices[2]);
  }
  bool same_node(int a, int b) const { return node_[a] == node_[b]; }
  bool neighbours(int a, int b) const;
  bool neighbours(const ContactPair& pair) const;
  double neighbour_gap(const ContactPair& pair) const;

  std::vector<Triangle> triangles_;
  std::vector<std::array<int, 2>> edges_;
  int moving_vertices_;
  int moving_triangles_;
  int moving_edges_;
  double layer_gap_ = 0;
  std::vector<int> node_;
  std::vector<double> shortest_edge_;
  std::vector<int> ring_first_;  // neighbours of a node, sorted
  std::vector<int> ring_;
};

}  // namespace toile
