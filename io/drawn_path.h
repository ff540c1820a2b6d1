// Paths of a drawing in the plane: straight lines and cubic Bezier curves.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// A line or a curve from where the one before it ends.
struct DrawnSegment {
  bool curved = false;  ///< false: a straight line, without control points
  Vec2 control1 = Vec2::Zero();
  Vec2 control2 = Vec2::Zero();
  Vec2 end = Vec2::Zero();

  static DrawnSegment line(const Vec2& to) { return {false, to, to, to}; }
  static DrawnSegment cubic(const Vec2& first, const Vec2& second, const Vec2& to) {
    return {true, first, second, to};
  }
};

/// Segments that follow each other. A closed path ends where it starts, by a segment of its own.
struct DrawnPath {
  Vec2 start = Vec2::Zero();
  std::vector<DrawnSegment> segments;
  bool closed = false;
};

/// Where a path ends.
inline const Vec2& end_of(const DrawnPath& path) {
  return path.segments.empty() ? path.start : path.segments.back().end;
}

/// Points along a path, both ends included. Chords between them leave its curves by at most
/// `tolerance`.
std::vector<Vec2> path_vertices(const DrawnPath& path, double tolerance);

}  // namespace toile
