// The share of the isotropic bound of the stiffness that each node's step reckons with.
#pragma once

#include <cstddef>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/relaxation/constants.h"
#include "geometry/columns.h"

namespace toile {

/// Shares in [min_isotropic_share, max_isotropic_share], one a node. A node that moves fast has a
/// large one, for its cloth turns. A node that trembles keeps a larger one than others at rest.
class IsotropicShares {
 public:
  explicit IsotropicShares(const GarmentModel& model)
      : shares_(model.nodes, max_isotropic_share),
        least_(model.nodes, min_isotropic_share),
        last_glide_(model.nodes, Vec4{}) {
    for (const double edge : model.shortest_edge) {
      of_glide_.push_back(max_isotropic_share / (turning_glide * edge));
    }
  }

  const std::vector<double>& of_nodes() const { return shares_; }

  /// Adapts the shares of nodes `begin` to `end`, which is at most begin + 4. `glides`: metres, the
  /// last move of each of them; zero as the fourth component. `stops`: more than 0 for a node that
  /// a bound has stopped of late; it would tremble. Both have four places.
  [[gnu::always_inline]] void adapt(std::size_t begin, std::size_t end, const Vec4 (&glides)[4],
                                    const Vec4& stops);

 private:
  std::vector<double> shares_;    // per node
  std::vector<double> least_;     // per node: more where it trembles
  std::vector<double> of_glide_;  // per node, of a glide of 1 m
  Vec4s last_glide_;              // metres, per node: its last move
};

[[gnu::always_inline]] inline void IsotropicShares::adapt(std::size_t begin, std::size_t end,
                                                          const Vec4 (&glides)[4],
                                                          const Vec4& stops) {
  const Places at(begin, end);
  const Columns glide = columns_of(glides[0], glides[1], glides[2], glides[3]);
  const Columns last = at.of(last_glide_);
  const Vec4 least = at.of(least_);
  const Vec4 grown = smaller(trembling_growth * least, repeated(max_isotropic_share));
  const Vec4 shrunk = larger(trembling_decay * least, repeated(min_isotropic_share));
  // A node that turns back trembles.
  const Vec4 new_least = (stops > 0.0 || dot(glide, last) < 0.0) ? grown : shrunk;
  const Vec4 by_glide = at.of(of_glide_) * square_root(dot(glide, glide));
  const Vec4 share = larger(larger(smaller(by_glide, repeated(max_isotropic_share)),
                                   isotropic_share_decay * at.of(shares_)),
                            new_least);
  at.set(least_, new_least);
  at.set(shares_, share);
  for (std::size_t i = 0; i < end - begin; ++i) last_glide_[begin + i] = glides[i];
}

}  // namespace toile
