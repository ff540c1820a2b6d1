#include "cloth/relaxation/relax.h"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <numeric>

#include "cloth/body_pull.h"
#include "cloth/relaxation/body_contact.h"
#include "cloth/relaxation/elastic_kernel.h"
#include "cloth/relaxation/pair_forces.h"
#include "cloth/self_contact.h"
#include "geometry/error.h"

namespace toile {

namespace {

/// Steps are this much longer than the bound on the stiffness allows, for the bound is pessimistic:
/// 1 needs twice the iterations, 1.7 about the same.
constexpr double step_factor = 1.3;
/// Iterations between two measurements of the residual, and calls of the watcher.
constexpr int watch_interval = 50;
/// Least iterations between two searches for near cloth; a node that has used up its bound waits.
constexpr int search_interval = 8;
/// Vertices that one task handles, and groups of triangles and pairs; fixed, so that sums don't
/// depend on the threads.
constexpr std::size_t chunk = 512;
constexpr std::size_t pair_chunk = 128;

std::size_t chunks_of(std::size_t items, std::size_t size) { return (items + size - 1) / size; }

/// Runs `work` for each of `tasks`, side by side where that pays.
template <typename Work>
void side_by_side(std::size_t tasks, const Work& work) {
  if (tasks < 2) {
    for (std::size_t t = 0; t < tasks; ++t) work(t);
    return;
  }
  tbb::parallel_for(std::size_t{0}, tasks, work, tbb::static_partitioner());
}

/// Largest share in [0, 1] of `way` that keeps away + share·way within `radius`.
double share_within(const Vec3& away, const Vec3& way, double radius) {
  const double a = way.squaredNorm();
  if (a == 0 || (away + way).norm() <= radius) return 1;
  const double b = away.dot(way);
  const double c = std::min(away.squaredNorm() - radius * radius, 0.0);
  // Just inside: the root itself may round to the outside.
  return std::clamp((std::sqrt(b * b - a * c) - b) / a * (1 - 1e-9), 0.0, 1.0);
}

double smoothstep(double t) { return t * t * (3 - 2 * t); }

class Relaxation {
 public:
  Relaxation(const Program& program, const RelaxOptions& options, const std::vector<Vec3>& x)
      : program_(program),
        options_(options),
        stretch_{program.scene.strain_limit.value_or(-1), options.compression},
        x_(as_vec4(x)),
        y_(x_),
        partial_(chunks_of(program.nodes, chunk)) {
    if (layer_contact()) {
      for (const Vec3& p : layers().points) y_.push_back(as_vec4(p));
    }
    const bool closing = options.closing_iterations > 0 && !program.offsets.empty();
    open_ = closing ? 1 : 0;
    use_skin(closing);
  }

  RelaxReport run(const RelaxWatcher& watcher);
  std::vector<Vec3> state() const;

 private:
  /// The vertices that touch things: material points while seams stand open, else nodes.
  void use_skin(bool points);
  void close_seams(double t);
  bool bounded() const { return options_.bounded && !bound_.empty(); }
  void search_when_due();
  void search();
  void activate_pairs();
  void forces();
  /// One step of all nodes; returns the power of the forces along the last step.
  double step();
  double step_nodes(std::size_t begin, std::size_t end);
  void leave_guard(std::size_t node, Vec4& next_x, Vec4& next_y);
  Vec3 within_bounds(std::size_t node, const Vec3& wanted) const;
  void set_guard(std::size_t vertex, const Vec3& p);
  void set_guards();
  Residual measure_residual();
  Residual last_residual() const;
  bool at_rest(const Residual& residual) const {
    return residual.median < options_.stop_median && residual.rms < options_.stop_rms;
  }
  void place_points();
  std::vector<Vec3> all_positions() const;
  std::size_t vertices() const { return kernel_->vertices(); }
  const Vec4s& positions() const { return by_points_ ? points_ : y_; }
  bool self_contact() const { return program_.scene.self_contact; }
  bool layer_contact() const {
    return self_contact() && options_.layer_contact && program_.scene.layers != nullptr;
  }
  const TriangleMesh& layers() const { return *program_.scene.layers; }

