#include "cloth/relax.h"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numeric>

#include "cloth/body_contact.h"
#include "cloth/self_contact.h"
#include "cloth/stretch.h"
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
/// Elements and nodes that one task handles; fixed, so that sums don't depend on the threads.
constexpr int chunk = 1024;

template <typename Work>
void in_chunks(std::size_t items, const Work& work) {
  const int chunks = static_cast<int>((items + chunk - 1) / chunk);
  tbb::parallel_for(0, chunks, [&](int c) {
    work(c, static_cast<std::size_t>(c) * chunk, std::min(items, (c + 1UL) * chunk));
  });
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
        x_(x),
        y_(x),
        corner_forces_(3 * program.triangles.size()),
        bend_forces_(program.bend.size()),
        force_(program.nodes),
        partial_((program.nodes + chunk - 1) / chunk) {
    if (layer_contact()) y_.insert(y_.end(), layers().points.begin(), layers().points.end());
    const bool closing = options.closing_iterations > 0 && !program.offsets.empty();
    open_ = closing ? 1 : 0;
    use_skin(closing);
  }

  RelaxReport run(const RelaxWatcher& watcher);
  std::vector<Vec3> state() const { return {y_.begin(), y_.begin() + program_.nodes}; }

 private:
  /// The vertices that touch things: material points while seams stand open, else nodes.
  void use_skin(bool points);
  void close_seams(double t);
  Vec3 within_bounds(std::size_t node, const Vec3& wanted) const;
  bool bounded() const { return options_.bounded && !bound_.empty(); }
  void search_when_due();
  void search();
  void element_forces();
  void pair_forces();
  /// Forces on all nodes where they are, and one step along them if `step`.
  double move(bool step);
  VertexForce body_forces(std::size_t node, std::size_t vertex);
  Residual measure_residual();
  const std::vector<Vec3>& positions() const { return by_points_ ? points_ : y_; }
  bool self_contact() const { return program_.scene.self_contact; }
  bool layer_contact() const {
    return self_contact() && options_.layer_contact && program_.scene.layers != nullptr;
  }
  const TriangleMesh& layers() const { return *program_.scene.layers; }
  void place_points();

  const Program& program_;
  const RelaxOptions& options_;
  std::vector<Vec3> x_;              // the iterate before momentum
  std::vector<Vec3> y_;              // where forces are taken: the state; then the layers' points
  std::vector<Vec3> corner_forces_;  // of each triangle on each of its corners
  std::vector<Vec3> bend_forces_;    // of each hinge, to be weighted for its points
  std::vector<Vec3> force_;
  std::vector<double> partial_;

  bool by_points_ = false;
  double open_ = 0;
  double bending_ = 1;
  std::vector<Vec3> points_;       // as y_, of the material points, while seams stand open
  std::vector<int> vertex_first_;  // per node, its vertices: itself, or its material points
  std::vector<int> vertices_;
  std::vector<BodyContact> contacts_;  // per vertex

  std::unique_ptr<ProximitySearch> proximity_;
  std::vector<ContactPair> pairs_;
  std::vector<Vec3> pair_slots_;
  std::vector<double> pair_stiffness_;
  std::vector<int> pair_first_;  // per vertex, its slots in pair_slots_
  std::vector<int> pair_gather_;
  std::vector<double> bound_;
  std::vector<Vec3> searched_at_;
  int since_search_ = 0;
  int searches_ = 0;
  bool search_due_ = true;
  int momentum_age_ = 0;
};

void Relaxation::use_skin(bool points) {
  by_points_ = points;
  const std::size_t count = points ? program_.triangles.empty() ? 0 : program_.node_of_point.size()
                                   : static_cast<std::size_t>(program_.nodes);
  vertex_first_.assign(program_.nodes + 1, 0);
  const auto node_of = [&](std::size_t v) {
    return points ? program_.node_of_point[v] : static_cast<int>(v);
  };
  for (std::size_t v = 0; v < count; ++v) ++vertex_first_[node_of(v) + 1];
  std::partial_sum(vertex_first_.begin(), vertex_first_.end(), vertex_first_.begin());
  vertices_.resize(count);
  std::vector<int> next(vertex_first_.begin(), vertex_first_.end() - 1);
  for (std::size_t v = 0; v < count; ++v) vertices_[next[node_of(v)]++] = static_cast<int>(v);
  contacts_.assign(count, {});
  points_.clear();
  if (points) place_points();
  if (self_contact()) {
    std::vector<int> node(count);
    std::vector<double> shortest(count);
    for (std::size_t v = 0; v < count; ++v) {
      node[v] = node_of(v);
      shortest[v] = program_.shortest_edge[node[v]];
    }
    proximity_ = std::make_unique<ProximitySearch>(
        points ? program_.triangles : program_.node_triangles, node, shortest);
    if (layer_contact()) {
      proximity_->add_layer(layers().triangles, static_cast<int>(layers().points.size()),
                            program_.scene.layer_gap);
    }
  }
  pairs_.clear();
  bound_.clear();
  search_due_ = true;
}

