#include "cloth/springs/spring_motion.h"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>

#include "cloth/contact/body_attraction.h"
#include "cloth/judge/constants.h"
#include "cloth/scene/collider.h"
#include "cloth/springs/constants.h"
#include "geometry/error.h"
#include "geometry/parallel.h"
#include "geometry/statistics.h"

namespace toile {

namespace {

std::string shown(double value) {
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

}  // namespace

SpringMotion::SpringMotion(const PanelMesh& garment, const GarmentModel& model,
                           const SpringOptions& options, const std::vector<Vec3>& placed)
    : model_(model),
      options_(options),
      sheet_(garment, model),
      strain_options_(options.strain),
      x_(placed),
      v_(placed.size(), Vec3::Zero()),
      force_(placed.size()) {
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      const int a = seam.a[i];
      const int b = seam.b[i];
      if (a != b) open_.push_back({a, b, (placed[a] - placed[b]).norm()});
    }
  }
  if (touches_body(model.scene)) {
    subject_.emplace(model.scene.collider->surface(), sheet_.triangles());
  }
  if (model.scene.self_contact) {
    self_.emplace(model, model.self_gap);
  }
  reconnect();
  choose_time_step();
}

void SpringMotion::reconnect() {
  sheet_.refresh();
  springs_.emplace(all_springs(), sheet_.points());
  if (subject_) subject_->set_cloth(sheet_.triangles());
  node_.resize(sheet_.points());
  for (int p = 0; p < sheet_.points(); ++p) node_[p] = sheet_.node(p);
  choose_limited_springs();
}

void SpringMotion::choose_limited_springs() {
  std::vector<char> eased(sheet_.points(), 0);
  for (const auto& [a, b, first_gap] : open_) {
    if ((x_[a] - x_[b]).norm() < easing_gap) eased[node_[a]] = eased[node_[b]] = 1;
  }
  std::vector<Spring> limited;
  for (const Spring& spring : sheet_.edges()) {
    if (!eased[spring.a] && !eased[spring.b]) limited.push_back(spring);
  }
  strain_.emplace(limited, sheet_.points());
}

std::vector<Spring> SpringMotion::all_springs() const {
  std::vector<Spring> all = sheet_.edges();
  all.insert(all.end(), sheet_.bending().begin(), sheet_.bending().end());
  return all;
}

/// Merging adds springs and masses alike: the step of the open panels serves to the end.
void SpringMotion::choose_time_step() {
  const double stable = stable_step(all_springs(), sheet_.inverse_mass(), options_.drag);
  time_step_ = options_.time_step > 0 ? options_.time_step : options_.step_share * stable;
  if (time_step_ <= max_step_share * stable) return;
  throw Error("time step",
              "of " + shown(1e6 * time_step_) + " µs is too long: this cloth moves stably up to " +
                  shown(1e6 * stable) + " µs",
              "leave --time-step out, or give a shorter one");
}

void SpringMotion::close_bounds() {
  if (self_) self_->leave_out_neighbours(false);
}

void SpringMotion::converge_strain() {
  strain_options_.sweep = StrainSweep::in_order;
  strain_options_.mean_of_passes = false;
  strain_options_.passes = converging_passes;
  strain_options_.tolerance = converged_excess * options_.strain.limit;
  strain_options_.limit = aimed_limit_share * options_.strain.limit;
}

void SpringMotion::stiffen_bending(double factor) {
  sheet_.stiffen_bending(factor);
  reconnect();
  choose_time_step();
}

