#include "cloth/relaxation/block_stiffness.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/columns.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

/// Corners that are handled at a time.
constexpr std::size_t width = 4;

/// The stiffness that yarns add at four corners, N/m: its first four entries, and its last two.
struct AtCorners {
  Vec4 first[width];
  Vec4 last[width];
};

/// `stiffness` (N/m) in the direction of each yarn, and `across` (N/m) square to it. `squared` has
/// the squared lengths of the yarns.
[[gnu::always_inline]] inline AtCorners yarns_add(const Vec4& stiffness, const Vec4& across,
                                                  const Columns& yarn, const Vec4& squared) {
  const Vec4 scale = (stiffness - across) / squared;
  const Columns x = scale * yarn.x * yarn;
  const Vec4 by_y = scale * yarn.y;
  AtCorners added;
  const auto rows = [](const Vec4& a, const Vec4& b, const Vec4& c, const Vec4& d,
                       Vec4(&out)[width]) {
    Vec4 fourth;
    const Columns turned = columns_of(a, b, c, d, &fourth);
    out[0] = turned.x;
    out[1] = turned.y;
    out[2] = turned.z;
    out[3] = fourth;
  };
  rows(x.x + across, x.y, x.z, by_y * yarn.y + across, added.first);
  rows(by_y * yarn.z, scale * yarn.z * yarn.z + across, Vec4{}, Vec4{}, added.last);
  return added;
}

/// A bound of the difference a - b along any direction, N/m.
double excess(const StiffnessBlock& a, const StiffnessBlock& b) {
  constexpr std::array<double, 6> times = {1, 2, 2, 1, 2, 1};
  double sum = 0;
  for (std::size_t k = 0; k < times.size(); ++k) sum += times[k] * (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum / 2);
}

[[gnu::always_inline]] inline Vec4 size_of(const Vec4& a) { return a < 0.0 ? -a : a; }

[[gnu::always_inline]] inline Vec4 sum_of(const Columns& weights) {
  return size_of(weights.x) + size_of(weights.y) + size_of(weights.z);
}

