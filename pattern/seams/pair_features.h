// What the score of a pair of edges is learned from.
#pragma once

#include <array>
#include <vector>

#include "pattern/seams/seam_evidence.h"

namespace toile {

/// Features of an edge, and of a pair of edges.
inline constexpr int edge_features = 26;
inline constexpr int joint_features = 36;
inline constexpr int pair_features = 2 * edge_features + joint_features;

using PairRow = std::array<float, pair_features>;

/// Describes pairs of edges that may be sewn, by shapes, by their rivals, and by names. Nothing is
/// told of the order of the panels in the file.
class PairFeatures {
 public:
  /// O(edges^2).
  explicit PairFeatures(const SeamEvidence& evidence);

  /// Describes the edges that the evidence has gained behind the others, and forgets those that it
  /// has lost there. They are parts of edges. O(edges) for each.
  void follow();

  /// a is described first: of(b, a) is the same pair. `mirrored`: as in the mirror image of the
  /// garment. O(edges).
  PairRow of(int a, int b, bool mirrored) const;

 private:
  struct Panel {
    int first = 0;
    int count = 0;
    double perimeter = 0;  // metres
    double area = 0;       // square metres
    double width = 0;      // metres, across the warp
    double height = 0;     // metres, along the warp
    Vec2 low = Vec2::Zero();
    int alike = 0;  // panels of its shape, itself included
    bool is_own_mirror = false;
    double longest = 0;  // metres, of its edges
  };

  using EdgeRow = std::array<float, edge_features>;
  EdgeRow described(int edge, bool against) const;
  void add_rivals(int edge);
  double matching_length(const Panel& a, const Panel& b) const;

  const SeamEvidence& evidence_;
  std::vector<Panel> panels_;
  std::vector<double> matching_;  // panels * panels: share of the length with an equal edge
  int whole_edges_ = 0;           // that are no parts
  std::vector<int> near_;         // edges of other shapes within 1 %
  std::vector<double> nearest_;   // logarithm: the likest length of another shape
  std::vector<std::array<EdgeRow, 2>> rows_;
  double largest_area_ = 0;
};

}  // namespace toile
