#include "cloth/relax.h"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "cloth/self_contact.h"
#include "cloth/stretch.h"
#include "geometry/distance_grid.h"

namespace toile {

namespace {

/// N/m. A node of 1 cm² that 100 Pa press to the skin sinks in by 0.01 mm.
constexpr double body_stiffness = 1000;
/// N/m, of the spring that holds a sticking node to its anchor on the skin.
constexpr double anchor_stiffness = 200;
/// N/m, per pair of cloth near cloth.
constexpr double self_stiffness = 200;
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

double smoothstep(double t) { return t * t * (3 - 2 * t); }

/// What the body does to one vertex of the cloth.
struct BodyContact {
  double clearance = 0;  ///< metres the vertex may move before the body has to be asked again
  Vec3 anchor = Vec3::Zero();
  bool anchored = false;
};

class Relaxation {
 public:
  Relaxation(const Program& program, const RelaxOptions& options, std::vector<Vec3>& x)
      : program_(program),
        options_(options),
        y_(x),
        x_(x),
        slots_(3 * program.triangles.size() + 4 * program.bend.size()),
        force_(program.nodes),
        partial_((program.nodes + chunk - 1) / chunk) {
    const bool closing = options.closing_iterations > 0 && !program.offsets.empty();
    open_ = closing ? 1 : 0;
    use_skin(closing);
  }

  RelaxReport run(const RelaxWatcher& watcher);

 private:
  /// The vertices that touch things: material points while seams stand open, else nodes.
  void use_skin(bool points);
  void update_schedule(int iteration);
  void search();
  void element_forces();
  void pair_forces();
  double move();
  Vec3 body_force(std::size_t vertex, const Vec3& p, double moved, double& stiffness);
  Residual residual() const;
  const std::vector<Vec3>& positions() const { return by_points_ ? points_ : y_; }
  bool self_contact() const { return options_.self_contact && program_.scene.self_contact; }

  const Program& program_;
  const RelaxOptions& options_;
  std::vector<Vec3>& y_;     // where forces are taken: the state
  std::vector<Vec3> x_;      // the iterate before momentum
  std::vector<Vec3> slots_;  // force of each element on each of its corners
  std::vector<Vec3> force_;
  std::vector<double> partial_;

  bool by_points_ = false;
  double open_ = 0;
  double bending_ = 1;
  std::vector<Vec3> points_;       // places of the material points, while seams stand open
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
  if (points) points_ = point_positions(program_, y_, open_);
  if (self_contact()) {
    std::vector<double> shortest(count);
    for (std::size_t v = 0; v < count; ++v) shortest[v] = program_.shortest_edge[node_of(v)];
    proximity_ = std::make_unique<ProximitySearch>(
        points ? program_.triangles : program_.node_triangles, shortest);
  }
  pairs_.clear();
  bound_.clear();
  search_due_ = true;
}

void Relaxation::update_schedule(int iteration) {
  if (!by_points_) {
    bending_ = 1;
    return;
  }
  const double t = static_cast<double>(iteration) / options_.closing_iterations;
  if (t >= 1) {
    open_ = 0;
    bending_ = 1;
    use_skin(false);
    return;
  }
  open_ = 1 - smoothstep(t);
  bending_ = std::pow(options_.bending_boost, 1 - t);
  const std::vector<Vec3> moved = point_positions(program_, y_, open_);
  // What the closing itself moves a point counts against its clearance from the body.
  for (std::size_t p = 0; p < moved.size(); ++p) {
    contacts_[p].clearance -= (moved[p] - points_[p]).norm();
  }
  points_ = moved;
}

void Relaxation::search() {
  const std::vector<Vec3>& p = positions();
  proximity_->find(p, options_.self_radius, program_.scene.self_gap, pairs_, bound_);
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
  const Fabric& fabric = program_.scene.fabric;
  const double limit = program_.scene.strain_limit.value_or(-1);
  in_chunks(triangles.size(), [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto forces = stretch_forces(program_.stretch[t], fabric, limit, p[triangles[t][0]],
                                         p[triangles[t][1]], p[triangles[t][2]]);
      std::copy(forces.begin(), forces.end(), slots_.begin() + 3 * static_cast<long>(t));
    }
  });
  const std::size_t base = 3 * triangles.size();
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
      for (int i = 0; i < 4; ++i) slots_[base + 4 * h + i] = -scale * hinge.weights[i] * curvature;
    }
  });
}

void Relaxation::pair_forces() {
  const std::vector<Vec3>& p = positions();
  in_chunks(pairs_.size(), [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const NearestPoints nearest = nearest_points(pairs_[i], p);
      const double distance = nearest.apart.norm();
      const bool touching = distance < pairs_[i].gap && distance > 1e-12;
      const double push = touching ? self_stiffness * (pairs_[i].gap - distance) / distance : 0;
      for (int j = 0; j < 4; ++j) {
        pair_slots_[4 * i + j] = push * nearest.weights[j] * nearest.apart;
        pair_stiffness_[4 * i + j] =
            touching ? 2 * self_stiffness * std::abs(nearest.weights[j]) : 0;
      }
    }
  });
}

