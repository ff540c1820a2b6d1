#include "cloth/relaxation/body_barrier.h"

#include <algorithm>
#include <cmath>

#include "cloth/relaxation/constants.h"
#include "cloth/scene/collider.h"
#include "geometry/half_edges.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

/// Metres: far above what rounding can do to a path.
constexpr double path_slack = 1e-9;

}  // namespace

BodyBarrier::BodyBarrier(const Scene& scene, const std::vector<Triangle>& triangles,
                         const std::vector<Pair>& seams, const Vec4s& x)
    : scene_(scene) {
  const auto length = [&](int a, int b) { return std::sqrt(squared_length(x[b] - x[a])); };
  std::vector<char> seen(x.size(), 0);
  for (const Triangle& corners : triangles) {
    for (const int p : corners) {
      if (seen[p]++ == 0) probes_.push_back({{p, p, p}, {1, 0, 0}});
    }
  }
  for (const auto& [a, b] : unique_edges(triangles)) add_between(a, b, length(a, b));
  for (const Pair& seam : seams) add_between(seam.a, seam.b, length(seam.a, seam.b));
  for (const auto& [a, b, c] : triangles) {
    add_within({a, b, c}, std::max({length(a, b), length(b, c), length(c, a)}));
  }
  clear_.assign(probes_.size(), Vec4{0, 0, 0, -1});
  clear_until_.assign(probes_.size(), -1);
  path_.follow(x);
  found_.resize(chunks_of(probes_.size(), vertex_chunk));
}

void BodyBarrier::add_between(int a, int b, double length) {
  const int parts = std::min(1 + static_cast<int>(length / barrier_spacing), max_barrier_parts);
  for (int i = 1; i < parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    probes_.push_back({{a, b, b}, {1 - share, share, 0}});
  }
}

void BodyBarrier::add_within(const Triangle& corners, double longest) {
  const int parts = std::min(1 + static_cast<int>(longest / barrier_spacing), max_barrier_parts);
  for (int i = 1; i < parts; ++i) {
    for (int k = 1; i + k < parts; ++k) {
      const double a = static_cast<double>(i) / parts;
      const double b = static_cast<double>(k) / parts;
      probes_.push_back({corners, {a, b, 1 - a - b}});
    }
  }
}

TOILE_CLONES
void BodyBarrier::find(std::size_t begin, std::size_t end, const Vec4s& x,
                       std::vector<Correction>& found) {
  const DistanceGrid& grid = scene_.collider->grid();
  const double path = path_.length();
  // A probe is a mean of points. Most are passed over: no point has moved by what they may move.
  std::size_t due[vertex_chunk];
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; ++i) {
    due[count] = i;
    count += path < clear_until_[i] ? 0 : 1;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = due[k];
    const auto& [points, weights] = probes_[i];
    const Vec4 at =
        weights[0] * x[points[0]] + weights[1] * x[points[1]] + weights[2] * x[points[2]];
    Vec4 moved = at - clear_[i];
    moved[3] = 0;
    const double squared = squared_length(moved);
    if (squared < clear_[i][3]) {
      clear_until_[i] = path + std::sqrt(clear_[i][3]) - std::sqrt(squared) - path_slack;
      continue;
    }
    const DistanceGrid::Sample sample = grid.at(as_vec3(at));
    const double clear = grid.lower_bound(sample.distance) - barrier_distance;
    clear_[i] = at;
    clear_[i][3] = clear > 0 ? clear * clear : -1;
    clear_until_[i] = path + clear - path_slack;
    if (sample.distance >= barrier_distance) continue;
    const double length = sample.gradient.norm();
    if (length <= 0) continue;
    found.push_back({probes_[i], (barrier_distance - sample.distance) / length * sample.gradient});
  }
}

const std::vector<BodyBarrier::Correction>& BodyBarrier::find(const Vec4s& x) {
  path_.follow(x);
  parallel_for_chunks(probes_.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Correction>& found = found_[begin / vertex_chunk];
    found.clear();
    find(begin, end, x, found);
  });
  all_.clear();
  for (const auto& part : found_) all_.insert(all_.end(), part.begin(), part.end());
  return all_;
}

}  // namespace toile
