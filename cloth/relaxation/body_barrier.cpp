#include "cloth/relaxation/body_barrier.h"

#include <algorithm>
#include <cmath>

#include "cloth/relaxation/constants.h"
#include "cloth/scene/collider.h"
#include "geometry/half_edges.h"
#include "geometry/parallel.h"

namespace toile {

BodyBarrier::BodyBarrier(const Scene& scene, const std::vector<Triangle>& triangles,
                         const std::vector<Way>& seams, const Vec4s& x)
    : scene_(scene) {
  const auto length = [&](const Way& way) {
    return std::sqrt(squared_length(x[way.to] - x[way.from]));
  };
  std::vector<char> seen(x.size(), 0);
  for (const Triangle& corners : triangles) {
    for (const int p : corners) {
      if (seen[p]++ == 0) probes_.push_back({{p, p}, 0});
    }
  }
  for (const auto& [a, b] : unique_edges(triangles)) add({a, b}, length({a, b}));
  for (const Way& way : seams) add(way, length(way));
  clear_.assign(probes_.size(), Vec4{0, 0, 0, -1});
  found_.resize(chunks_of(probes_.size(), vertex_chunk));
}

void BodyBarrier::add(const Way& way, double length) {
  const int parts = std::min(1 + static_cast<int>(length / barrier_spacing), max_barrier_parts);
  for (int i = 1; i < parts; ++i) probes_.push_back({way, static_cast<double>(i) / parts});
}

const std::vector<BodyBarrier::Correction>& BodyBarrier::find(const Vec4s& x) {
  const DistanceGrid& grid = scene_.collider->grid();
  parallel_for_chunks(probes_.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Correction>& found = found_[begin / vertex_chunk];
    found.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const Probe& probe = probes_[i];
      const Vec4 at = x[probe.way.from] + probe.share * (x[probe.way.to] - x[probe.way.from]);
      Vec4 moved = at - clear_[i];
      moved[3] = 0;
      if (squared_length(moved) < clear_[i][3]) continue;
      const DistanceGrid::Sample sample = grid.at(as_vec3(at));
      const double clear = grid.lower_bound(sample.distance) - barrier_distance;
      clear_[i] = at;
      clear_[i][3] = clear > 0 ? clear * clear : -1;
      if (sample.distance >= barrier_distance) continue;
      const double length = sample.gradient.norm();
      if (length <= 0) continue;
      found.push_back({probe.way, probe.share,
                       (barrier_distance - sample.distance) / length * sample.gradient});
    }
  });
  all_.clear();
  for (const auto& part : found_) all_.insert(all_.end(), part.begin(), part.end());
  return all_;
}

}  // namespace toile
