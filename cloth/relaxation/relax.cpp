#include "cloth/relaxation/relax.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "cloth/relaxation/block_stiffness.h"
#include "cloth/relaxation/cloth_forces.h"
#include "cloth/relaxation/constants.h"
#include "cloth/relaxation/isotropic_shares.h"
#include "cloth/relaxation/multilevel_preconditioner.h"
#include "cloth/scene/collider.h"
#include "geometry/error.h"
#include "geometry/parallel.h"
#include "geometry/statistics.h"

namespace toile {

namespace {

double smoothstep(double t) { return t * t * (3 - 2 * t); }

/// What of the seams should still be open, from one iteration to the next.
class ClosingSchedule {
 public:
  explicit ClosingSchedule(const RelaxOptions& options) : options_(options) {}

  /// The share of their width that seams may stand open at iteration i.
  double wanted(int i) const {
    const int iterations = passes_ ? options_.passing_iterations : options_.closing_iterations;
    const double t = std::min(1.0, static_cast<double>(i - begin_) / iterations);
    return from_ * (t < 1 ? 1 - smoothstep(t) : 0);
  }
  /// Whether nothing closes any more. `open`: per node, at iteration i.
  bool is_stuck(int i, const std::vector<double>& open) {
    const double left = std::accumulate(open.begin(), open.end(), 0.0);
    if (wanted(i) > 0 || least_ < 0) begin_waiting_ = i;
    if (wanted(i) > 0 || least_ < 0 || left < closing_progress * least_) {
      least_ = left;
      least_at_ = i;
    }
    return i - least_at_ >= closing_patience || i - begin_waiting_ >= max_closing_wait;
  }
  /// Begins anew from what is open at iteration i: seams now pass through what holds them apart.
  void begin_passing(int i, const std::vector<double>& open) {
    passes_ = true;
    begin_ = i;
    from_ = *std::max_element(open.begin(), open.end());
    least_ = -1;
  }
  bool passes() const { return passes_; }

 private:
  const RelaxOptions& options_;
  bool passes_ = false;
  int begin_ = 0;
  double from_ = 1;
  double least_ = -1;
  int least_at_ = 0;
  int begin_waiting_ = 0;
};

class Relaxation {
 public:
  Relaxation(const GarmentModel& model, const RelaxOptions& options, const std::vector<Vec3>& x)
      : model_(model),
        options_(options),
        forces_(model, options, {min_search_interval, max_search_interval}, x,
                options.closing_iterations > 0 && !model.offsets.empty()),
        // Without aggregates while seams close: with them, a closing dart turns its tip in.
        multilevel_(model, options.closing_iterations == 0),
        blocks_(model),
        step_factor_(step_factor / (1 + level_share * multilevel_.nested_levels() +
                                    aggregate_level_share *
                                        (multilevel_.levels() - multilevel_.nested_levels()))),
        touch_factor_(std::max(1.0, step_factor_ * (1 + multilevel_.levels()) / max_momentum_step)),
        node_force_(model.nodes, Vec4{}),
        x_(as_vec4(x)),
        stops_(4 * chunks_of(model.nodes, 4), 0),
        shares_(model),
        partial_(chunks_of(model.nodes, vertex_chunk)) {}

  RelaxReport run(const RelaxWatcher& watcher);
  std::vector<Vec3> state() const { return forces_.state(); }

 private:
  /// Moves all nodes; returns the power of the forces along the last step.
  double step();
  void take_forces(const Vec4s& forces, std::size_t begin, std::size_t end);
  void update_blocks();
  double bend_stiffness(std::size_t n) const {
    return model_.bend.empty() ? 0 : bending_ * model_.bend_diagonal[n];
  }
  Vec4 count_stops(std::size_t first, int moved);
  double step_nodes(std::size_t begin, std::size_t end, const ClothForces::Mover& move);
  enum class Untangling { goes_on, done, stuck };
  Untangling untangle(int iteration);
  Residual measure_residual();
  Residual last_residual();
  std::vector<std::size_t> held() const;
  bool is_pressed_to_body(std::size_t n) const;
  int leave_out_held();
  std::vector<double> node_weights_of_forces() const;
  void allow_for_loads();
  void adjust_momentum(double power, bool closing);
  bool stalls(const Residual& residual, int iteration);
  bool at_rest(const Residual& residual) const {
    return residual.median < options_.stop_median && residual.rms < options_.stop_rms &&
           (options_.stop_wide == 0 || residual.wide < options_.stop_wide);
  }

