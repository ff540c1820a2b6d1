// Bounds on motion from the proximity of cloth to itself and to motionless layers. They are the
// close pairs, and how far each vertex may move so that nothing comes to intersect.
#pragma once

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/adjacency.h"
#include "geometry/types.h"

namespace toile {

/// A vertex near a triangle, or an edge near an edge, of one surface or of two layers.
struct ContactPair {
  std::array<int, 4> vertices;  ///< a vertex and a triangle's corners; or the ends of two edges
  bool edges;                   ///< whether the pair is two edges, not vertex and triangle
  double gap;                   ///< metres: nearer than this, the two sides push each other apart
  /// Weights of the nearest points when they were last found; all 0 before.
  std::array<float, 4> nearest = {};
};

/// Nearest points of the two sides of a pair, as signed weights of its four vertices. Weights of
/// the first side add up to 1, those of the second to -1.
struct NearestPoints {
  std::array<double, 4> weights;
  Vec3 apart;  ///< metres: from the second side to the first, the weighted sum of the vertices
};
/// Nearest points of two edges, or of a vertex and a triangle, with their vertices at `at`
/// (metres).
NearestPoints nearest_points(bool edges, const std::array<Vec3, 4>& at);
/// The same for a pair of the vertices `x` (metres).
NearestPoints nearest_points(const ContactPair& pair, const std::vector<Vec3>& x);
/// What the last nearest points of a pair tell of its distance, without finding them anew. Good to
/// within last_nearest_slack.
struct DistanceBounds {
  double least = 0;                                       ///< metres
  double most = std::numeric_limits<double>::infinity();  ///< metres
};
/// Metres: more than rounding makes of such bounds.
inline constexpr double last_nearest_slack = 1e-6;
DistanceBounds distance_bounds(const ContactPair& pair, const std::array<Vec3, 4>& at);
/// Keeps `nearest` as the last nearest points of a pair.
inline void keep_nearest(const NearestPoints& nearest, ContactPair& pair) {
  for (int i = 0; i < 4; ++i) pair.nearest[i] = static_cast<float>(nearest.weights[i]);
}
/// Whether the two sides of a pair of the vertices `x` are nearer than `reach` (metres). Finds the
/// nearest points only where the last ones don't tell.
bool is_nearer(ContactPair& pair, const std::vector<Vec3>& x, double reach);

/// The push of a pair at `distance` metres.
///
/// The force is linear in the part of the gap that is used up. With `barrier`, it grows as
/// 1/distance from half the gap on, so that nothing can press the two sides to touch [Chen et al.
/// 2025, the two-stage activation]. A barrier needs a state without intersections: it would hold a
/// tangle fast. The stiffness acts from `early` metres before the push on.
struct ContactPush {
  double force = 0;      ///< N
  double stiffness = 0;  ///< N/m: a bound
  double energy = 0;     ///< J
};
ContactPush contact_push(double distance, double gap, bool barrier, double early = 0);

/// Finds the close pairs of a surface whose connectivity stays the same. Vertices of one node, or
/// of nodes that a seam will join, form no pair with a triangle or an edge at that node.
///
/// Between neighbours in the mesh the gap is reduced to the distance that the flat mesh leaves
/// them. So a sheet does not push itself apart.
class ProximitySearch {
 public:
  /// `triangles` hold indices of vertices. `node` holds the node of each vertex, numbered from 0.
  /// `shortest_edge` holds the length (metres, at rest) of the shortest edge at each vertex.
  ProximitySearch(const std::vector<Triangle>& triangles, const std::vector<int>& node,
                  const std::vector<double>& shortest_edge);

  /// Adds a layer of cloth that does not move, of `vertices` vertices. `triangles` are numbered
  /// within the layer. In all arguments of find() and update(), its vertices follow those of the
  /// surface. Pairs within a layer are not searched for. Pairs with the surface keep `gap` metres.
  /// Only those are found that can come nearer than that before the bounds are used up.
  void add_layer(const std::vector<Triangle>& triangles, int vertices, double gap);

  /// Finds all pairs nearer than `radius` metres, in an order that does not depend on the threads.
  /// `x`: metres, one a vertex. Pairs that are no neighbours keep `gap` metres.
  ///
  /// `bound` receives the metres that each vertex may move. As long as no vertex moves farther,
  /// surfaces that are apart cannot come to intersect [Chen et al. 2025, Offset Geometric Contact].
  ///
  /// With `skip_neighbours`, neighbours across a seam or in a panel are left out, also of the
  /// bounds. While a seam closes they have to pass each other, and they can come to intersect.
  ///
  /// About O(n) while few things are near each other.
  void find(const std::vector<Vec3>& x, double radius, double gap, std::vector<ContactPair>& pairs,
            std::vector<double>& bound, bool skip_neighbours) const;

  /// Does the same as find(), but searches only around vertices that have used up much of their
  /// bound, often a handful. The other bounds stay. `at` holds the position (metres) from which the
  /// bound of each vertex counts. It is the `x` of a find(), or the result of an update(). The cost
  /// is that of the grids, O(n), and of a search around the moved vertices.
  void update(const std::vector<Vec3>& x, double radius, double gap,
              std::vector<ContactPair>& pairs, std::vector<double>& bound, std::vector<Vec3>& at,
              bool skip_neighbours) const;

 private:
  struct NearPair {
    ContactPair pair;
    double distance;
  };
  using NearPairs = std::vector<NearPair>;

  /// Asks for the pairs nearer than `radius` metres that have a wanted vertex. Without `wanted`,
  /// all vertices are.
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
  /// Metres that a pair keeps; negative where it needs no force before the next search.
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
  int nodes_ = 0;
  Adjacency<int> neighbours_;  // per node, the nodes it shares an edge with, sorted; none of layers
};

}  // namespace toile
