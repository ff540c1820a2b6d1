#include "cloth/relaxation/release.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "cloth/relaxation/cloth_forces.h"
#include "cloth/relaxation/constants.h"
#include "geometry/error.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

/// Options for a motion in time. Old bounds must not stop nodes in flight, and contacts to come
/// must not make them heavier.
ReleaseOptions in_time(ReleaseOptions options) {
  options.search_share = release_search_share;
  options.activation_distance = 0;
  return options;
}

class Release {
 public:
  Release(const GarmentModel& model, const ReleaseOptions& options, const std::vector<Vec3>& x);
  ReleaseReport run();
  /// Metres, one a node: where forces were taken, which is within the bounds.
  std::vector<Vec3> state() const { return forces_.state(); }

 private:
  void step_nodes(std::size_t begin, std::size_t end, const ClothForces::Mover& move);
  double kinetic() const;

  const GarmentModel& model_;
  const ReleaseOptions options_;
  ClothForces forces_;  // its nodes are where forces are taken
  Vec4s x_;
  Vec4s v_;
  Vec4s force_;  // N, stiffness (N/m) as the fourth
  double step_ = 0;
  double max_inverse_ = 0;  // 1/s²: the largest stable ratio of stiffness to mass
};

Release::Release(const GarmentModel& model, const ReleaseOptions& options,
                 const std::vector<Vec3>& x)
    : model_(model),
      options_(in_time(options)),
      forces_(model, options_, {1, max_search_interval}, x, false),
      x_(as_vec4(x)),
      v_(model.nodes, Vec4{}),
      force_(model.nodes, Vec4{}) {
  double max_ratio = 0;
  for (int n = 0; n < model.nodes; ++n) {
    if (!(model.mass[n] > 0)) continue;
    double stiffness = forces_.stretch_stiffness(n);
    if (!model.bend.empty()) stiffness += options.bending * model.bend_diagonal[n];
    if (touches_body(model.scene)) stiffness += BodyContact::max_stiffness;
    max_ratio = std::max(max_ratio, stiffness / model.mass[n]);
  }
  // The motion is stable while (step·frequency)² (1 + 2 lookahead) < 4.
  const double limit = 4 * time_step_share * time_step_share / (1 + 2 * force_lookahead);
  const double stable = max_ratio > 0 ? std::sqrt(limit / max_ratio) : options.seconds;
  step_ = options.seconds / std::ceil(options.seconds / stable);
  max_inverse_ = limit / (step_ * step_);
}

TOILE_CLONES
void Release::step_nodes(std::size_t begin, std::size_t end, const ClothForces::Mover& move) {
  const double kept = std::exp(-options_.damping * step_);
  for (std::size_t n = begin; n < end; ++n) {
    Vec4 force = force_[n];
    const double stiffness = force[3];
    force[3] = 0;
    const double mass = std::max(model_.mass[n], stiffness / max_inverse_);
    if (!(mass > 0)) continue;
    v_[n] = kept * (v_[n] + step_ / mass * force);
    const Vec4 before = forces_.node(n);
    x_[n] += step_ * v_[n];
    const Vec4 motion = force_lookahead * step_ * v_[n];
    if (move(n, x_[n] + motion)) continue;
    // A node that its bounds stop gets the speed of its actual motion. Its own would carry it past
    // them.
    x_[n] = forces_.node(n);
    v_[n] = (x_[n] - before) / step_;
  }
}

double Release::kinetic() const {
  double sum = 0;
  for (std::size_t n = 0; n < v_.size(); ++n) {
    sum += 0.5 * model_.mass[n] * squared_length(v_[n]);
  }
  return sum;
}

double at_share(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at =
      values.begin() + static_cast<long>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

ReleaseReport Release::run() {
  const auto start = std::chrono::steady_clock::now();
  ReleaseReport report;
  report.seconds = options_.seconds;
  report.time_step = step_;
  report.steps = static_cast<int>(std::lround(options_.seconds / step_));
  report.moved.assign(x_.size(), 0);
  const Vec4s from = x_;
  const int watch = std::max(1, static_cast<int>(motion_watch_interval / step_));
  for (int i = 1; i <= report.steps; ++i) {
    forces_.step_forces(
        options_.bending, [&](std::size_t begin, std::size_t end, const Vec4s& found) {
          std::copy(found.begin() + begin, found.begin() + end, force_.begin() + begin);
        });
    forces_.advance([&](std::size_t begin, std::size_t end, const ClothForces::Mover& move) {
      step_nodes(begin, end, move);
    });
    if (i % watch != 0 && i != report.steps) continue;
    for (std::size_t n = 0; n < x_.size(); ++n) {
      report.moved[n] = std::max(report.moved[n], std::sqrt(squared_length(x_[n] - from[n])));
    }
    report.kinetic = kinetic();
    report.released_energy += 2 * options_.damping * report.kinetic * watch * step_;
    if (!std::isfinite(report.kinetic)) {
      throw Error("garment", "flies apart when it is let go",
                  "check the fabric's stiffness and the panels for degenerate triangles");
    }
  }
  report.released_energy += report.kinetic;
  report.all = move_statistics(report.moved);
  if (options_.warm_start != nullptr) {
    std::vector<double> moved;
    for (std::size_t n = 0; n < options_.warm_start->skin_anchors.size(); ++n) {
      if (options_.warm_start->skin_anchors[n]) moved.push_back(report.moved[n]);
    }
    report.sticking = static_cast<int>(moved.size());
    report.of_sticking = move_statistics(moved);
  }
  std::vector<double> speeds;
  for (const Vec4& v : v_) speeds.push_back(std::sqrt(squared_length(v)));
  report.speed_p99 = at_share(std::move(speeds), 0.99);
  report.warm_start = forces_.warm_start();
  report.searches = forces_.searches();
  report.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace

MoveStatistics move_statistics(const std::vector<double>& moved) {
  return {at_share(moved, 0.5), at_share(moved, 0.99), at_share(moved, 1)};
}

ReleaseReport release(const GarmentModel& model, const ReleaseOptions& options,
                      std::vector<Vec3>& x) {
  Release released(model, options, x);
  const ReleaseReport report = released.run();
  x = released.state();
  return report;
}

}  // namespace toile
