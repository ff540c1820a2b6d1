// Pulls of elastics on the vertices along them.
#pragma once

#include <vector>

#include "cloth/program.h"
#include "cloth/relaxation/vec4.h"

namespace toile {

/// Vertices are the program's nodes, or its material points while seams stand open.
class BandForces {
 public:
  BandForces(const Program& program, bool of_points);

  bool empty() const { return first_.empty(); }
  /// Adds to the forces (N) on vertices `begin` to `end`, with all vertices at `x`.
  void add(std::size_t begin, std::size_t end, const Vec4s& x, Vec4s& force) const;

 private:
  struct Entry {
    int other;
    BandSegment segment;
  };
  std::vector<int> first_;  // per vertex, its entries; empty: no elastics
  std::vector<Entry> entries_;
};

}  // namespace toile
