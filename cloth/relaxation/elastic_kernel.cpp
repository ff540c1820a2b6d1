#include "cloth/relaxation/elastic_kernel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cloth/relaxation/constants.h"
#include "geometry/columns.h"

namespace toile {

namespace {

/// The stress that a limit adds in four triangles whose strain exceeds it by `by`.
[[gnu::always_inline]] inline Vec4 limit_stress(const Vec4& stiffness, const Vec4& by,
                                                const Vec4& multiplier) {
  return larger(multiplier + strain_limit_stiffening * stiffness * by, Vec4{0, 0, 0, 0});
}

/// Squared stretch below which a yarn is crushed to a point. It then has no direction to push
/// along.
constexpr double min_squared = 1e-18;

/// N·m: stress times area over the stretch, of four triangles along one yarn.
[[gnu::always_inline]] inline Vec4 tension(const Vec4& stiffness, const Vec4& squared,
                                           const StretchOptions& options, const Vec4* multiplier) {
  const Vec4 length = square_root(squared > min_squared ? squared : Vec4{1, 1, 1, 1});
  const Vec4 strain = length - 1.0;
  Vec4 stress = stiffness * (strain > 0.0 ? strain : options.compression * strain);
  if (multiplier != nullptr) stress += limit_stress(stiffness, strain - options.limit, *multiplier);
  const Vec4 result = stress / length;
  return squared > min_squared ? result : Vec4{0, 0, 0, 0};
}

}  // namespace

ElasticKernel::ElasticKernel(const GarmentModel& model, bool of_points) {
  const std::size_t vertices = of_points ? model.node_of_point.size() : model.nodes;
  lay_out_triangles(model, of_points ? model.triangles : model.node_triangles, vertices);
  if (!model.bend.empty()) {
    std::vector<int> points(vertices);
    std::iota(points.begin(), points.end(), 0);
    bend_ = bend_matrix(model, of_points ? points : model.node_of_point, vertices, of_points);
  }
  if (model.scene.strain_limit || model.scene.shear_limit) lay_out_limits(model);
}

void ElasticKernel::lay_out_limits(const GarmentModel& model) {
  limits_.assign(groups_.size(), LimitGroup{});
  triangles_ = model.stretch.size();
  for (std::size_t t = 0; t < triangles_; ++t) {
    const StretchTriangle& s = model.stretch[t];
    LimitGroup& limits = limits_[t / group];
    limits.area[t % group] = s.area;
    limits.max[t % group] = s.limited ? s.area * max_limit_multiplier : 0;
    for (int c = 0; c < 3; ++c) {
      limits.sum_weft[t % group] += std::abs(s.weft[c]);
      limits.sum_warp[t % group] += std::abs(s.warp[c]);
    }
  }
}

void ElasticKernel::start_multipliers(const std::vector<LimitMultiplier>& yarns) {
  for (std::size_t t = 0; t < std::min(yarns.size(), triangles_); ++t) {
    LimitGroup& limits = limits_[t / group];
    const std::size_t i = t % group;
    const auto within = [&](double multiplier) {
      return std::clamp(limits.area[i] * multiplier, -limits.max[i], limits.max[i]);
    };
    limits.weft[i] = within(yarns[t].weft);
    limits.warp[i] = within(yarns[t].warp);
    limits.shear[i] = within(yarns[t].shear);
  }
}

std::vector<LimitMultiplier> ElasticKernel::multipliers() const {
  std::vector<LimitMultiplier> yarns(triangles_);
  for (std::size_t t = 0; t < triangles_; ++t) {
    const LimitGroup& limits = limits_[t / group];
    const std::size_t i = t % group;
    yarns[t] = {limits.weft[i] / limits.area[i], limits.warp[i] / limits.area[i],
                limits.shear[i] / limits.area[i]};
  }
  return yarns;
}

void ElasticKernel::lay_out_triangles(const GarmentModel& model,
                                      const std::vector<Triangle>& triangles,
                                      std::size_t vertices) {
  groups_.resize((triangles.size() + group - 1) / group);
  corners_ = corners_by_vertex(triangles, vertices);
  const std::size_t all = group * groups_.size();
  pulls_.assign(3 * all, Vec4{});
  first_pull_ = {0};
  for (std::size_t v = 0; v < vertices; ++v) {
    int pull = first_pull_.back();
    for (const auto& [t, c] : corners_[v]) groups_[t / group].pulls[c][t % group] = pull++;
    first_pull_.push_back(pull);
  }
  for (std::size_t t = 0; t < all; ++t) {
    TriangleGroup& g = groups_[t / group];
    const std::size_t i = t % group;
    if (t >= triangles.size()) {
      // Fills up the last group with triangles that pull at nothing.
      for (int c = 0; c < 3; ++c) g.corners[c][i] = 0;
      for (int c = 0; c < 3; ++c) g.pulls[c][i] = static_cast<int>(3 * t) + c;
      g.weft[0][i] = g.weft[1][i] = g.warp[0][i] = g.warp[1][i] = 0;
      g.stretch_weft[i] = g.stretch_warp[i] = g.shear[i] = 0;
      continue;
    }
    const StretchTriangle& s = model.stretch[t];
    for (int c = 0; c < 3; ++c) g.corners[c][i] = triangles[t][c];
    for (int c = 0; c < 2; ++c) {
      g.weft[c][i] = s.weft[c + 1];
      g.warp[c][i] = s.warp[c + 1];
    }
    g.stretch_weft[i] = s.weft_stiffness;
    g.stretch_warp[i] = s.warp_stiffness;
    g.shear[i] = s.shear_stiffness;
  }
}

template <typename Group>
[[gnu::always_inline]] inline void deform(const Group& t, const Vec4* x, Columns& weft,
                                          Columns& warp) {
  constexpr std::size_t group = ElasticKernel::group;
  Vec4 u[group];
  Vec4 v[group];
  for (std::size_t i = 0; i < group; ++i) {
    const Vec4 first = x[t.corners[0][i]];
    const Vec4 b = x[t.corners[1][i]] - first;
    const Vec4 c = x[t.corners[2][i]] - first;
    u[i] = t.weft[0][i] * b + t.weft[1][i] * c;
    v[i] = t.warp[0][i] * b + t.warp[1][i] * c;
  }
  weft = columns_of(u[0], u[1], u[2], u[3]);
  warp = columns_of(v[0], v[1], v[2], v[3]);
}

/// `limited` is a template parameter, so that limits cost nothing in a model without them.
template <bool limited>
[[gnu::always_inline]] inline void ElasticKernel::pull_all(std::size_t begin, std::size_t end,
                                                           const StretchOptions& options,
                                                           const Vec4* x) {
  for (std::size_t g = begin; g < end; ++g) {
    const TriangleGroup& t = groups_[g];
    Columns weft;
    Columns warp;
    deform(t, x, weft, warp);
    const LimitGroup* limits = limited ? &limits_[g] : nullptr;
    const bool limits_stretch = limited && options.limit >= 0;
    const Vec4 along_weft =
        tension(t.stretch_weft, dot(weft, weft), options, limits_stretch ? &limits->weft : nullptr);
    const Vec4 along_warp =
        tension(t.stretch_warp, dot(warp, warp), options, limits_stretch ? &limits->warp : nullptr);
    const Vec4 turned = dot(weft, warp);
    Vec4 sheared = t.shear * turned;
    if (limited && options.shear_limit >= 0) {
      sheared += limit_stress(t.shear, turned - options.shear_limit, limits->shear) -
                 limit_stress(t.shear, -turned - options.shear_limit, -limits->shear);
    }
    const Columns by_weft = {-(along_weft * weft.x + sheared * warp.x),
                             -(along_weft * weft.y + sheared * warp.y),
                             -(along_weft * weft.z + sheared * warp.z)};
    const Columns by_warp = {-(along_warp * warp.x + sheared * weft.x),
                             -(along_warp * warp.y + sheared * weft.y),
                             -(along_warp * warp.z + sheared * weft.z)};
    const auto pull_at = [&](int corner, const Vec4& weft_weight, const Vec4& warp_weight) {
      store_rows({weft_weight * by_weft.x + warp_weight * by_warp.x,
                  weft_weight * by_weft.y + warp_weight * by_warp.y,
                  weft_weight * by_weft.z + warp_weight * by_warp.z},
                 pulls_.data(), t.pulls[corner]);
    };
    pull_at(0, -(t.weft[0] + t.weft[1]), -(t.warp[0] + t.warp[1]));
    pull_at(1, t.weft[0], t.warp[0]);
    pull_at(2, t.weft[1], t.warp[1]);
  }
}

TOILE_CLONES
void ElasticKernel::pull(std::size_t begin, std::size_t end, const StretchOptions& options,
                         const Vec4s& x) {
  if (limits_.empty()) {
    pull_all<false>(begin, end, options, x.data());
  } else {
    pull_all<true>(begin, end, options, x.data());
  }
}

ElasticKernel::LimitViolations ElasticKernel::update_multipliers(std::size_t begin, std::size_t end,
                                                                 const StretchOptions& options,
                                                                 const Vec4s& x) {
  LimitViolations found;
  for (std::size_t g = begin; g < end; ++g) {
    const TriangleGroup& t = groups_[g];
    LimitGroup& limits = limits_[g];
    Columns weft;
    Columns warp;
    deform(t, x.data(), weft, warp);
    // Updates a multiplier; returns the stiffness that the limit adds.
    const auto adjust = [&](const Vec4& stiffness, const Vec4& strain, double limit,
                            Vec4& multiplier) {
      const Vec4 zero = {0, 0, 0, 0};
      const Vec4 by = strain - limit;
      const Vec4 wanted = larger(multiplier + multiplier_step * stiffness * by, zero);
      multiplier = wanted < limits.max ? wanted : limits.max;
      for (std::size_t i = 0; i < group; ++i) {
        if (strain[i] <= (1 + limit_tolerance) * limit || limits.max[i] <= 0) continue;
        ++(wanted[i] >= limits.max[i] ? found.at_max_multiplier : found.beyond);
      }
      const Vec4 stiffer = strain > limit_stiffening_onset * limit || multiplier > zero
                               ? strain_limit_stiffening * stiffness
                               : zero;
      // Tension is a stiffness across the yarn.
      const Vec4 stress = stiffness * strain + limit_stress(stiffness, by, multiplier);
      return larger(stiffer, stress - stiffness);
    };
    Vec4 more_weft = {0, 0, 0, 0};
    Vec4 more_warp = {0, 0, 0, 0};
    if (options.limit >= 0) {
      const auto strain = [](const Columns& c) { return square_root(dot(c, c)) - 1.0; };
      more_weft =
          limits.sum_weft * adjust(t.stretch_weft, strain(weft), options.limit, limits.weft);
      more_warp =
          limits.sum_warp * adjust(t.stretch_warp, strain(warp), options.limit, limits.warp);
    }
    if (options.shear_limit >= 0) {
      const Vec4 turned = dot(weft, warp);
      // At most one of the two shear limits, of one sign each, holds.
      const Vec4 side = limits.shear < 0.0 || (limits.shear == 0.0 && turned < 0.0)
                            ? Vec4{-1, -1, -1, -1}
                            : Vec4{1, 1, 1, 1};
      Vec4 multiplier = side * limits.shear;
      const Vec4 more = adjust(t.shear, side * turned, options.shear_limit, multiplier);
      limits.shear = side * multiplier;
      const Vec4 both = 0.5 * (limits.sum_weft + limits.sum_warp) * more;
      more_weft += both;
      more_warp += both;
    }
    limits.stiffening_weft = more_weft;
    limits.stiffening_warp = more_warp;
  }
  return found;
}

double ElasticKernel::at_corner(const Vec4 (&weights)[2], std::size_t i, int corner) {
  return corner == 0 ? -(weights[0][i] + weights[1][i]) : weights[corner - 1][i];
}

double ElasticKernel::stiffening(std::size_t v) const {
  double sum = 0;
  for (const auto& [t, corner] : corners_[v]) {
    const TriangleGroup& g = groups_[t / group];
    const LimitGroup& limits = limits_[t / group];
    const std::size_t i = t % group;
    sum += std::abs(at_corner(g.weft, i, corner)) * limits.stiffening_weft[i] +
           std::abs(at_corner(g.warp, i, corner)) * limits.stiffening_warp[i];
  }
  return sum;
}

[[gnu::always_inline]] inline void add_bending(const BendRows& rows, std::size_t v, double scale,
                                               const Vec4* x, Vec4& force) {
  const Vec4 here = x[v];
  Vec4 sum = {0, 0, 0, 0};
  const int* const vertex = rows.vertex.data();
  const double* const stiffness = rows.stiffness.data();
  const int end = rows.first[v + 1];
#pragma GCC unroll 4
  for (int i = rows.first[v]; i < end; ++i) sum -= stiffness[i] * (here - x[vertex[i]]);
  force += scale * sum;
}

TOILE_CLONES
void ElasticKernel::gather(std::size_t begin, std::size_t end, double bending, double seam_bending,
                           const Vec4s& x, Vec4s& force) const {
  for (std::size_t v = begin; v < end; ++v) {
    Vec4 sum = {0, 0, 0, 0};
    const int end_of_pulls = first_pull_[v + 1];
#pragma GCC unroll 2
    for (int i = first_pull_[v]; i < end_of_pulls; ++i) sum += pulls_[i];
    if (!bend_.inside.first.empty()) add_bending(bend_.inside, v, bending, x.data(), sum);
    if (!bend_.seams.first.empty()) {
      add_bending(bend_.seams, v, bending * seam_bending, x.data(), sum);
    }
    force[v] = sum;
  }
}

}  // namespace toile
