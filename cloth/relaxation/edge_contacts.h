// Contact of a coarse cloth with the body between its vertices.
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

/// The middles of long edges touch the body as vertices do: else, with only its vertices held off,
/// a coarse triangle cuts the curves of the body. Their forces go to the ends in halves.
class EdgeContacts {
 public:
  /// Takes the edges of the triangles that are longer than `shortest` metres, with vertices at `x`.
  /// `friction` is that of each vertex, on the body; an edge has the mean of its ends';
  /// `approach_bound` the metres it may come down onto the body in a step; an edge, the more of its
  /// ends'.
  EdgeContacts(const std::vector<Triangle>& triangles, const Vec4s& x, double shortest,
               const std::vector<double>& friction, const std::vector<double>& approach_bound);

  bool empty() const { return contacts_.empty(); }

  /// Has the body looked at again before the next forces.
  void forget();

  /// Where friction holds the middles, sorted by their edges.
  std::vector<EdgeAnchor> anchors() const;
  /// Lets friction hold them there, instead of where they come to touch the body.
  void set_anchors(const std::vector<EdgeAnchor>& anchors);

  std::size_t edges() const { return edges_.size(); }
  /// First pass, of edges `begin` to `end`: what the body does to their middles, with vertices at
  /// `x`. The model's scene has a body.
  void push(std::size_t begin, std::size_t end, const GarmentModel& model,
            const ForceOptions& options, const Vec4s& x);
  /// Second pass, of vertices `begin` to `end`: adds the forces (N) to theirs, and a bound of their
  /// stiffness (N/m) as the fourth of them.
  void add(std::size_t begin, std::size_t end, Vec4s& force) const;

 private:
  std::vector<std::array<int, 2>> edges_;
  std::vector<BodyContact> contacts_;
  std::vector<double> friction_;        // Coulomb, per edge
  std::vector<double> approach_bound_;  // metres, per edge
  Vec4s forces_;                        // per edge, stiffness as the fourth
  Vec4s free_;                // per edge: nothing touches it within the root of the fourth
  std::vector<char> pushed_;  // per edge: its force counts
  Adjacency<int> edges_of_;   // per vertex
};

}  // namespace toile