Vec3 Relaxation::body_force(std::size_t vertex, const Vec3& p, double moved, double& stiffness) {
  BodyContact& contact = contacts_[vertex];
  contact.clearance -= moved;
  if (contact.clearance > 0) return Vec3::Zero();
  const DistanceGrid::Sample sample = program_.scene.body->at(p);
  const double depth = options_.body_offset - sample.distance;
  if (depth <= 0) {
    contact.clearance = -depth;
    contact.anchored = false;
    return Vec3::Zero();
  }
  contact.clearance = 0;
  const double length = sample.gradient.norm();
  if (length < 1e-6) return Vec3::Zero();
  const Vec3 normal = sample.gradient / length;
  stiffness += body_stiffness;
  Vec3 force = body_stiffness * depth * normal;
  if (!options_.friction) return force;
  if (!contact.anchored) {
    contact.anchored = true;
    contact.anchor = p;
  }
  const Vec3 offset = p - contact.anchor;
  Vec3 slip = offset - normal.dot(offset) * normal;
  const double most = program_.scene.fabric.friction * body_stiffness * depth / anchor_stiffness;
  if (slip.norm() > most) {
    slip *= most / slip.norm();
    contact.anchor = p - slip;
  }
  stiffness += anchor_stiffness;
  return force - anchor_stiffness * slip;
}

/// One step of all nodes; returns the power of the forces along the last step.
double Relaxation::move() {
  const double weight = std::min(options_.momentum, momentum_age_ / (momentum_age_ + 3.0));
  const Vec3 gravity = options_.gravity * program_.scene.gravity;
  const std::vector<Vec3>& p = positions();
  const bool bounded = options_.bounded && !by_points_ && !bound_.empty();
  std::vector<char> clipped(partial_.size(), 0);
  in_chunks(program_.nodes, [&](int c, std::size_t begin, std::size_t end) {
    double power = 0;
    for (std::size_t n = begin; n < end; ++n) {
      Vec3 force = program_.mass[n] * gravity;
      double stiffness = program_.stretch_diagonal[n];
      if (!program_.bend.empty()) stiffness += bending_ * program_.bend_diagonal[n];
      for (int s = program_.gather.first[n]; s < program_.gather.first[n + 1]; ++s) {
        force += slots_[program_.gather.slots[s]];
      }
      for (int i = vertex_first_[n]; i < vertex_first_[n + 1]; ++i) {
        const int v = vertices_[i];
        if (!pairs_.empty()) {
          for (int s = pair_first_[v]; s < pair_first_[v + 1]; ++s) {
            force += pair_slots_[pair_gather_[s]];
            stiffness += pair_stiffness_[pair_gather_[s]];
          }
        }
        if (program_.scene.body != nullptr) force += body_force(v, p[v], 0, stiffness);
      }
      force_[n] = force;
      Vec3 step = force / stiffness;
      const double length = step.norm();
      if (length > options_.max_move) step *= options_.max_move / length;
      Vec3 next_x = y_[n] + step;
      Vec3 glide = next_x - x_[n];
      power += force.dot(glide);
      const double speed = glide.norm();
      if (speed > options_.max_move) glide *= options_.max_move / speed;
      Vec3 next_y = next_x + weight * glide;
      if (bounded) {
        const Vec3 away = next_y - searched_at_[n];
        const double distance = away.norm();
        if (distance > bound_[n]) {
          next_y = searched_at_[n] + away * (bound_[n] / distance);
          next_x = next_y;
          clipped[c] = 1;
        }
      }
      const double moved = (next_y - y_[n]).norm();
      for (int i = vertex_first_[n]; i < vertex_first_[n + 1]; ++i) {
        contacts_[vertices_[i]].clearance -= moved;
      }
      x_[n] = next_x;
      y_[n] = next_y;
    }
    partial_[c] = power;
  });
  if (std::find(clipped.begin(), clipped.end(), 1) != clipped.end()) search_due_ = true;
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

Residual Relaxation::residual() const {
  std::vector<double> norms(force_.size());
  double sum = 0;
  for (std::size_t n = 0; n < norms.size(); ++n) {
    norms[n] = force_[n].norm() / program_.mean_weight;
    sum += norms[n] * norms[n];
  }
  Residual r;
  r.rms = std::sqrt(sum / static_cast<double>(norms.size()));
  r.max = *std::max_element(norms.begin(), norms.end());
  std::nth_element(norms.begin(), norms.begin() + norms.size() / 2, norms.end());
  r.median = norms[norms.size() / 2];
  return r;
}

RelaxReport Relaxation::run(const RelaxWatcher& watcher) {
  const auto start = std::chrono::steady_clock::now();
  RelaxReport report;
  for (int i = 0; i < options_.max_iterations; ++i) {
    update_schedule(i);
    if (self_contact()) {
      // Unbounded, a node may leave the searched neighbourhood: look again now and then.
      if (!options_.bounded && since_search_ >= watch_interval) search_due_ = true;
      if (search_due_ && (since_search_ >= search_interval || bound_.empty())) {
        search();
        ++report.searches;
      }
      ++since_search_;
      pair_forces();
    }
    element_forces();
    const double power = move();
    momentum_age_ = power < 0 && !by_points_ ? 0 : momentum_age_ + 1;
    report.iterations = i + 1;
    if ((i + 1) % watch_interval != 0 && i + 1 != options_.max_iterations) continue;
    if (watcher) watcher({i + 1, open_, y_});
    report.residual = residual();
    if (!by_points_ && report.residual.median < options_.stop_median &&
        report.residual.rms < options_.stop_rms) {
      report.converged = true;
      break;
    }
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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
  return Relaxation(program, options, x).run(watcher);
}

}  // namespace toile
