// Coulomb's friction of cloth on cloth.
#pragma once

#include <cstddef>
#include <vector>

#include "cloth/contact/friction_state.h"
#include "cloth/contact/proximity.h"
#include "geometry/vec4.h"

namespace toile {

/// Friction of the pairs that press: a spring between the two points where a pair began to, along
/// the cloth, with the push's force times a coefficient as its most; beyond that the points slide.
/// Of two fabrics the smoother one's coefficient counts: a lining slides on anything, and what has
/// no friction has it against nothing.
class PairFriction {
 public:
  /// Coulomb's coefficient per vertex, from the next activate() on; what comes after them, of
  /// layers, is as rough as what rubs on it. Empty: there is no friction, and it costs nothing.
  void set_coefficients(std::vector<double> coefficients);
  /// Lets the next activate() hold pairs so, instead of where they come to press.
  void set_anchors(std::vector<PairAnchor> anchors) { given_anchors_ = std::move(anchors); }
  /// What friction holds, sorted by the vertices.
  std::vector<PairAnchor> anchors() const;

  /// The pairs to come in rub(), by their index. Those that it holds it goes on holding.
  void activate(const std::vector<ContactPair>& pairs);
  bool empty() const { return states_.empty(); }
  void clear() { states_.clear(), given_anchors_.clear(); }
  /// Adds the force (N) on each vertex of pair i, which is pushed apart with `push` (N), and a
  /// bound of their stiffness (N/m) as the fourth. Different pairs may come side by side.
  void add(std::size_t i, const NearestPoints& nearest, double push, const Vec4s& x,
           Vec4* on_vertices);

 private:
  struct PairState {
    double friction = 0;  // Coulomb
    bool sticks = false;
    PairAnchor anchor;
  };
  double coefficient(const ContactPair& pair) const;

  std::vector<double> coefficients_;
  std::vector<PairState> states_;
  std::vector<PairAnchor> given_anchors_;
};

}  // namespace toile