  const Program& program_;
  const RelaxOptions& options_;
  const StretchOptions stretch_;
  Vec4s x_;  // the iterate before momentum
  Vec4s y_;  // where forces are taken: the state; then the layers' points
  std::vector<double> partial_;
  std::unique_ptr<ElasticKernel> kernel_;
  Vec4s vertex_force_;

  bool by_points_ = false;
  double open_ = 0;
  double bending_ = 1;
  double momentum_ = 0;
  Vec4s points_;                   // as y_, of the material points, while seams stand open
  std::vector<int> vertex_first_;  // per node, its material points, while seams stand open
  std::vector<int> vertices_;
  std::vector<BodyContact> contacts_;  // per vertex
  /// Per vertex: where it was last looked after, and the square of how far it may go from there
  /// before it has to be looked after again.
  Vec4s guards_;

  std::unique_ptr<ProximitySearch> proximity_;
  PairForces pairs_;
  std::vector<double> bound_;
  std::vector<Vec3> searched_at_;
  std::vector<Vec3> activated_at_;
  int since_search_ = 0;
  int searches_ = 0;
  std::atomic<bool> search_due_ = true;
  std::atomic<bool> activation_due_ = true;
  int momentum_age_ = 0;
};

std::vector<Vec3> Relaxation::state() const {
  std::vector<Vec3> state(program_.nodes);
  for (std::size_t n = 0; n < state.size(); ++n) state[n] = as_vec3(y_[n]);
  return state;
}

std::vector<Vec3> Relaxation::all_positions() const {
  std::vector<Vec3> all;
  all.reserve(vertices());
  for (const Vec4& p : positions()) all.push_back(as_vec3(p));
  return all;
}

void Relaxation::use_skin(bool points) {
  by_points_ = points;
  kernel_ = std::make_unique<ElasticKernel>(program_, points);
  const std::size_t count = kernel_->vertices();
  vertex_force_.assign(count, Vec4{});
  vertex_first_.clear();
  vertices_.clear();
  points_.clear();
  if (points) {
    vertex_first_.assign(program_.nodes + 1, 0);
    for (const int node : program_.node_of_point) ++vertex_first_[node + 1];
    std::partial_sum(vertex_first_.begin(), vertex_first_.end(), vertex_first_.begin());
    vertices_.resize(count);
    std::vector<int> next(vertex_first_.begin(), vertex_first_.end() - 1);
    for (std::size_t v = 0; v < count; ++v) {
      vertices_[next[program_.node_of_point[v]]++] = static_cast<int>(v);
    }
    place_points();
  }
  contacts_.assign(count, {});
  guards_.assign(count, Vec4{});
  pairs_.clear();
  bound_.clear();
  search_due_ = true;
  if (!self_contact()) {
    set_guards();
    return;
  }
  std::vector<int> node(count);
  std::vector<double> shortest(count);
  for (std::size_t v = 0; v < count; ++v) {
    node[v] = points ? program_.node_of_point[v] : static_cast<int>(v);
    shortest[v] = program_.shortest_edge[node[v]];
  }
  proximity_ = std::make_unique<ProximitySearch>(
      points ? program_.triangles : program_.node_triangles, node, shortest);
  if (layer_contact()) {
    proximity_->add_layer(layers().triangles, static_cast<int>(layers().points.size()),
                          program_.scene.layer_gap);
  }
}

void Relaxation::place_points() {
  if (points_.empty()) {
    points_.resize(program_.node_of_point.size());
    points_.insert(points_.end(), y_.begin() + program_.nodes, y_.end());
  }
  for (std::size_t p = 0; p < program_.node_of_point.size(); ++p) {
    points_[p] = y_[program_.node_of_point[p]] + open_ * as_vec4(program_.offsets[p]);
  }
}

void Relaxation::close_seams(double t) {
  const double wanted = t < 1 ? 1 - smoothstep(t) : 0;
  double open = wanted;
  if (bounded()) {
    // The closing moves points too: no farther than their bounds allow.
    for (std::size_t p = 0; p < program_.offsets.size(); ++p) {
      const Vec3 away = as_vec3(points_[p]) - searched_at_[p];
      const Vec3 way = (wanted - open_) * program_.offsets[p];
      const double share = share_within(away, way, bound_[p]);
      if (share < 1) search_due_ = true;
      open = std::max(open, open_ + share * (wanted - open_));
    }
  }
  if (open <= 0) {
    open_ = 0;
    use_skin(false);
    return;
  }
  open_ = open;
  place_points();
  for (std::size_t p = 0; p < vertices(); ++p) {
    const Vec4 moved = points_[p] - guards_[p];
    if (squared_length(moved) > guards_[p][3]) set_guard(p, as_vec3(points_[p]));
  }
}

void Relaxation::search_when_due() {
  // Unbounded, a node may leave the searched neighbourhood: look again now and then.
  if (!options_.bounded && since_search_ >= watch_interval) search_due_ = true;
  if (search_due_ && (since_search_ >= search_interval || bound_.empty())) {
    search();
    ++searches_;
  } else if (activation_due_) {
    activate_pairs();
  }
  ++since_search_;
}

void Relaxation::search() {
  const std::vector<Vec3> p = all_positions();
  const double gap = program_.self_gap;
  // Bounds that nobody keeps say nothing of where things are.
  if (bounded()) {
    proximity_->update(p, options_.self_radius, gap, pairs_.pairs(), bound_, searched_at_,
                       by_points_);
  } else {
    proximity_->find(p, options_.self_radius, gap, pairs_.pairs(), bound_, by_points_);
    searched_at_ = p;
  }
  since_search_ = 0;
  search_due_ = false;
  activate_pairs();
}

void Relaxation::activate_pairs() {
  activated_at_ = all_positions();
  pairs_.activate(activated_at_);
  activation_due_ = false;
  set_guards();
}

void Relaxation::set_guards() {
  side_by_side(chunks_of(vertices(), chunk), [&](std::size_t c) {
    const std::size_t end = std::min(vertices(), (c + 1) * chunk);
    for (std::size_t v = c * chunk; v < end; ++v) set_guard(v, as_vec3(positions()[v]));
  });
}

/// How far a vertex that stands at `p` may go until it has to be looked after again: because the
/// body is near, its bound used up, or a pair may begin to push.
void Relaxation::set_guard(std::size_t v, const Vec3& p) {
  double reach = 1e3;
  if (program_.scene.body != nullptr) {
    if (contacts_[v].remaining(p) <= 0) contacts_[v].look(program_.scene, p, options_.body_offset);
    reach = contacts_[v].remaining(p);
  }
  if (bounded()) {
    const double left = bound_[v] - (p - searched_at_[v]).norm();
    reach = std::min(reach, std::max(left, 0.0));
  }
  if (!bound_.empty() && !activation_due_) {
    const double left = 0.5 * PairForces::margin - (p - activated_at_[v]).norm();
    if (left <= 0) activation_due_ = true;
    reach = std::min(reach, std::max(left, 0.0));
  }
  guards_[v] = as_vec4(p);
  guards_[v][3] = reach * reach;
}

void Relaxation::forces() {
  const Vec4s& p = positions();
  const std::size_t pulls = chunks_of(kernel_->groups(), chunk);
  const std::size_t pushes = chunks_of(pairs_.active(), pair_chunk);
  side_by_side(pulls + pushes, [&](std::size_t c) {
    if (c < pulls) {
      kernel_->pull(c * chunk, std::min(kernel_->groups(), (c + 1) * chunk), stretch_, p);
    } else {
      const std::size_t begin = (c - pulls) * pair_chunk;
      pairs_.push(begin, std::min(pairs_.active(), begin + pair_chunk), options_.bounded, p);
    }
  });
  side_by_side(chunks_of(vertices(), chunk), [&](std::size_t c) {
    // A seam bends as one cloth only when it is sewn.
    kernel_->gather(c * chunk, std::min(vertices(), (c + 1) * chunk), bending_, 1 - open_, p,
                    vertex_force_);
  });
}

/// Where a node comes to on its way to `wanted` without any of its vertices leaving its bound.
Vec3 Relaxation::within_bounds(std::size_t node, const Vec3& wanted) const {
  if (!by_points_) {
    const Vec3 away = wanted - searched_at_[node];
    const double distance = away.norm();
    return distance > bound_[node] ? searched_at_[node] + away * (bound_[node] / distance) : wanted;
  }
  const Vec3 from = as_vec3(y_[node]);
  const Vec3 way = wanted - from;
  double share = 1;
  for (int i = vertex_first_[node]; i < vertex_first_[node + 1]; ++i) {
    const int v = vertices_[i];
    share = std::min(share, share_within(as_vec3(points_[v]) - searched_at_[v], way, bound_[v]));
  }
  return share < 1 ? Vec3(from + share * way) : wanted;
}

/// A node that leaves the guard of one of its vertices: stopped at its bounds, looked after anew.
void Relaxation::leave_guard(std::size_t node, Vec4& next_x, Vec4& next_y) {
  if (bounded()) {
    const Vec3 wanted = as_vec3(next_y);
    const Vec3 allowed = within_bounds(node, wanted);
    if (allowed != wanted) {
      next_x = next_y = as_vec4(allowed);
      search_due_ = true;
    }
  }
  if (!by_points_) {
    set_guard(node, as_vec3(next_y));
    return;
  }
  for (int i = vertex_first_[node]; i < vertex_first_[node + 1]; ++i) {
    const int v = vertices_[i];
    set_guard(v, as_vec3(next_y) + open_ * program_.offsets[v]);
  }
}

TOILE_CLONES
double Relaxation::step_nodes(std::size_t begin, std::size_t end) {
  const Vec4 gravity = options_.gravity * as_vec4(program_.scene.gravity);
  const bool has_body = program_.scene.body != nullptr;
  const double most_squared = options_.max_move * options_.max_move;
  double power = 0;
  for (std::size_t n = begin; n < end; ++n) {
    Vec4 force = program_.mass[n] * gravity;
    double stiffness = program_.stretch_diagonal[n];
    if (!program_.bend.empty()) stiffness += bending_ * program_.bend_diagonal[n];
    const double friction = options_.friction ? program_.friction_skin[n] : 0;
    const int first = by_points_ ? vertex_first_[n] : static_cast<int>(n);
    const int last = by_points_ ? vertex_first_[n + 1] : first + 1;
    for (int i = first; i < last; ++i) {
      const int v = by_points_ ? vertices_[i] : i;
      const Vec4& p = positions()[v];
      force += vertex_force_[v];
      pairs_.add(v, force, stiffness);
      if (has_body) contacts_[v].add(p, friction, force, stiffness);
      if (options_.pull > 0 && has_body) {
        const double weight =
            program_.mass[n] / (last - first) * program_.scene.gravity.norm() * options_.pull;
        force += as_vec4(pull_to_body(program_.scene, as_vec3(p), weight));
      }
    }
    force[3] = 0;
    if (!by_points_) vertex_force_[n] = force;
    // A node that no triangle holds has nothing to be moved by.
    Vec4 way = stiffness > 0 ? step_factor / stiffness * force : Vec4{};
    const double squared = squared_length(way);
    if (squared > most_squared) way *= options_.max_move / std::sqrt(squared);
    Vec4 next_x = y_[n] + way;
    Vec4 glide = next_x - x_[n];
    power += dot(force, glide);
    const double speed = squared_length(glide);
    if (speed > most_squared) glide *= options_.max_move / std::sqrt(speed);
    Vec4 next_y = next_x + momentum_ * glide;
    for (int i = first; i < last; ++i) {
      const int v = by_points_ ? vertices_[i] : i;
      const Vec4 moved = positions()[v] + (next_y - y_[n]) - guards_[v];
      if (squared_length(moved) <= guards_[v][3]) continue;
      leave_guard(n, next_x, next_y);
      break;
    }
    x_[n] = next_x;
    y_[n] = next_y;
  }
  return power;
}

double Relaxation::step() {
  momentum_ = std::min(options_.momentum, momentum_age_ / (momentum_age_ + 3.0));
  side_by_side(partial_.size(), [&](std::size_t c) {
    const std::size_t end = std::min<std::size_t>(program_.nodes, (c + 1) * chunk);
    partial_[c] = step_nodes(c * chunk, end);
  });
  if (by_points_) place_points();
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

/// Of the state as it is now, the body looked at anew: a step that is taken back.
Residual Relaxation::measure_residual() {
  for (BodyContact& contact : contacts_) contact.forget();
  if (self_contact()) activate_pairs();
  set_guards();
  const Vec4s x = x_;
  const Vec4s y = y_;
  forces();
  step();
  x_ = x;
  y_ = y;
  set_guards();
  return last_residual();
}

/// Of the state that the last step found.
Residual Relaxation::last_residual() const {
  Residual r;
  std::vector<double> norms(program_.nodes);
  double sum = 0;
  for (std::size_t n = 0; n < norms.size(); ++n) {
    norms[n] = std::sqrt(squared_length(vertex_force_[n])) / program_.mean_weight;
    sum += norms[n] * norms[n];
  }
  r.rms = std::sqrt(sum / static_cast<double>(norms.size()));
  if (!std::isfinite(r.rms)) {
    throw Error("garment", "its forces grew beyond all numbers",
                "check the fabric's stiffness and the panels for degenerate triangles");
  }
  r.max = *std::max_element(norms.begin(), norms.end());
  std::nth_element(norms.begin(), norms.begin() + norms.size() / 2, norms.end());
  r.median = norms[norms.size() / 2];
  return r;
}

RelaxReport Relaxation::run(const RelaxWatcher& watcher) {
  const auto start = std::chrono::steady_clock::now();
  RelaxReport report;
  const int schedule = by_points_ ? options_.closing_iterations : options_.max_iterations;
  for (int i = 0; i < options_.max_iterations; ++i) {
    const double t = std::min(1.0, static_cast<double>(i) / schedule);
    bending_ = options_.bending_from * std::pow(options_.bending_to / options_.bending_from, t);
    if (by_points_) {
      close_seams(t);
      if (!by_points_) {
        report.converged = true;
        break;
      }
    }
    if (self_contact()) search_when_due();
    forces();
    const double power = step();
    momentum_age_ = power < 0 && !by_points_ ? 0 : momentum_age_ + 1;
    report.iterations = i + 1;
    if ((i + 1) % watch_interval != 0 && i + 1 != options_.max_iterations) continue;
    if (watcher) watcher({i + 1, open_, state()});
    if (by_points_ || !at_rest(last_residual())) continue;
    report.residual = measure_residual();
    report.converged = at_rest(report.residual);
    if (report.converged) break;
  }
  if (!report.converged && !by_points_) report.residual = measure_residual();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.open = open_;
  report.searches = searches_;
  return report;
}

}  // namespace

std::vector<Vec3> point_positions(const Program& program, const std::vector<Vec3>& nodes,
                                  double open) {
  std::vector<Vec3> points(program.node_of_point.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    points[p] = nodes[program.node_of_point[p]];
    if (!program.offsets.empty()) points[p] += open * program.offsets[p];
  }
  return points;
}

RelaxReport relax(const Program& program, const RelaxOptions& options, std::vector<Vec3>& x,
                  const RelaxWatcher& watcher) {
  Relaxation relaxation(program, options, x);
  const RelaxReport report = relaxation.run(watcher);
  x = relaxation.state();
  return report;
}

}  // namespace toile