/// The size of the weight of each corner.
[[gnu::always_inline]] inline Vec4 weight_of(const std::array<double, 3>* const (&weights)[width],
                                             const TriangleCorner* const (&corners)[width]) {
  return size_of(Vec4{(*weights[0])[corners[0]->corner], (*weights[1])[corners[1]->corner],
                      (*weights[2])[corners[2]->corner], (*weights[3])[corners[3]->corner]});
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

/// The stiffness that the weft yarns and the warp yarns of triangles add at four of their corners.
[[gnu::always_inline]] inline void stiffness_of(const GarmentModel& model, const Vec4s& x,
                                                const TriangleCorner* const (&corners)[width],
                                                AtCorners& by_weft, AtCorners& by_warp) {
  const StretchTriangle* triangles[width];
  const std::array<double, 3>* weft_weights[width];
  const std::array<double, 3>* warp_weights[width];
  Vec4 wefts[width];
  Vec4 warps[width];
  for (std::size_t i = 0; i < width; ++i) {
    const int t = corners[i]->triangle;
    const StretchTriangle& s = model.stretch[t];
    triangles[i] = &s;
    weft_weights[i] = &s.weft;
    warp_weights[i] = &s.warp;
    const Triangle& nodes = model.node_triangles[t];
    const Vec4& a = x[nodes[0]];
    const Vec4& b = x[nodes[1]];
    const Vec4& d = x[nodes[2]];
    wefts[i] = s.weft[0] * a + s.weft[1] * b + s.weft[2] * d;
    warps[i] = s.warp[0] * a + s.warp[1] * b + s.warp[2] * d;
  }
  const auto all = [&](const auto& of) {
    return Vec4{of(*triangles[0]), of(*triangles[1]), of(*triangles[2]), of(*triangles[3])};
  };
  const auto weights = [&](const std::array<double, 3> StretchTriangle::*yarn) {
    const auto corner = [&](int c) {
      return all([&](const StretchTriangle& s) { return (s.*yarn)[c]; });
    };
    return Columns{corner(0), corner(1), corner(2)};
  };
  const Columns weft = columns_of(wefts[0], wefts[1], wefts[2], wefts[3]);
  const Columns warp = columns_of(warps[0], warps[1], warps[2], warps[3]);
  const Vec4 weft_squared = larger(dot(weft, weft), repeated(1e-18));
  const Vec4 warp_squared = larger(dot(warp, warp), repeated(1e-18));
  const Vec4 of_weft = weight_of(weft_weights, corners);
  const Vec4 of_warp = weight_of(warp_weights, corners);
  const Vec4 weft_sum = sum_of(weights(&StretchTriangle::weft));
  const Vec4 warp_sum = sum_of(weights(&StretchTriangle::warp));
  const Vec4 shear_stiffness = all([](const StretchTriangle& s) { return s.shear_stiffness; });
  // A shearing triangle pulls each of its yarns along the other. |Σ a_i + b_i|² is at most the
  // sum of the weights times the sum of their squares. Once it is sheared, its pulls turn with
  // the yarns, in whichever direction these turn.
  const Vec4 shear = shear_stiffness * (weft_sum + warp_sum);
  const Vec4 sheared =
      shear_stiffness * size_of(dot(weft, warp)) * (of_weft * warp_sum + of_warp * weft_sum);
  const Vec4 weft_stiffness =
      all([](const StretchTriangle& s) { return s.weft_stiffness; }) * of_weft * weft_sum;
  const Vec4 warp_stiffness =
      all([](const StretchTriangle& s) { return s.warp_stiffness; }) * of_warp * warp_sum;
  const auto tension = [](const Vec4& squared) {
    return larger(1 - 1 / square_root(squared), Vec4{});
  };
  by_weft = yarns_add(weft_stiffness + shear * of_warp * weft_squared + sheared,
                      weft_stiffness * tension(weft_squared) + sheared, weft, weft_squared);
  by_warp = yarns_add(warp_stiffness + shear * of_weft * warp_squared,
                      warp_stiffness * tension(warp_squared), warp, warp_squared);
}

/// Four corners at a time: the arithmetic of one corner waits for its roots and quotients. Each
/// node adds up its corners in their order.
TOILE_CLONES
double BlockStiffness::update(std::size_t begin, std::size_t end, const Vec4s& x) {
  struct Sum {
    Vec4 first;
    Vec4 last;
  };
  Sum sums[vertex_chunk] = {};
  std::size_t node = begin;
  std::size_t left = corners_[node].size();  // corners of this node
  const TriangleCorner* const all = corners_[begin].data();
  const std::size_t last = corners_[end - 1].data() + corners_[end - 1].size() - all;
  for (std::size_t first = 0; first < last; first += width) {
    const TriangleCorner* const at = all + first;
    const std::size_t count = std::min(width, last - first);
    const TriangleCorner* const corners[width] = {at, at + std::min<std::size_t>(1, count - 1),
                                                  at + std::min<std::size_t>(2, count - 1),
                                                  at + std::min<std::size_t>(3, count - 1)};
    AtCorners by_weft;
    AtCorners by_warp;
    stiffness_of(model_, x, corners, by_weft, by_warp);
    for (std::size_t i = 0; i < count; ++i) {
      while (left == 0) left = corners_[++node].size();
      --left;
      Sum& sum = sums[node - begin];
      sum.first = sum.first + by_weft.first[i] + by_warp.first[i];
      sum.last = sum.last + by_weft.last[i] + by_warp.last[i];
    }
  }
  double change = 0;
  for (std::size_t n = begin; n < end; ++n) {
    const Sum& sum = sums[n - begin];
    StiffnessBlock now = {sum.first[0], sum.first[1], sum.first[2],
                          sum.first[3], sum.last[0],  sum.last[1]};
    if (!elastic_.empty()) {
      for (const int i : {0, 3, 5}) now[i] += elastic_[n];
    }
    const double bound = model_.stretch_diagonal[n];
    if (bound > 0) change += excess(now, of_nodes_[n]) / bound;
    of_nodes_[n] = now;
  }
  return change;
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
