// The seams of a garment, and how certain each is.
#pragma once

#include "pattern/seams/seam_certainty.h"
#include "pattern/seams/seam_search.h"

namespace toile {

struct ChosenSeam {
  int a = 0;  ///< edge; less than b
  int b = 0;  ///< edge
  /// What its certainty is told from. Seams that differ in which of equal pieces they join count
  /// as one.
  SeamFeatures features{};
  /// What one of the two edges is sewn to in the best garment without this seam; -1: they stay
  /// open.
  std::array<int, 2> alternative = {-1, -1};
};

struct SeamChoice {
  std::vector<ChosenSeam> seams;  ///< ascending
  double score = 0;
  bool settled = false;  ///< searches from different beginnings ended with the same score
};

/// Chooses the seams with searches from several beginnings, then asks how certain each is. Searches
/// are repeated without each seam. Searches run in parallel. Once the time is over, searches end
/// early, and no seam is told to score more than the best garment without it. The same evidence
/// gives the same bits for any number of threads.
class SeamChooser {
 public:
  /// Runs the first searches.
  SeamChooser(const SeamEvidence& evidence, const KnownSeams& known, const IsOver& is_over = {});

  /// Runs a short search that begins with these seams.
  SeamChooser(const SeamEvidence& evidence, const KnownSeams& known, const Partners& begin,
              const IsOver& is_over = {});

  double score() const { return best_.score; }

  /// Runs more of these, and longer ones where they do not agree. Does nothing when called again.
  void settle();

  /// Settles, and runs the others. What they find that is better is taken.
  SeamChoice choose();

  /// The seams that are found without those, which tell no certainty.
  SeamChoice best() const;

 private:
  std::vector<SeamSearch::Garment> searched(int first, int count, int times) const;
  /// Per edge of the best garment: the best one without its seam; empty where the edge is open.
  std::vector<SeamSearch::Garment> found_without() const;
  /// Makes the best garment of itself and parts of these, as long as it gets better.
  void take_best_of(const std::vector<SeamSearch::Garment>& garments);
  int times_found() const;
  double share(const std::vector<SeamSearch::Garment>& garments, int a, int b) const;
  void tell_features(const std::vector<SeamSearch::Garment>& without, SeamChoice& choice) const;

  const SeamEvidence& evidence_;
  const KnownSeams& known_;
  IsOver is_over_;
  SeamPairs pairs_;
  SeamMeasures weights_;
  SeamSearch search_;
  std::vector<SeamSearch::Garment> found_;
  SeamSearch::Garment best_;
};

}  // namespace toile