void SpringMotion::step(const SpringStage& stage) {
  if (!open_.empty() && counts_.steps % easing_interval == 0) choose_limited_springs();
  accelerate(stage);
  sew(stage, std::numeric_limits<double>::infinity());
  const auto& inverse_mass = sheet_.inverse_mass();
  if (options_.strain_scheme == StrainScheme::velocity) {
    strain_->adjust_velocities(x_, inverse_mass, time_step_, strain_options_, v_);
  }
  if (self_) self_->respond(x_, node_, inverse_mass, time_step_, v_);
  if (subject_) {
    const double friction = stage.friction ? model_.scene.fabric.friction_skin : 0;
    subject_->respond(x_, inverse_mass, time_step_,
                      {.tolerance = options_.tolerance,
                       .restitution = options_.restitution,
                       .friction = friction},
                      v_);
  }
  // What was about to meet is not kept apart by less than the collisions' gap.
  sew(stage, landing_gap);
  if (self_) self_->bound(x_, node_, time_step_, v_);
  for (std::size_t p = 0; p < x_.size(); ++p) x_[p] += time_step_ * v_[node_[p]];
  if (options_.strain_scheme == StrainScheme::position) {
    strain_->adjust_positions(inverse_mass, strain_options_, x_);
    for (std::size_t p = 0; p < x_.size(); ++p) x_[p] = x_[node_[p]];
  }
  if (!open_.empty()) merge_closed_pairs();
  ++counts_.steps;
}

void SpringMotion::accelerate(const SpringStage& stage) {
  std::fill(force_.begin(), force_.end(), Vec3::Zero());
  springs_->add(x_, v_, force_);
  const Scene& scene = model_.scene;
  const double dt = time_step_;
  const double g = scene.gravity.norm();
  parallel_for_chunks(x_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const double mass = sheet_.mass()[n];
      if (mass <= 0) continue;
      Vec3 f = force_[n] + stage.gravity * mass * scene.gravity;
      if (stage.attraction > 0) f += body_attraction(scene, x_[n], stage.attraction * mass * g);
      v_[n] = (v_[n] + dt * f / mass) / (1 + dt * options_.drag);
    }
  });
}

/// Pulls together the open pairs that are nearer than `within`.
void SpringMotion::sew(const SpringStage& stage, double within) {
  for (int sweep = 0; sweep < sewing_sweeps; ++sweep) {
    if (sweep > 0) within = std::min(within, easing_gap);
    for (const OpenPair& open : open_) {
      const int a = node_[open.a];
      const int b = node_[open.b];
      const double gap = (x_[a] - x_[b]).norm();
      if (a == b || gap > within || gap < stage.open * open.first_gap) continue;
      SewnPair pair{x_[a], x_[b], v_[a], v_[b], sheet_.mass()[a], sheet_.mass()[b]};
      sew_step(stage.sewing, time_step_, pair);
      v_[a] = pair.v_a;
      v_[b] = pair.v_b;
    }
  }
}

void SpringMotion::merge_closed_pairs() {
  bool merged = false;
  std::erase_if(open_, [&](const OpenPair& pair) {
    const int a = node_[pair.a];
    const int b = node_[pair.b];
    if (a != b) {
      if ((x_[a] - x_[b]).norm() >= sewn_gap) return false;
      // Two pairs of this step may share a node: weigh by what is merged already.
      const double mass_a = sheet_.mass()[a];
      const double mass_b = sheet_.mass()[b];
      const Vec3 x = (mass_a * x_[a] + mass_b * x_[b]) / (mass_a + mass_b);
      const Vec3 v = (mass_a * v_[a] + mass_b * v_[b]) / (mass_a + mass_b);
      x_[a] = x_[b] = x;
      v_[a] = v_[b] = v;
      sheet_.merge(a, b);
      merged = true;
    }
    ++counts_.merged;
    return true;
  });
  if (!merged) return;
  reconnect();
  for (std::size_t p = 0; p < x_.size(); ++p) {
    x_[p] = x_[node_[p]];
    if (sheet_.mass()[p] <= 0) v_[p].setZero();
  }
}

double SpringMotion::open_gap(double share) const {
  if (open_.empty()) return 0;
  std::vector<double> gaps;
  for (const auto& [a, b, first_gap] : open_) gaps.push_back((x_[a] - x_[b]).norm());
  return percentile(std::move(gaps), share);
}

}  // namespace toile
