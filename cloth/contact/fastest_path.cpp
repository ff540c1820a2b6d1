#include "cloth/contact/fastest_path.h"

#include <algorithm>
#include <cmath>

#include "geometry/parallel.h"

namespace toile {

namespace {

/// Vertices that one task follows. A coarse mesh is one task: starting two takes longer than that.
constexpr std::size_t vertices_of_a_task = 4096;

}  // namespace

TOILE_CLONES
void FastestPath::follow(std::size_t begin, std::size_t end, const Vec4s& x, double& squared) {
  double largest = 0;
  for (std::size_t v = begin; v < end; ++v) {
    largest = std::max(largest, squared_length(x[v] - last_[v]));
    last_[v] = x[v];
  }
  squared = largest;
}

void FastestPath::follow(const Vec4s& x) {
  if (last_.size() != x.size()) last_ = x;
  squared_.assign(chunks_of(x.size(), vertices_of_a_task), 0);
  parallel_for(squared_.size(), [&](std::size_t c) {
    follow(c * vertices_of_a_task, std::min(x.size(), (c + 1) * vertices_of_a_task), x,
           squared_[c]);
  });
  double largest = 0;
  for (const double squared : squared_) largest = std::max(largest, squared);
  length_ += std::sqrt(largest);
}

}  // namespace toile
