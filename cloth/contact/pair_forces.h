// Forces between cloth and near cloth: pushes, and the friction that they cause.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "cloth/contact/fastest_path.h"
#include "cloth/contact/pair_friction.h"
#include "cloth/contact/proximity.h"
#include "geometry/vec4.h"

namespace toile {

/// The push of a pair, and its forces on the four vertices of the pair.
///
/// Where two edges become parallel, their nearest points jump from one end to the other. A push
/// that jumped too would never come to rest, and mirrored folds have many such edges. So two edges
/// push the less, the more parallel they are [Li et al. 2020, Incremental Potential Contact, the
/// mollifier]. The ends of parallel edges are left to push at faces.
struct PairPush {
  NearestPoints nearest;
  double force = 0;                 ///< N: between the two sides
  std::array<Vec3, 4> on;           ///< N: on each vertex
  std::array<double, 4> stiffness;  ///< N/m: a bound at each vertex
};
/// The push of `pair` with its vertices at `at` (metres). See contact_push() for `barrier` and
/// `early`.
PairPush push_of(const ContactPair& pair, const std::array<Vec3, 4>& at, bool barrier,
                 double early = 0);

/// The pairs that a search found, and of these the active ones, which are near enough to push.
/// Forces take two passes: push() for disjoint ranges of the active pairs, which may run in
/// parallel; then add() for each vertex.
class PairForces {
 public:
  void clear() { pairs_.clear(), active_.clear(), friction_.clear(); }
  PairFriction& friction() { return friction_; }
  const PairFriction& friction() const { return friction_; }
  /// The pairs found, for a search to replace. activate() must follow.
  std::vector<ContactPair>& pairs() { return pairs_; }
  /// Finds the active pairs. `x`: metres, one a vertex. They stay valid until two sides approach by
  /// pair_activation_margin. Linear in the pairs.
  ///
  /// `ignored`: per vertex, not 0 for those whose pairs push nothing; empty: all push.
  void activate(const std::vector<Vec3>& x, const std::vector<char>& ignored = {});

  std::size_t active() const { return active_.size(); }
  /// Has to come before push() whenever vertices have moved. `x`: metres, one a vertex.
  void follow(const Vec4s& x) {
    if (active_.empty()) return;
    path_.follow(x);
    ++pushes_;
  }
  /// Finds the pushes of active pairs `begin` to `end`, with vertices at `x`, and their friction,
  /// whose anchors slide along. Pairs that can't have come near enough since they were last looked
  /// at cost next to nothing. See contact_push() for `barrier` and `early`.
  void push(std::size_t begin, std::size_t end, bool barrier, double early, const Vec4s& x);
  /// Adds the pushes on a vertex to its force (N) and a bound of their stiffness (N/m).
  [[gnu::always_inline]] void add(std::size_t vertex, Vec4& force, double& stiffness) const {
    if (active_.empty() || pushed_at_[vertex] != pushes_) return;
    const int end = first_slot_[vertex + 1];
    for (int s = first_slot_[vertex]; s < end; ++s) {
      const Vec4 slot = slots_[s];
      const double bound = slot[3];
      force += slot;
      stiffness += bound;
    }
  }

 private:
  void lay_out_slots(std::size_t vertices);

  std::vector<ContactPair> pairs_;
  std::vector<char> near_;  // per pair, whether it is active
  std::vector<ContactPair> active_;
  PairFriction friction_;  // of the active pairs
  FastestPath path_;
  /// Metres, per active pair: the path up to which its sides are surely too far apart to push.
  /// Negative for one that pushed, or was not looked at yet.
  std::vector<double> apart_until_;
  // Four slots an active pair, those of a vertex in a row, as add() reads them.
  Vec4s slots_;                  // force (N), stiffness (N/m) as the fourth; 0: pushes nothing
  std::vector<int> first_slot_;  // per vertex; then the number of slots
  std::vector<std::array<int, 4>> slots_of_;  // per active pair
  int pushes_ = 0;                            // how often vertices have moved
  std::vector<int> pushed_at_;  // per vertex, the value of pushes_ when a pair last pushed it
};

}  // namespace toile
