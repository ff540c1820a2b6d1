#include "cloth/loads/inner_face.h"

#include <algorithm>
#include <cmath>

#include "geometry/parallel.h"

namespace toile {

namespace {

/// Radians: two normals that differ by more belong to no arc, but to two sides of something thin.
/// Around a wrist of 2.5 cm they differ by 1.0 at edges of 25 mm, so half loses cuffs. Double
/// counts a finger's two sides as an arc.
constexpr double widest_arc = 1.5;

/// Length of an arc over that of its chord.
double arc_over_chord(double angle) {
  const double half = 0.5 * std::abs(angle);
  return half < 1e-4 ? 1 : half / std::sin(half);
}

/// The square of the length of Σ weight_i x_i, whose weights add up to 0, by the squares of the
/// distances between the x_i. Distance i is that of the two corners other than i.
double squared_by_distances(const std::array<double, 3>& weights,
                            const std::array<double, 3>& squares) {
  return -(weights[0] * weights[1] * squares[2] + weights[1] * weights[2] * squares[0] +
           weights[2] * weights[0] * squares[1]);
}

}  // namespace

InnerFace::InnerFace(const GarmentModel& model, const std::vector<Vec3>& nodes,
                     const SurfaceDistance& skin, double touching)
    : model_(model),
      nodes_(nodes),
      touches_(nodes.size(), 0),
      gap_(nodes.size(), 0),
      outward_(nodes.size(), Vec3::Zero()) {
  std::vector<SurfacePoint> below(nodes.size());
  parallel_for_chunks(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) below[n] = skin.closest_point(nodes[n]);
  });
  std::vector<std::array<char, 3>> near(model.node_triangles.size(), {0, 0, 0});
  parallel_for_chunks(near.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Triangle& corners = model.node_triangles[t];
      for (int i = 0; i < 3; ++i) {
        const int a = corners[i];
        const int b = corners[(i + 1) % 3];
        const double half = 0.5 * (nodes[a] - nodes[b]).norm();
        if (std::min(below[a].distance, below[b].distance) - half > touching) continue;
        const Vec3 middle = 0.5 * (nodes[a] + nodes[b]);
        near[t][i] = static_cast<char>(skin.closest_point(middle, below[a]).distance <= touching);
      }
    }
  });
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    touches_[n] = static_cast<char>(below[n].distance <= touching);
  }
  for (std::size_t t = 0; t < near.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (near[t][i] == 0) continue;
      touches_[model.node_triangles[t][i]] = 1;
      touches_[model.node_triangles[t][(i + 1) % 3]] = 1;
    }
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Vec3 away = nodes[n] - below[n].point;
    outward_[n] = below[n].distance > 1e-6 ? Vec3(away.normalized()) : below[n].normal;
    gap_[n] = std::max(below[n].distance, 0.0);
  }
}

double InnerFace::length(int a, int b) const {
  const Vec3 chord = nodes_[b] - nodes_[a];
  const double length = chord.norm();
  if (!touches(a) || !touches(b) || !(length > 0)) return length;
  const auto slope = [&](int n) {
    return std::asin(std::clamp(outward_[n].dot(chord) / length, -1.0, 1.0));
  };
  const double angle = slope(b) - slope(a);
  if (angle <= 0 || angle > widest_arc) return length;
  return std::max(length * arc_over_chord(angle) - 0.5 * (gap_[a] + gap_[b]) * angle, 0.0);
}

double InnerFace::area(int triangle) const {
  const Triangle& n = model_.node_triangles[triangle];
  const double a = length(n[1], n[2]);
  const double b = length(n[2], n[0]);
  const double c = length(n[0], n[1]);
  const double s = 0.5 * (a + b + c);
  return std::sqrt(std::max(s * (s - a) * (s - b) * (s - c), 0.0));
}

InnerFace::Shares InnerFace::shares(int triangle) const {
  const Triangle& n = model_.node_triangles[triangle];
  if (!touches(n[0]) && !touches(n[1]) && !touches(n[2])) return {};
  std::array<double, 3> middle;
  std::array<double, 3> inner;
  for (int i = 0; i < 3; ++i) {
    const int a = n[(i + 1) % 3];
    const int b = n[(i + 2) % 3];
    middle[i] = (nodes_[a] - nodes_[b]).squaredNorm();
    inner[i] = std::pow(length(a, b), 2);
  }
  const auto share = [&](const std::array<double, 3>& yarn) {
    const double of_middle = squared_by_distances(yarn, middle);
    const double of_inner = squared_by_distances(yarn, inner);
    if (!(of_middle > 0)) return 1.0;
    // What is not taut lies on the skin as long as it is.
    const double slack = std::min(1.0, std::sqrt(of_middle));
    return std::max(std::sqrt(std::max(of_inner, 0.0)), slack) / std::sqrt(of_middle);
  };
  return {share(model_.stretch[triangle].weft), share(model_.stretch[triangle].warp)};
}

StretchTriangle InnerFace::strained(int triangle) const {
  const Shares inner = shares(triangle);
  StretchTriangle s = model_.stretch[triangle];
  for (double& weight : s.weft) weight *= inner.weft;
  for (double& weight : s.warp) weight *= inner.warp;
  return s;
}

StretchTriangle InnerFace::pulling(int triangle) const {
  const Shares inner = shares(triangle);
  StretchTriangle s = strained(triangle);
  s.weft_stiffness /= inner.weft;
  s.warp_stiffness /= inner.warp;
  s.shear_stiffness /= inner.weft * inner.warp;
  return s;
}

}  // namespace toile