  const GarmentModel& model_;
  const RelaxOptions& options_;
  ClothForces forces_;  // its nodes are the iterate with momentum
  MultilevelPreconditioner multilevel_;
  BlockStiffness blocks_;
  int block_interval_ = min_block_interval;
  int until_blocks_ = 0;
  double step_factor_;
  /// Factor on the stiffness of contacts. It holds nodes on all levels alike, and their steps add
  /// up.
  double touch_factor_;
  Vec4s free_force_;  // node_force_, 0 on nodes that bounds hold
  Vec4s node_force_;  // N, stiffness of contacts (N/m) as the fourth
  Vec4s x_;           // the iterate before momentum
  /// Per node: grows by 2 when a bound stops it, else falls by 1. Filled up to groups of four.
  std::vector<int> stops_;
  IsotropicShares shares_;
  std::vector<double> partial_;
  double counted_force_ = std::numeric_limits<double>::infinity();  // N, see counted_force
  double bending_ = 1;
  double momentum_ = 0;
  double nearest_to_rest_ = -1;  // the smallest residual so far, in units of its goal
  int nearest_at_ = 0;           // the iteration of that residual
  std::size_t fewest_crossing_ = std::numeric_limits<std::size_t>::max();  // nodes
  int fewest_crossing_at_ = 0;                                             // the iteration
  int momentum_age_ = 0;  // iterations that momentum has grown for
};

/// Takes the forces on nodes `begin` to `end`, with the stiffness of contacts as the fourth.
TOILE_CLONES
void Relaxation::take_forces(const Vec4s& forces, std::size_t begin, std::size_t end) {
  for (std::size_t n = begin; n < end; ++n) {
    const double stiffness = forces[n][3];
    const double contacts =
        touch_factor_ * (stiffness - forces_.stretch_stiffness(n) - bend_stiffness(n));
    // A number stored into a vector that is then read whole would hold up the next read.
    node_force_[n] = __builtin_shufflevector(forces[n], repeated(contacts), 0, 1, 2, 7);
  }
}

/// Updates the blocks when they are due. While seams stand open, panels turn fast. So blocks stay
/// zero, and the stiffness is isotropic.
void Relaxation::update_blocks() {
  if (forces_.seams_stand_open() || --until_blocks_ > 0) return;
  const double turn = std::max(blocks_.update(forces_.nodes()), 1e-9);
  block_interval_ = static_cast<int>(std::clamp<double>(block_interval_ * max_block_turn / turn,
                                                        min_block_interval, max_block_interval));
  until_blocks_ = block_interval_;
  multilevel_.set_blocks(blocks_.of_nodes(), shares_.of_nodes());
}

/// Counts the stops of four nodes from `first` on; `moved` has a bit for each that was not stopped.
[[gnu::always_inline]] inline Vec4 Relaxation::count_stops(std::size_t first, int moved) {
  using Counts = int __attribute__((vector_size(16), aligned(4), may_alias));
  using Bits = int __attribute__((vector_size(16)));
  Counts& counts = *reinterpret_cast<Counts*>(&stops_[first]);
  const Bits bits = {1, 2, 4, 8};
  Bits sum = counts + (((bits & moved) != 0) ? Bits{-1, -1, -1, -1} : Bits{2, 2, 2, 2});
  sum = sum > 0 ? sum : Bits{};
  sum = sum < 2 * held_stops ? sum : Bits{} + 2 * held_stops;
  counts = sum;
  return __builtin_convertvector(sum, Vec4);
}

/// Four nodes at a time: the arithmetic of one node waits for its roots and quotients.
TOILE_CLONES
double Relaxation::step_nodes(std::size_t begin, std::size_t end, const ClothForces::Mover& move) {
  double power = 0;
  for (std::size_t first = begin; first < end; first += 4) {
    const std::size_t last = std::min(first + 4, end);
    const Places at(first, last);
    Vec4 contacts;
    const Columns force = at.of(node_force_, &contacts);
    const Vec4 isotropic = blocks_.known() ? at.of(shares_.of_nodes()) : repeated(1);
    const Vec4 bend = model_.bend.empty() ? Vec4{} : bending_ * at.of(model_.bend_diagonal);
    const Vec4 limits = forces_.has_limits()
                            ? Vec4{forces_.limit_stiffness(at[0]), forces_.limit_stiffness(at[1]),
                                   forces_.limit_stiffness(at[2]), forces_.limit_stiffness(at[3])}
                            : Vec4{};
    const Vec4 stiffness = contacts + bend + limits + isotropic * at.of(model_.stretch_diagonal);
    const Vec4 length = repeated(step_factor_);
    Columns displacement = length * solve_blocks(blocks_.of_nodes(), at, stiffness, force);
    displacement =
        displacement + length * columns_of(multilevel_.of_node(at[0]), multilevel_.of_node(at[1]),
                                           multilevel_.of_node(at[2]), multilevel_.of_node(at[3]));
    const Columns next = at.of(forces_.nodes()) + shortened(displacement, options_.max_move);
    const Columns motion = next - at.of(x_);
    // A node that is pulled much harder than most, as one that trembles, counts no more than they.
    const Vec4 hardness = square_root(dot(force, force)) / counted_force_;
    const Vec4 own_power = dot(force, motion) / larger(hardness, repeated(1));
    const Columns wanted = next + repeated(momentum_) * shortened(motion, options_.max_move);
    Vec4 next_rows[4];
    Vec4 wanted_rows[4];
    store_rows(next, next_rows, {0, 1, 2, 3});
    store_rows(wanted, wanted_rows, {0, 1, 2, 3});
    Vec4 glides[4] = {};
    int all_moved = 0;  // a bit for each node
    for (std::size_t i = 0; first + i < last; ++i) {
      const std::size_t n = first + i;
      const Vec4 before = forces_.node(n);
      const bool moved = move(n, wanted_rows[i]);
      x_[n] = moved ? next_rows[i] : forces_.node(n);
      // A node against its bound goes nowhere, however hard it is pulled.
      if (moved) power += own_power[i];
      all_moved |= static_cast<int>(moved) << i;
      glides[i] = forces_.node(n) - before;
    }
    shares_.adapt(first, last, glides, count_stops(first, all_moved));
  }
  return power;
}

double Relaxation::step() {
  momentum_ = std::min(options_.momentum, momentum_age_ / (momentum_age_ + 3.0));
  update_blocks();
  forces_.step_forces(bending_, [&](std::size_t begin, std::size_t end, const Vec4s& forces) {
    take_forces(forces, begin, end);
  });
  // The forces on nodes that bounds hold move no patch. Else patches would move against the steps
  // of the nodes around, and those would stand still under any force.
  const std::vector<std::size_t> stopped = held();
  if (stopped.empty()) {
    multilevel_.compute(node_force_, bending_);
  } else {
    free_force_ = node_force_;
    for (const std::size_t n : stopped) free_force_[n] = Vec4{0, 0, 0, node_force_[n][3]};
    multilevel_.compute(free_force_, bending_);
  }
  forces_.advance([&](std::size_t begin, std::size_t end, const ClothForces::Mover& move) {
    partial_[begin / vertex_chunk] = step_nodes(begin, end, move);
  });
  if (options_.barrier) {
    for (const int n : forces_.leave_body()) x_[n] = forces_.node(n);
  }
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

/// Draws crossing cloth apart, when it is due.
Relaxation::Untangling Relaxation::untangle(int iteration) {
  if (!options_.untangles || iteration % crossing_interval != 0) return Untangling::goes_on;
  const std::vector<int>& moved = forces_.leave_cloth();
  for (const int n : moved) x_[n] = forces_.node(n);
  if (moved.empty()) return Untangling::done;
  if (moved.size() < fewest_crossing_) {
    fewest_crossing_ = moved.size();
    fewest_crossing_at_ = iteration;
  }
  return iteration - fewest_crossing_at_ > crossing_patience ? Untangling::stuck
                                                             : Untangling::goes_on;
}

/// The residual at the present positions, with contacts found anew.
Residual Relaxation::measure_residual() {
  update_blocks();
  forces_.fresh_forces(bending_, [&](std::size_t begin, std::size_t end, const Vec4s& forces) {
    take_forces(forces, begin, end);
  });
  return last_residual();
}

/// The nodes that bounds hold.
std::vector<std::size_t> Relaxation::held() const {
  std::vector<std::size_t> nodes;
  for (std::size_t n = 0; n < node_force_.size(); ++n) {
    if (stops_[n] >= held_stops) nodes.push_back(n);
  }
  return nodes;
}

/// Whether a node lies on the body and is pulled into it. Its bound then holds it as a contact
/// would.
bool Relaxation::is_pressed_to_body(std::size_t n) const {
  if (!touches_body(model_.scene)) return false;
  const DistanceGrid::Sample skin = model_.scene.collider->grid().at(as_vec3(forces_.node(n)));
  const double offset = model_.body_offset + forces_.extra_offset(static_cast<int>(n));
  return skin.distance < offset + pressed_distance &&
         as_vec3(node_force_[n]).dot(skin.gradient) < 0;
}

/// Leaves the forces on nodes that bounds hold out of node_force_, which the next step finds anew.
/// Returns their number; 0 where too many are held by something other than the body.
int Relaxation::leave_out_held() {
  const std::vector<std::size_t> stopped = held();
  const auto caught =
      std::ranges::count_if(stopped, [this](std::size_t n) { return !is_pressed_to_body(n); });
  if (static_cast<double>(caught) > max_held_share * model_.nodes) return 0;
  for (const std::size_t n : stopped) node_force_[n] = Vec4{};
  return static_cast<int>(stopped.size());
}

/// The force on each node, in mean node weights.
std::vector<double> Relaxation::node_weights_of_forces() const {
  std::vector<double> norms(node_force_.size());
  for (std::size_t n = 0; n < norms.size(); ++n) {
    norms[n] = std::sqrt(squared_length(node_force_[n])) / model_.mean_weight;
  }
  return norms;
}

/// Takes a small share of the load of each node off its force in node_force_, which the next step
/// finds anew.
void Relaxation::allow_for_loads() {
  for (std::size_t n = 0; n < node_force_.size(); ++n) {
    Vec4& force = node_force_[n];
    const double stiffness = force[3];
    force[3] = 0;
    const double length = std::sqrt(squared_length(force));
    const double load = forces_.load(n);
    const double beyond = std::max(load - tight_load * model_.mean_weight, 0.0);
    const double counted = length - balanced_share * load - tight_balanced_share * beyond;
    force *= counted > 0 ? counted / length : 0;
    force[3] = stiffness;
  }
}

/// The residual of the forces that the last step found.
Residual Relaxation::last_residual() {
  const int held = leave_out_held();
  const Residual whole = residual_of(node_weights_of_forces());
  if (!std::isfinite(whole.rms)) {
    throw Error("garment", "its forces grew beyond all numbers",
                "check the fabric's stiffness and the panels for degenerate triangles");
  }
  counted_force_ =
      std::max(counted_force * whole.median, counted_rms * whole.rms) * model_.mean_weight;
  allow_for_loads();
  multilevel_.compute(node_force_, bending_);
  Residual r = residual_of(node_weights_of_forces());
  r.held = held;
  r.wide = multilevel_.rms_acceleration() / std::max(model_.scene.gravity.norm(), 1e-9);
  return r;
}

/// Cuts the momentum when the forces, summed over all nodes, are against the last step.
void Relaxation::adjust_momentum(double power, bool closing) {
  const bool uphill = power < 0 && !closing && momentum_age_ >= min_momentum_age;
  momentum_age_ = uphill ? static_cast<int>(kept_momentum_age * momentum_age_) : momentum_age_ + 1;
}

/// Whether the residual has made no progress toward its goal for too long. Then a node or two are
/// held against their bounds, and further iterations would not change that. Where a fold snaps
/// through, the count begins anew.
bool Relaxation::stalls(const Residual& residual, int iteration) {
  if (options_.patience == 0) return false;
  double farthest =
      std::max(residual.median / options_.stop_median, residual.rms / options_.stop_rms);
  if (options_.stop_wide > 0) farthest = std::max(farthest, residual.wide / options_.stop_wide);
  if (nearest_to_rest_ < 0 || farthest < stall_progress * nearest_to_rest_ ||
      farthest > snap_through_ratio * nearest_to_rest_) {
    nearest_to_rest_ = farthest;
    nearest_at_ = iteration;
  }
  return iteration - nearest_at_ > options_.patience;
}

RelaxReport Relaxation::run(const RelaxWatcher& watcher) {
  const auto start = std::chrono::steady_clock::now();
  RelaxReport report;
  int waited = 0;
  const bool closing = forces_.seams_stand_open();
  ClosingSchedule seams(options_);
  const int schedule = closing ? options_.closing_iterations : options_.max_iterations;
  for (int i = 0; i < options_.max_iterations; ++i) {
    const double t = std::min(1.0, static_cast<double>(i) / schedule);
    bending_ = options_.bending_from * std::pow(options_.bending_to / options_.bending_from, t);
    if (options_.stiffening_iterations > 0) {
      const double stiffened = static_cast<double>(i) / options_.stiffening_iterations;
      forces_.resist_compression(std::pow(options_.compression, 1 - std::min(stiffened, 1.0)));
    }
    if (closing) {
      forces_.close_seams(seams.wanted(i));
      report.converged = !forces_.seams_stand_open();
      if (report.converged) break;
      if (seams.is_stuck(i, forces_.open())) {
        if (seams.passes() || options_.passing_iterations == 0) break;
        report.held = {state(), forces_.open()};
        seams.begin_passing(i, forces_.open());
        forces_.pass_through_cloth(options_.passes_body);
      }
    }
    const Untangling untangling = untangle(i);
    report.converged = untangling == Untangling::done;
    if (untangling != Untangling::goes_on) break;
    const double power = step();
    adjust_momentum(power, closing);
    report.iterations = i + 1;
    if ((i + 1) % residual_interval != 0 && i + 1 != options_.max_iterations) continue;
    if (watcher) watcher({i + 1, forces_.open(), state()});
    if (closing) continue;
    const bool within_limits = waited >= max_limit_waits || forces_.update_multipliers();
    const Residual left = last_residual();
    if (left.median < options_.stop_median) ++waited;
    if (i < options_.stiffening_iterations) continue;
    if (stalls(left, i)) break;
    if (!within_limits || !at_rest(left)) continue;
    report.residual = measure_residual();
    report.converged = at_rest(report.residual);
    if (report.converged) break;
  }
  if (!closing && (!report.converged || options_.untangles)) report.residual = measure_residual();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.open = forces_.open();
  report.searches = forces_.searches();
  report.warm_start = forces_.warm_start();
  for (int n = 0; n < model_.nodes; ++n) report.extra_offset.push_back(forces_.extra_offset(n));
  return report;
}

}  // namespace

Residual residual_of(std::vector<double> forces) {
  Residual r;
  r.rms = root_mean_square(forces);
  if (!std::isfinite(r.rms)) return r;
  const auto hardest = std::max_element(forces.begin(), forces.end());
  r.max = *hardest;
  r.hardest = static_cast<int>(hardest - forces.begin());
  r.median = median(std::move(forces));
  return r;
}

RelaxReport relax(const GarmentModel& model, const RelaxOptions& options, std::vector<Vec3>& x,
                  const RelaxWatcher& watcher) {
  Relaxation relaxation(model, options, x);
  RelaxReport report = relaxation.run(watcher);
  x = relaxation.state();
  return report;
}

}  // namespace toile
