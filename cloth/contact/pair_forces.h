// Pushes between cloth and cloth that came near each other, and the friction that they cause.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "cloth/contact/pair_friction.h"
#include "cloth/contact/proximity.h"
#include "geometry/adjacency.h"
#include "geometry/vec4.h"

namespace toile {

/// What a pair presses with, and how that acts on its four vertices: forces (N) and a bound of
/// their stiffness (N/m). `barrier` and `early`: see contact_push().
///
/// Where two edges become parallel, what is nearest on them jumps from one end to the other. A push
/// that jumped with it would never come to rest, and mirrored folds are full of such pairs: edges
/// push the less the more parallel they are [Li et al. 2020, Incremental Potential Contact, the
/// mollifier], and leave it to their ends, which push at faces.
struct PairPush {
  NearestPoints nearest;
  double force = 0;
  std::array<Vec3, 4> on;
  std::array<double, 4> stiffness;
};
PairPush push_of(const ContactPair& pair, const std::array<Vec3, 4>& at, bool barrier,
                 double early = 0);

/// The pairs of a search, and of these the ones that are near enough to push. Forces take two
/// passes: push() over disjoint ranges of the active pairs, then add() for each vertex.
class PairForces {
 public:
  /// How far two sides may come nearer before who is active has to be told again, metres: each
  /// vertex half of it.
  static constexpr double margin = 0.001;

  void clear() { pairs_.clear(), active_.clear(), slots_of_.clear(), friction_.clear(); }
  PairFriction& friction() { return friction_; }
  const PairFriction& friction() const { return friction_; }
  /// All that a search found, to be kept by it.
  std::vector<ContactPair>& pairs() { return pairs_; }
  /// Tells anew which pairs are near, with all vertices at `x`.
  void activate(const std::vector<Vec3>& x);

  std::size_t active() const { return active_.size(); }
  /// Pushes of active pairs `begin` to `end`, and their friction, which slides along. `barrier`
  /// and `early`: see contact_push().
  void push(std::size_t begin, std::size_t end, bool barrier, double early, const Vec4s& x);
  /// Adds the pushes on a vertex to its force (N) and a bound of their stiffness (N/m).
  [[gnu::always_inline]] void add(std::size_t vertex, Vec4& force, double& stiffness) const {
    if (slots_of_.empty()) return;
    for (const int s : slots_of_[vertex]) {
      const Vec4 slot = slots_[s];
      const double bound = slot[3];
      force += slot;
      stiffness += bound;
    }
  }

 private:
  std::vector<ContactPair> pairs_;
  std::vector<char> near_;  // per pair: is active
  std::vector<ContactPair> active_;
  PairFriction friction_;    // of the active pairs
  Vec4s slots_;              // force, and the stiffness as the fourth; four an active pair
  Adjacency<int> slots_of_;  // per vertex; empty: none is active
};

}  // namespace toile
