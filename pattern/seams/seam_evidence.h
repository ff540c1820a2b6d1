// What seams are found from: edges, words, and which panels are alike.
#pragma once

#include <numbers>
#include <vector>

#include "pattern/seams/panel_symmetry.h"
#include "pattern/seams/panel_words.h"
#include "pattern/seams/walked_edges.h"

namespace toile {

/// Radians: the inner angle at the tip of a dart is larger.
inline constexpr double sharpest_dart_tip = 285 * std::numbers::pi / 180;

/// What seams are found from.
struct SeamEvidence {
  std::vector<WalkedEdge> edges;
  std::vector<PanelWords> words;  ///< per panel
  std::vector<int> side;          ///< per panel: -1 right, +1 left, by its name; 0: not heeded
  std::vector<int> mirror;        ///< per edge, see mirror_partners()
  std::vector<char> turned_over;  ///< per panel, see walked_edges()
  std::vector<PanelFit> fits;
  EdgeShapes shapes;
};

/// Outlines and names alone are looked at. `drawn_walk`, `turned_over`: see walked_edges().
SeamEvidence seam_evidence(const Pattern& pattern, bool drawn_walk,
                           const std::vector<char>& turned_over = {});

/// What left and right in names mean.
enum class SideNames {
  heeded,     ///< what they say
  exchanged,  ///< left is right, and right is left
  ignored     ///< nothing
};

/// The same evidence, with names of sides taken so.
SeamEvidence heeding(SideNames sides, SeamEvidence evidence);

/// Radians by which an edge turns on its walk, left is positive.
double turning_of(const WalkedEdge& edge);

/// The edge across a panel of four edges; -1: the panel has others.
int edge_across(const std::vector<WalkedEdge>& edges, int edge);

}  // namespace toile