void Relaxation::place_points() {
  points_ = point_positions(program_, y_, open_);
  if (layer_contact()) points_.insert(points_.end(), y_.begin() + program_.nodes, y_.end());
}

void Relaxation::close_seams(double t) {
  place_points();
  const double wanted = t < 1 ? 1 - smoothstep(t) : 0;
  double open = wanted;
  if (bounded()) {
    // The closing moves points too: no farther than their bounds allow.
    for (std::size_t p = 0; p < program_.offsets.size(); ++p) {
      const Vec3 away = points_[p] - searched_at_[p];
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
  for (std::size_t p = 0; p < program_.offsets.size(); ++p) {
    contacts_[p].moved((open_ - open) * program_.offsets[p].norm());
  }
  open_ = open;
  place_points();
}

void Relaxation::search_when_due() {
  // Unbounded, a node may leave the searched neighbourhood: look again now and then.
  if (!options_.bounded && since_search_ >= watch_interval) search_due_ = true;
  if (search_due_ && (since_search_ >= search_interval || bound_.empty())) {
    search();
    ++searches_;
  }
  ++since_search_;
}

void Relaxation::search() {
  const std::vector<Vec3>& p = positions();
  proximity_->find(p, options_.self_radius, program_.self_gap, pairs_, bound_, by_points_);
  searched_at_ = p;
  pair_slots_.assign(4 * pairs_.size(), Vec3::Zero());
  pair_stiffness_.assign(4 * pairs_.size(), 0);
  pair_first_.assign(p.size() + 1, 0);
  for (const ContactPair& pair : pairs_) {
    for (const int v : pair.vertices) ++pair_first_[v + 1];
  }
  std::partial_sum(pair_first_.begin(), pair_first_.end(), pair_first_.begin());
  pair_gather_.resize(4 * pairs_.size());
  std::vector<int> next(pair_first_.begin(), pair_first_.end() - 1);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    for (int j = 0; j < 4; ++j) {
      pair_gather_[next[pairs_[i].vertices[j]]++] = static_cast<int>(4 * i + j);
    }
  }
  since_search_ = 0;
  search_due_ = false;
}

void Relaxation::element_forces() {
  const std::vector<Vec3>& p = positions();
  const std::vector<Triangle>& triangles =
      by_points_ ? program_.triangles : program_.node_triangles;
  const StretchOptions stretch{program_.scene.strain_limit.value_or(-1), options_.compression};
  in_chunks(triangles.size(), [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto forces = stretch_forces(program_.stretch[t], stretch, p[triangles[t][0]],
                                         p[triangles[t][1]], p[triangles[t][2]]);
      std::copy(forces.begin(), forces.end(), corner_forces_.begin() + 3 * static_cast<long>(t));
    }
  });
  in_chunks(program_.bend.size(), [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t h = begin; h < end; ++h) {
      const BendHinge& hinge = program_.bend[h];
      Vec3 curvature = Vec3::Zero();
      for (int i = 0; i < 4; ++i) {
        const int point = hinge.points[i];
        curvature += hinge.weights[i] * p[by_points_ ? point : program_.node_of_point[point]];
      }
      // A seam bends as one cloth only when it is sewn.
      const double scale = hinge.stiffness * bending_ * (hinge.across_seam ? 1 - open_ : 1);
      bend_forces_[h] = -scale * curvature;
    }
  });
}

void Relaxation::pair_forces() {
  const std::vector<Vec3>& p = positions();
  in_chunks(pairs_.size(), [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const NearestPoints nearest = nearest_points(pairs_[i], p);
      const double distance = nearest.apart.norm();
      const auto [push, stiffness] = contact_push(distance, pairs_[i].gap, options_.bounded);
      const Vec3 force = distance > 0 ? Vec3(push / distance * nearest.apart) : Vec3::Zero();
      for (int j = 0; j < 4; ++j) {
        pair_slots_[4 * i + j] = nearest.weights[j] * force;
        pair_stiffness_[4 * i + j] = 2 * stiffness * std::abs(nearest.weights[j]);
      }
    }
  });
}

/// Where a node comes to on its way to `wanted` without any of its vertices leaving its bound.
Vec3 Relaxation::within_bounds(std::size_t node, const Vec3& wanted) const {
  if (!by_points_) {
    const Vec3 away = wanted - searched_at_[node];
    const double distance = away.norm();
    return distance > bound_[node] ? searched_at_[node] + away * (bound_[node] / distance) : wanted;
  }
  const Vec3 way = wanted - y_[node];
  double share = 1;
  for (int i = vertex_first_[node]; i < vertex_first_[node + 1]; ++i) {
    const int v = vertices_[i];
    share = std::min(share, share_within(points_[v] - searched_at_[v], way, bound_[v]));
  }
  return share < 1 ? Vec3(y_[node] + share * way) : wanted;
}

