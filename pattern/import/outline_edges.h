// An outline cut into the edges that seams are sewn along.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pattern/import/fit_curve.h"
#include "pattern/import/piece_shape.h"

namespace toile {

/// How outlines are cut and fitted.
struct EdgeOptions {
  double chord_error = 1e-4;    ///< metres from the drawn outline to the edges at most
  double corner_angle = 0.436;  ///< radians: an outline that turns by more has a corner there
};

/// From one vertex to the next, by curves that follow each other.
struct OutlineEdge {
  int from = 0;
  int to = 0;
  std::vector<FittedCurve> curves;
};

/// A notch at a vertex.
struct OutlineNotch {
  int vertex = 0;
  std::optional<double> angle;  ///< radians from +x, counter-clockwise, if the file says it
};

/// A closed outline of edges, counter-clockwise. Edge i runs from vertex i to the next.
struct EdgedOutline {
  std::vector<Vec2> vertices;
  std::vector<OutlineEdge> edges;
  std::vector<OutlineNotch> notches;
  int far_notches = 0;  ///< notches too far from the outline to belong to it
};

/// Cuts the shape's outline at its corners and notches, and fits each edge.
///
/// - Corners are the declared ones, where the outline turns by 10 degrees or more or the shape
///   has_all_corners. So is every point where it turns by more than the corner angle; by more than
///   60 degrees if there are declared ones. Points of a rounding drawn in coarse chords are none:
///   their neighbours turn as much, less than 2 cm away.
/// - A notch within 3 mm of a corner is at the corner. One up to 6 cm from the outline is moved
///   onto it: it stands on the cut line.
/// - An outline with less than two corners is cut at its lowest point and the one farthest from it.
///
/// Throws Error with the place `place` for more corners and notches than max_panel_edges.
EdgedOutline edges_of(const PieceShape& shape, const EdgeOptions& options,
                      const std::string& place);

/// Numbers the edges of an outline as those of a like one of another size. The first edge is that
/// with which the edges' shares of all chords differ least. Nothing changes where counts differ, or
/// where another first edge would not halve the difference. O(n^2) of the edges.
void number_alike(EdgedOutline& outline, const EdgedOutline& like);

}  // namespace toile
