// Contact of long edges of the cloth with the body.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "cloth/contact/body_contact.h"
#include "cloth/model/garment_model.h"
#include "cloth/relaxation/force_options.h"
#include "geometry/adjacency.h"
#include "geometry/vec4.h"

namespace toile {

/// Contact of the middles of long edges with the body, as of vertices. Without it, a coarse
/// triangle cuts the curves of the body, for only its vertices keep off. Half of each force goes to
/// each end of the edge.
class EdgeContacts {
 public:
  /// Takes the edges that are longer than `shortest` metres, with vertices at `x` (metres).
  /// `friction` has each vertex's coefficient on the body; an edge has the mean of its ends.
  /// `approach_bound` has the metres that each vertex may approach the body in a step; an edge has
  /// the larger one of its ends. O(n log n).
  EdgeContacts(const std::vector<Triangle>& triangles, const Vec4s& x, double shortest,
               const std::vector<double>& friction, const std::vector<double>& approach_bound);

  /// Whether no edge is long enough.
  bool empty() const { return contacts_.empty(); }

  /// Makes the next forces find the body anew. Anchors stay.
  void forget();

  /// Anchors of the middles that stick, sorted by edge.
  std::vector<EdgeAnchor> anchors() const;
  /// Makes middles stick at `anchors`, instead of where they first touch the body.
  void set_anchors(const std::vector<EdgeAnchor>& anchors);

  std::size_t edges() const { return edges_.size(); }
  /// First pass: finds the forces of the body on the middles of edges `begin` to `end`. `x`:
  /// metres, one a vertex. The scene of the model has a body.
  void push(std::size_t begin, std::size_t end, const GarmentModel& model,
            const ForceOptions& options, const Vec4s& x);
  /// Second pass: adds the forces (N) on vertices `begin` to `end` to `force`, and a bound of their
  /// stiffness (N/m) as the fourth component.
  void add(std::size_t begin, std::size_t end, Vec4s& force) const;

 private:
  std::vector<std::array<int, 2>> edges_;
  std::vector<BodyContact> contacts_;
  std::vector<double> friction_;        // Coulomb's coefficient, per edge
  std::vector<double> approach_bound_;  // metres, per edge
  Vec4s forces_;                        // N, per edge, on each end; stiffness (N/m) as the fourth
  Vec4s free_balls_;          // per edge: centre and squared radius of a ball without contact
  std::vector<char> pushed_;  // per edge, whether its force counts
  Adjacency<int> edges_of_;   // per vertex
};

}  // namespace toile
