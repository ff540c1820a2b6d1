// What speaks for and against sewing two edges together, for each pair of edges.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "pattern/seams/panel_symmetry.h"
#include "pattern/seams/panel_words.h"
#include "pattern/seams/seam_weights.h"
#include "pattern/seams/walked_edges.h"

namespace toile {

/// Radians: the inner angle at the tip of a dart is larger.
inline constexpr double sharpest_dart_tip = 285 * std::numbers::pi / 180;

/// What seams are found from.
struct SeamEvidence {
  std::vector<WalkedEdge> edges;
  std::vector<PanelWords> words;  ///< per panel
  std::vector<int> mirror;        ///< per edge, see mirror_partners()
  std::vector<char> turned_over;  ///< per panel, see walked_edges()
  std::vector<PanelFit> fits;
  EdgeShapes shapes;
};

/// Outlines and names alone are looked at. `drawn_walk`, `turned_over`: see walked_edges().
SeamEvidence seam_evidence(const Pattern& pattern, bool drawn_walk,
                           const std::vector<char>& turned_over = {});

/// Radians by which an edge turns on its walk, left is positive.
double turning_of(const WalkedEdge& edge);

/// The edge across a panel of four edges; -1: the panel has others.
int edge_across(const std::vector<WalkedEdge>& edges, int edge);

/// Each pair of edges as a seam, right side to right side. The start of one meets the end of the
/// other, both walked as walked_edges() walks them.
class SeamPairs {
 public:
  /// `heed_sides`: pieces of the left and of the right half are sewn together only where they are
  /// mirror images of each other.
  SeamPairs(const SeamEvidence& evidence, bool heed_sides);

  bool possible(int a, int b) const;
  /// Of a possible pair.
  SeamMeasures measures(int a, int b) const;

 private:
  void measure_shapes(int a, int b, SeamMeasures& measures) const;
  void measure_names(int a, int b, SeamMeasures& measures) const;
  void measure_halves(int a, int b, SeamMeasures& measures) const;
  double inwards(int edge) const;
  bool are_named_halves(int a, int b) const;
  PanelRole role(int edge) const;
  double narrowing(int edge) const;
  double longest_of_panel(int edge) const;
  bool are_alike(int a, int b) const;
  int lowest_number(const std::string& stem) const;
  bool is_rare(double length, int a, int b) const;

  const std::vector<WalkedEdge>& edges_;
  const std::vector<PanelWords>& words_;
  const std::vector<int>& mirror_;
  const std::vector<int>& shape_;
  const std::vector<char>& turned_over_;
  bool heed_sides_ = true;
};

}  // namespace toile
