// Loose curves joined to closed outlines.
#pragma once

#include <string>
#include <vector>

#include "pattern/import/piece.h"

namespace toile {

/// Metres: ends that are nearer are one point.
inline constexpr double max_outline_gap = 5e-4;

/// Where curves should meet and do not.
struct PathGap {
  double size = 0;         ///< metres
  Vec2 at = Vec2::Zero();  ///< metres: the middle of the gap
};

/// Curves joined end to end.
struct JoinedPaths {
  std::vector<PiecePath> closed;
  std::vector<PiecePath> open;
  /// For each open path, or for the first alone of many: to the end that is nearest to its own.
  std::vector<PathGap> gaps;
  double widest_closed_gap = 0;  ///< metres: the widest gap that was closed
};

/// A point for messages: "(12.0, -3.5) mm".
std::string millimetres_text(const Vec2& metres);

/// Joins paths whose ends are within max_outline_gap, the nearest first, whichever way they run.
/// Curves move a little to meet. Curves shorter than a micrometre are left out. Paths come in the
/// order of their first curves. About O(n log n).
JoinedPaths join_paths(const std::vector<PiecePath>& paths);

/// The path run the other way.
PiecePath reversed_path(const PiecePath& path);

/// Metres.
double path_length(const PiecePath& path);

/// Points along a path, both ends included: chords leave its curves by at most `tolerance` metres.
std::vector<Vec2> path_points(const PiecePath& path, double tolerance);

/// Whether points enclose nothing: their box is narrower than a millimetre.
bool is_line(const std::vector<Vec2>& points);

/// path_points() of a closed path, its first point not repeated.
std::vector<Vec2> loop_points(const PiecePath& path, double tolerance);

}  // namespace toile
