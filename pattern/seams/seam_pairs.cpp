#include "pattern/seams/seam_pairs.h"

#include <algorithm>
#include <utility>

#include "pattern/classify/classify.h"
#include "pattern/seams/seam_trees.h"

namespace toile {

namespace {

/// Longer over shorter side: no seam is gathered more.
constexpr double max_fullness = 4;

/// Metres: what is shorter is not meant to be sewn. mesh-pattern merges it with its neighbour.
constexpr double shortest_seam = 5e-4;

/// Logarithm of the odds of a pair that is looked at once, not from all four sides. It saves time
/// with hundreds of edges; half and double were not measured.
constexpr double hopeless = -5;

}  // namespace

SeamPairs::SeamPairs(const SeamEvidence& evidence)
    : edges_(evidence.edges), words_(evidence.words), features_(evidence) {}

bool SeamPairs::possible(int a, int b) const {
  if (a == b) return false;
  if (std::min(edges_[a].length, edges_[b].length) < shortest_seam) return false;
  const PanelWords& first = words_[edges_[a].ref.panel];
  const PanelWords& second = words_[edges_[b].ref.panel];
  if (!may_meet(first.role, second.role)) return false;
  // Neighbours on an outline are sewn as darts alone.
  if (edges_[a].next == b && edges_[b].corner < sharpest_dart_tip) return false;
  if (edges_[b].next == a && edges_[a].corner < sharpest_dart_tip) return false;
  const double ratio = edges_[a].length / edges_[b].length;
  return ratio < max_fullness && ratio > 1 / max_fullness;
}

SeamMeasures SeamPairs::measures(int a, int b) const {
  SeamMeasures measures{};
  measures[static_cast<int>(SeamMeasure::seam)] = 1;
  measures[static_cast<int>(SeamMeasure::likely)] = odds(a, b);
  return measures;
}

double SeamPairs::odds(int a, int b) const {
  if (a > b) std::swap(a, b);
  const double once = sewn_logit(features_.of(a, b, false));
  if (once < hopeless) return once;
  return (once + sewn_logit(features_.of(b, a, false)) + sewn_logit(features_.of(a, b, true)) +
          sewn_logit(features_.of(b, a, true))) /
         4;
}

}  // namespace toile
