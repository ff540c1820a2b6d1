// Coulomb friction of cloth on cloth.
#pragma once

#include <cstddef>
#include <vector>

#include "cloth/contact/friction_state.h"
#include "cloth/contact/proximity.h"
#include "geometry/vec4.h"

namespace toile {

/// Friction of the pairs that press. It is a spring along the cloth, between the two points where
/// the pair began to press. The spring carries at most the push times the coefficient; beyond that
/// its anchors slide.
///
/// Of two fabrics, the lower coefficient counts: a lining slides on anything, and cloth without
/// friction slides on everything.
class PairFriction {
 public:
  /// Sets Coulomb's coefficient per vertex, from the next activate() on. Vertices of layers have
  /// higher indices and no coefficient: there the other side's counts. Without a positive
  /// coefficient there is no friction, and it costs nothing.
  void set_coefficients(std::vector<double> coefficients);
  /// Makes the pairs of the next activate() stick at `anchors`, sorted by vertices and kind,
  /// instead of where they begin to press.
  void set_anchors(std::vector<PairAnchor> anchors) { given_anchors_ = std::move(anchors); }
  /// The anchors of the pairs that stick, sorted by vertices and kind.
  std::vector<PairAnchor> anchors() const;

  /// Sets the pairs that add() knows by their index. Pairs that stick go on sticking. O(n log n).
  void activate(const std::vector<ContactPair>& pairs);
  bool empty() const { return states_.empty(); }
  void clear() { states_.clear(), given_anchors_.clear(); }
  /// Adds the friction (N) on each vertex of pair i to `on_vertices`, and a bound of its stiffness
  /// (N/m) as the fourth component. `push` (N) is the force between the two sides; `x`: metres, one
  /// a vertex. Different pairs may be added at the same time.
  void add(std::size_t i, const NearestPoints& nearest, double push, const Vec4s& x,
           Vec4* on_vertices);

 private:
  struct PairState {
    double friction = 0;  // Coulomb's coefficient
    bool sticks = false;
    PairAnchor anchor;
  };
  double coefficient(const ContactPair& pair) const;

  std::vector<double> coefficients_;
  std::vector<PairState> states_;
  std::vector<PairAnchor> given_anchors_;
};

}  // namespace toile
