// What of the subject is near each triangle of the cloth, kept while nothing moves far.
#pragma once

#include <array>
#include <vector>

#include "cloth/springs/subject_surface.h"
#include "geometry/types.h"

namespace toile {

/// A triangle of the cloth. Each node and each edge of the cloth belongs to one triangle. So a loop
/// over the triangles meets each once.
struct ClothTriangle {
  Triangle nodes = {-1, -1, -1};
  std::array<bool, 3> owns_node = {};
  std::array<bool, 3> owns_side = {};        ///< side i runs from corner i to the next
  std::array<int, 3> across = {-1, -1, -1};  ///< node beyond side i, -1 at a border
  bool whole = false;                        ///< three different nodes
};

/// Two things that were `distance` metres apart when they were looked for.
struct Candidate {
  double distance;
  int own;      ///< corner or side of the cloth's triangle
  int subject;  ///< facet, edge or vertex
};

/// What is near one triangle, each list by ascending distance.
struct NearTriangle {
  /// Where its corners were when the distances were measured.
  std::array<Vec3, 3> at = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  double reach = -1;              ///< metres; facets nearer than that to a node at `at` are listed
  double pair_reach = -1;         ///< metres; the same of edges and vertices
  bool listed = false;            ///< the subject was near enough for lists
  bool behind = false;            ///< one of its own nodes was behind the surface
  std::vector<Candidate> facets;  ///< of the nodes that it owns
  std::vector<Candidate> edges;   ///< of the sides that it owns
  std::vector<Candidate> vertices;  ///< of the triangle itself

  /// How far its farthest-moved corner is from where the lists were made, metres.
  double moved(const Triangle& nodes, const std::vector<Vec3>& x) const;
};

/// The lists of near facets, edges and vertices of all triangles of the cloth. The subject does not
/// move. So it is searched again only for a triangle that has used up its margin.
/// Valleys and hollows are not listed: nothing straight can touch such an edge or vertex first.
class CollisionCandidates {
 public:
  /// `behind_depth`: how far behind the surface a node is still looked after, metres.
  CollisionCandidates(const SubjectSurface& subject, double behind_depth)
      : subject_(subject), behind_depth_(behind_depth) {}

  /// New triangles of the cloth; lists of triangles that stay as they were are kept.
  void set_cloth(const std::vector<Triangle>& triangles);
  const std::vector<ClothTriangle>& cloth() const { return cloth_; }

  /// The lists of triangle `t`. They are good for facets within `reach` of its nodes at `x`, and
  /// for edges and vertices within `pair_reach`, which is no more than `reach`. A new search uses
  /// `margin` metres more.
  /// The distances of listed items are measured again more often. So a list can be read from the
  /// front, only as far as matters. Different triangles may be refreshed at the same time.
  const NearTriangle& refreshed(int t, const std::vector<Vec3>& x, double reach, double pair_reach,
                                double margin);
  const NearTriangle& near(int t) const { return near_[t]; }

 private:
  void ask(const ClothTriangle& triangle, NearTriangle& near) const;
  void measure(NearTriangle& near) const;

  const SubjectSurface& subject_;
  double behind_depth_;
  std::vector<ClothTriangle> cloth_;
  std::vector<NearTriangle> near_;
};

}  // namespace toile