VertexForce Relaxation::body_forces(std::size_t node, std::size_t vertex) {
  if (program_.scene.body == nullptr) return {};
  const Vec3& p = positions()[vertex];
  VertexForce result =
      contacts_[vertex].force(program_.scene, p, options_.body_offset,
                              options_.friction ? program_.friction_skin[node] : 0);
  if (options_.pull > 0) {
    const int sharing = vertex_first_[node + 1] - vertex_first_[node];
    const double weight = program_.mass[node] / sharing * program_.scene.gravity.norm();
    result.force += pull_to_body(program_.scene, p, options_.pull * weight);
  }
  return result;
}

/// One step of all nodes; returns the power of the forces along the last step.
double Relaxation::move(bool step_on) {
  const double weight = std::min(options_.momentum, momentum_age_ / (momentum_age_ + 3.0));
  const Vec3 gravity = options_.gravity * program_.scene.gravity;
  const bool keep_bounds = bounded();
  const std::vector<int>& corner_first = program_.stretch_gather.first;
  std::vector<char> clipped(partial_.size(), 0);
  in_chunks(program_.nodes, [&](int c, std::size_t begin, std::size_t end) {
    double power = 0;
    for (std::size_t n = begin; n < end; ++n) {
      Vec3 force = program_.mass[n] * gravity;
      double stiffness = program_.stretch_diagonal[n];
      if (!program_.bend.empty()) stiffness += bending_ * program_.bend_diagonal[n];
      for (int i = corner_first[n]; i < corner_first[n + 1]; ++i) {
        force += corner_forces_[program_.stretch_gather.corners[i]];
      }
      if (!program_.bend.empty()) {
        const BendGather& bend = program_.bend_gather;
        for (int e = bend.first[n]; e < bend.first[n + 1]; ++e) {
          force += bend.entries[e].weight * bend_forces_[bend.entries[e].hinge];
        }
      }
      for (int i = vertex_first_[n]; i < vertex_first_[n + 1]; ++i) {
        const int v = vertices_[i];
        if (!pairs_.empty()) {
          for (int s = pair_first_[v]; s < pair_first_[v + 1]; ++s) {
            force += pair_slots_[pair_gather_[s]];
            stiffness += pair_stiffness_[pair_gather_[s]];
          }
        }
        const VertexForce from_body = body_forces(n, v);
        force += from_body.force;
        stiffness += from_body.stiffness;
      }
      force_[n] = force;
      if (!step_on) continue;
      // A node that no triangle holds has nothing to be moved by.
      Vec3 step = stiffness > 0 ? Vec3(step_factor * force / stiffness) : Vec3::Zero();
      const double length = step.norm();
      if (length > options_.max_move) step *= options_.max_move / length;
      Vec3 next_x = y_[n] + step;
      Vec3 glide = next_x - x_[n];
      power += force.dot(glide);
      const double speed = glide.norm();
      if (speed > options_.max_move) glide *= options_.max_move / speed;
      Vec3 next_y = next_x + weight * glide;
      if (keep_bounds) {
        const Vec3 allowed = within_bounds(n, next_y);
        if (allowed != next_y) {
          next_x = next_y = allowed;
          clipped[c] = 1;
        }
      }
      const double moved = (next_y - y_[n]).norm();
      for (int i = vertex_first_[n]; i < vertex_first_[n + 1]; ++i) {
        contacts_[vertices_[i]].moved(moved);
      }
      x_[n] = next_x;
      y_[n] = next_y;
    }
    partial_[c] = power;
  });
  if (std::find(clipped.begin(), clipped.end(), 1) != clipped.end()) search_due_ = true;
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

/// Of the state as it is now: the forces of the last step are those before it.
Residual Relaxation::measure_residual() {
  if (by_points_) place_points();
  if (self_contact()) pair_forces();
  element_forces();
  move(false);
  std::vector<double> norms(force_.size());
  double sum = 0;
  for (std::size_t n = 0; n < norms.size(); ++n) {
    norms[n] = force_[n].norm() / program_.mean_weight;
    sum += norms[n] * norms[n];
  }
  Residual r;
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
    if (self_contact()) {
      search_when_due();
      pair_forces();
    }
    element_forces();
    const double power = move(true);
    momentum_age_ = power < 0 && !by_points_ ? 0 : momentum_age_ + 1;
    report.iterations = i + 1;
    if ((i + 1) % watch_interval != 0 && i + 1 != options_.max_iterations) continue;
    if (watcher) watcher({i + 1, open_, state()});
    report.residual = measure_residual();
    if (!by_points_ && report.residual.median < options_.stop_median &&
        report.residual.rms < options_.stop_rms) {
      report.converged = true;
      break;
    }
  }
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
