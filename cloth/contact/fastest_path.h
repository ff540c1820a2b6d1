// How far the fastest vertex of a cloth has moved, so that what is far enough off need not be
// looked at.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/vec4.h"

namespace toile {

/// The path of the fastest vertex: the sum, over all calls of follow(), of the largest move of a
/// vertex since the call before. No mean of vertices moves farther between two calls.
class FastestPath {
 public:
  /// Goes on to the vertices `x` (metres). The first call, and one with another number of vertices,
  /// begins at these. Linear in the vertices.
  void follow(const Vec4s& x);
  /// Metres, so far.
  double length() const { return length_; }

 private:
  void follow(std::size_t begin, std::size_t end, const Vec4s& x, double& squared);

  Vec4s last_;                   // metres: the vertices at the last call
  std::vector<double> squared_;  // m², per chunk: of the largest move
  double length_ = 0;
};

}  // namespace toile
