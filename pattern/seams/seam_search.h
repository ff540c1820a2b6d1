// Chooses the seams of a whole garment at once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pattern/seams/sewn_surface.h"

namespace toile {

struct ChosenSeam {
  int a = 0;  ///< edge; less than b
  int b = 0;  ///< edge
  /// Share of the searches with shaken weights that sew it. Seams that differ in which of equal
  /// pieces they join count as this seam. 0 to 1.
  double confidence = 0;
  /// What one of the two edges is sewn to in the first of them without this seam; -1: it stays
  /// open.
  std::array<int, 2> alternative = {-1, -1};
};

struct SeamChoice {
  std::vector<ChosenSeam> seams;  ///< ascending
  double worth = 0;
  bool settled = false;  ///< searches from different beginnings ended with the same worth
};

/// What is known of the seams beforehand.
struct KnownSeams {
  std::vector<std::array<int, 2>> chosen;  ///< pairs of edges
  std::vector<int> taken;                  ///< edges that no other seam may use
};

/// Simulated annealing over sets of seams (Kirkpatrick, Gelatt, Vecchi 1983), with moves that sew
/// on from a corner to the next. Mirror partners are sewn together. The same evidence gives the
/// same seams. The work grows with the square of the number of edges.
class SeamSearch {
 public:
  /// `extra`: added to the worth of each pair, edges * edges in rows; empty: nothing.
  SeamSearch(const SeamEvidence& evidence, const SeamPairs& pairs, const SeamMeasures& weights,
             const KnownSeams& known, const std::vector<double>& extra = {});

  struct Garment {
    Partners partners;
    double worth = 0;
  };
  /// The best garment of several searches; `times`: how many of them found its worth.
  Garment best(int searches, int& times);
  /// The best garment that is found from this one and from the beginning.
  Garment best_near(const Partners& partners, int run);

  /// Same numbers: seams that differ in which of equal pieces they join.
  int kind(int a, int b) const { return kind_[static_cast<std::size_t>(a) * edges_ + b]; }

  /// All that is measured of a garment.
  SeamMeasures measures(const Partners& partners);

 private:
  double worth_of_partners();
  bool allowed(int a, int b) const;
  void join(int a, int b);
  void part(int a);
  bool sew(int a, int b);
  void unsew(int a);
  void sew_on(int a, int b, bool forward);
  void move();
  void anneal(Garment& best, double hot, double cold, int looks);
  Garment search(int run);
  double& pair_worth(int a, int b) { return worth_[static_cast<std::size_t>(a) * edges_ + b]; }
  double pair_worth(int a, int b) const { return worth_[static_cast<std::size_t>(a) * edges_ + b]; }
  std::uint32_t random(std::uint32_t below);
  double random_part();

  const SeamPairs& pairs_;
  const SeamMeasures& weights_;
  SewnSurface surface_;
  int edges_ = 0;
  std::vector<int> next_;
  std::vector<int> previous_;
  std::vector<int> mirror_;
  std::vector<double> worth_;  // of pairs
  std::vector<int> kind_;      // of pairs
  struct Partner {
    int edge = 0;
    double chance = 0;  // of this partner or one before it
  };
  std::vector<std::vector<Partner>> shortlist_;  // per edge
  std::vector<char> locked_;
  Partners begin_;
  Partners now_;
  std::vector<BorderStep> border_;  // of now_, before the last move
  std::uint64_t seed_ = 0;
};

/// The seams of a garment, and how certain each is: weights are shaken, and the searches are asked
/// again (perturb and MAP; Papandreou, Yuille 2011).
SeamChoice choose_seams(const SeamEvidence& evidence, const SeamPairs& pairs,
                        const SeamMeasures& weights, const KnownSeams& known);

}  // namespace toile
