// Searches for the best seams of a whole garment.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "pattern/seams/sewn_surface.h"

namespace toile {

/// Scores of garments that differ by less are the same.
inline constexpr double same_garment = 1e-3;

/// What is known of the seams beforehand.
struct KnownSeams {
  std::vector<std::array<int, 2>> chosen;  ///< pairs of edges
  std::vector<int> taken;                  ///< edges that no other seam may use
};

/// Whether the time is over, asked from many threads. Empty: it never is.
using IsOver = std::function<bool()>;

/// Simulated annealing over sets of seams (Kirkpatrick, Gelatt, Vecchi 1983), with moves that sew
/// on from a corner to the next. Mirror partners are sewn together. The same evidence gives the
/// same seams. The work grows with the square of the number of edges.
class SeamSearch {
 public:
  /// `extra`: added to the score of each pair, edges * edges in rows; empty: nothing. Once the time
  /// is over, each search ends with the best garment that it has found.
  SeamSearch(const SeamEvidence& evidence, const SeamPairs& pairs, const SeamMeasures& weights,
             const KnownSeams& known, const std::vector<double>& extra = {}, IsOver is_over = {});

  struct Garment {
    Partners partners;
    double score = 0;
  };
  /// The garment that one search finds; searches with other numbers begin otherwise.
  /// `patience`: it looks at so many times as many garments.
  Garment search(int run, int patience = 1);
  /// The best garment that a short search finds from this one.
  Garment near(const Partners& partners);
  /// The better one of near() and search().
  Garment best_near(const Partners& partners, int run);

  /// A garment that no single move betters. A move opens a seam, or sews one: alone, with the two
  /// edges that it parts, or with the next seams at either end. Annealing passes over partners that
  /// look unlikely by themselves.
  Garment climbed(const Garment& from);

  /// The best garment that has each block of seams from the one or from the other. Blocks are the
  /// parts of the difference of both matchings (partition crossover; Whitley et al. 2009).
  Garment recombined(const Garment& best, const Garment& other);

  /// Same numbers: seams that differ in which of equal pieces they join.
  int kind(int a, int b) const { return kind_[static_cast<std::size_t>(a) * edges_ + b]; }

  /// Sews no seam of this kind from now on, but those that were known.
  void forbid(int kind);
  bool locked(int edge) const { return locked_[edge] != 0; }

  /// All that is measured of a garment.
  SeamMeasures measures(const Partners& partners);

 private:
  double score_of_partners();
  bool allowed(int a, int b) const;
  void join(int a, int b);
  void part(int a);
  bool sew(int a, int b);
  void unsew(int a);
  void sew_on(int a, int b, bool forward);
  bool sew_next(int& a, int& b);
  void try_seam(int a, int b, const std::function<bool()>& take);
  void move();
  std::vector<std::vector<int>> blocks(const Partners& a, const Partners& b) const;
  void anneal(Garment& best, double hot, double cold, int looks);
  double& pair_score(int a, int b) { return scores_[static_cast<std::size_t>(a) * edges_ + b]; }
  double pair_score(int a, int b) const {
    return scores_[static_cast<std::size_t>(a) * edges_ + b];
  }
  std::uint32_t random(std::uint32_t below);
  double random_part();

  bool is_over() const { return is_over_ && is_over_(); }

  const SeamPairs& pairs_;
  const SeamMeasures& weights_;
  IsOver is_over_;
  SewnSurface surface_;
  int edges_ = 0;
  std::vector<int> next_;
  std::vector<int> previous_;
  std::vector<int> mirror_;
  std::vector<double> scores_;  // of pairs
  std::vector<int> kind_;       // of pairs
  struct Partner {
    int edge = 0;
    double chance = 0;  // of this partner or one before it
  };
  std::vector<std::vector<Partner>> shortlist_;  // per edge
  std::vector<std::vector<int>> climbing_;       // per edge: partners, the likeliest first
  std::vector<char> locked_;
  Partners begin_;
  Partners now_;
  std::vector<BorderStep> border_;  // of now_, before the last move
  std::uint64_t seed_ = 0;
};

}  // namespace toile
