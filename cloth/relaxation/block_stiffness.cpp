#include "cloth/relaxation/block_stiffness.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/parallel.h"

namespace toile {

namespace {

/// Adds `stiffness` (N/m) in the direction of `yarn`, and `across` (N/m) square to it. `squared` is
/// the squared length of `yarn`.
void add_yarn(StiffnessBlock& sum, double stiffness, double across, const Vec4& yarn,
              double squared) {
  const double scale = (stiffness - across) / squared;
  const Vec4 x = scale * yarn[0] * yarn;
  const Vec4 y = scale * yarn[1] * yarn;
  sum[0] += x[0] + across;
  sum[1] += x[1];
  sum[2] += x[2];
  sum[3] += y[1] + across;
  sum[4] += y[2];
  sum[5] += scale * yarn[2] * yarn[2] + across;
}

/// A bound of the difference a - b along any direction, N/m.
double excess(const StiffnessBlock& a, const StiffnessBlock& b) {
  constexpr std::array<double, 6> times = {1, 2, 2, 1, 2, 1};
  double sum = 0;
  for (std::size_t k = 0; k < times.size(); ++k) sum += times[k] * (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum / 2);
}

double sum_of(const std::array<double, 3>& weights) {
  return std::abs(weights[0]) + std::abs(weights[1]) + std::abs(weights[2]);
}

}  // namespace

BlockStiffness::BlockStiffness(const GarmentModel& model) : model_(model) {
  corners_ = corners_by_vertex(model.node_triangles, model.nodes);
  if (!model.elastics.empty()) elastic_.assign(model.nodes, 0);
  for (const ElasticSegment& segment : model.elastics) {
    for (const int p : segment.points) elastic_[model.node_of_point[p]] += stiffness_bound(segment);
  }
  of_nodes_.resize(model.nodes);
  partial_.resize(chunks_of(of_nodes_.size(), vertex_chunk));
}

[[gnu::always_inline]] inline StiffnessBlock BlockStiffness::at(std::size_t node,
                                                                const Vec4s& x) const {
  StiffnessBlock sum{};
  for (const auto& [t, c] : corners_[node]) {
    const StretchTriangle& s = model_.stretch[t];
    const Triangle& nodes = model_.node_triangles[t];
    const Vec4& a = x[nodes[0]];
    const Vec4& b = x[nodes[1]];
    const Vec4& d = x[nodes[2]];
    const Vec4 weft = s.weft[0] * a + s.weft[1] * b + s.weft[2] * d;
    const Vec4 warp = s.warp[0] * a + s.warp[1] * b + s.warp[2] * d;
    const double weft_squared = std::max(squared_length(weft), 1e-18);
    const double warp_squared = std::max(squared_length(warp), 1e-18);
    const double of_weft = std::abs(s.weft[c]);
    const double of_warp = std::abs(s.warp[c]);
    const double weft_sum = sum_of(s.weft);
    const double warp_sum = sum_of(s.warp);
    // A shearing triangle pulls each of its yarns along the other. |Σ a_i + b_i|² is at most the
    // sum of the weights times the sum of their squares. Once it is sheared, its pulls turn with
    // the yarns, in whichever direction these turn.
    const double shear = s.shear_stiffness * (weft_sum + warp_sum);
    const double sheared =
        s.shear_stiffness * std::abs(dot(weft, warp)) * (of_weft * warp_sum + of_warp * weft_sum);
    const double weft_stiffness = s.weft_stiffness * of_weft * weft_sum;
    const double warp_stiffness = s.warp_stiffness * of_warp * warp_sum;
    const auto tension = [](double squared) { return std::max(0.0, 1 - 1 / std::sqrt(squared)); };
    add_yarn(sum, weft_stiffness + shear * of_warp * weft_squared + sheared,
             weft_stiffness * tension(weft_squared) + sheared, weft, weft_squared);
    add_yarn(sum, warp_stiffness + shear * of_weft * warp_squared,
             warp_stiffness * tension(warp_squared), warp, warp_squared);
  }
  if (!elastic_.empty()) {
    for (const int i : {0, 3, 5}) sum[i] += elastic_[node];
  }
  return sum;
}

TOILE_CLONES
double BlockStiffness::update(std::size_t begin, std::size_t end, const Vec4s& x) {
  double sum = 0;
  for (std::size_t n = begin; n < end; ++n) {
    const StiffnessBlock now = at(n, x);
    const double bound = model_.stretch_diagonal[n];
    if (bound > 0) sum += excess(now, of_nodes_[n]) / bound;
    of_nodes_[n] = now;
  }
  return sum;
}

double BlockStiffness::update(const Vec4s& x) {
  parallel_for_chunks(of_nodes_.size(), [&](std::size_t begin, std::size_t end) {
    partial_[begin / vertex_chunk] = update(begin, end, x);
  });
  const double sum = std::accumulate(partial_.begin(), partial_.end(), 0.0);
  const double mean = sum / std::max<double>(1, static_cast<double>(of_nodes_.size()));
  return std::exchange(known_, true) ? mean : 1;
}

}  // namespace toile
