// The edges of all panels in a row, with what a seam can be told by.
#pragma once

#include <array>
#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// An edge as it lies on the outline of its panel, seen from the panel's right side and walked
/// counter-clockwise.
struct WalkedEdge {
  EdgeRef ref;
  int next = 0;         ///< index of the edge that follows on the outline
  int previous = 0;     ///< index of the edge before
  bool forward = true;  ///< whether the walk runs from the edge's start to its end, as drawn
  double length = 0;    ///< metres
  /// Radians by which the tangent turns in each quarter of the length, left is positive.
  std::array<double, 4> turning{};
  double across_grain = 0;  ///< sine of the angle between the edge's chord and the warp
  /// Cosine of the angle between the warp, as drawn, and what lies beyond the edge: 1 at an upper
  /// edge, -1 at a hem.
  double upwards = 0;
  /// Cosine of the angle between the walk's chord and the warp as drawn: 1 at a right side, -1 at a
  /// left one.
  double rise = 0;
  double corner = 0;   ///< radians: the panel's inner angle where this edge starts
  bool notch = false;  ///< whether a notch is drawn where this edge starts
  /// Points at equal steps of length, from the walk's first to its last. Metres.
  std::vector<Vec2> points;
};

/// The edges of all panels, those of a panel in a row from the first step of its outline.
/// `drawn_walk`: outlines run counter-clockwise as seen from the right side, whichever way they are
/// drawn, which is GarmentCode's convention. Otherwise each drawing shows its right side.
/// `turned_over`: per panel, 1 where it is the other way round; empty: nowhere.
std::vector<WalkedEdge> walked_edges(const Pattern& pattern, bool drawn_walk,
                                     const std::vector<char>& turned_over = {});

/// The part of an edge between two shares of its length, both in [0, 1], `from` < `to`. It has no
/// notches, and where it is cut no corners; `next` and `previous` are as those of the edge.
WalkedEdge part_of(const WalkedEdge& edge, double from, double to);

}  // namespace toile
