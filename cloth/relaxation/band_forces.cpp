#include "cloth/relaxation/band_forces.h"

#include <cmath>
#include <numeric>

namespace toile {

BandForces::BandForces(const Program& program, bool of_points) {
  if (program.bands.empty()) return;
  const auto vertex = [&](int point) { return of_points ? point : program.node_of_point[point]; };
  first_.assign((of_points ? program.node_of_point.size() : program.nodes) + 1, 0);
  for (const BandSegment& segment : program.bands) {
    for (const int point : segment.points) ++first_[vertex(point) + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  entries_.resize(first_.back());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (const BandSegment& segment : program.bands) {
    const int a = vertex(segment.points[0]);
    const int b = vertex(segment.points[1]);
    entries_[next[a]++] = {b, segment};
    entries_[next[b]++] = {a, segment};
  }
}

void BandForces::add(std::size_t begin, std::size_t end, const Vec4s& x, Vec4s& force) const {
  for (std::size_t v = begin; v < end; ++v) {
    for (int i = first_[v]; i < first_[v + 1]; ++i) {
      const Vec4 way = x[entries_[i].other] - x[v];
      const double length = std::sqrt(squared_length(way));
      if (length > 0) force[v] += band_tension(entries_[i].segment, length) / length * way;
    }
  }
}

}  // namespace toile
