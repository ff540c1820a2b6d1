#include "cloth/relaxation/cloth_forces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "cloth/contact/body_attraction.h"
#include "cloth/contact/clip_to_ball.h"
#include "cloth/relaxation/block_stiffness.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

/// Weights of a node that may pull at it where it comes down on the body, and metres that it comes
/// down by in a step at most: soft cloth (1 N/m) is thrown back and comes down again for ever,
/// unless it reckons with the body a step before.
constexpr double weights_coming_down = 8;
constexpr double max_coming_down = 0.004;

/// Active pairs that one task handles, of which each costs as much as several triangles.
constexpr std::size_t pair_chunk = 16;

/// Forces between two looks at the pull to the body, which is wide and smooth.
constexpr int pull_interval = 16;
/// Metres: the tightest curves of a body that a garment spans with whole triangles.
constexpr double body_curve = 0.02;
/// Share of the offset from the body that the sagitta of an edge over such a curve may use up
/// before its middle has to touch the body too.
constexpr double max_sagitta = 0.7;

}  // namespace

ClothForces::ClothForces(const GarmentModel& model, const ForceOptions& options,
                         const std::vector<Vec3>& x, bool open_seams)
    : model_(model),
      options_(options),
      stretch_{model.scene.strain_limit.value_or(-1), options.compression,
               model.scene.shear_limit.value_or(-1)},
      gravity_(options.gravity * as_vec4(model.scene.gravity)),
      nodes_(as_vec4(x)),
      open_(open_seams ? 1 : 0) {
  if (layer_contact()) {
    for (const Vec3& p : layers().points) nodes_.push_back(as_vec4(p));
  }
  use_skin(open_seams);
  if (has_limits()) {
    if (options.multipliers != nullptr) kernel_->start_multipliers(*options.multipliers);
    update_multipliers();
  }
  if (options.warm_start == nullptr || open_seams) return;
  pairs_.friction().hold(options.warm_start->cloth);
  if (edge_contacts_) edge_contacts_->hold(options.warm_start->edges);
  const auto& skin = options.warm_start->skin;
  for (std::size_t n = 0; n < std::min(skin.size(), contacts_.size()); ++n) {
    if (skin[n]) contacts_[n].hold_at(*skin[n]);
  }
}

WarmStart ClothForces::warm_start() const {
  WarmStart warm_start;
  if (has_limits()) warm_start.multipliers = kernel_->multipliers();
  if (by_points_) return warm_start;
  if (edge_contacts_) warm_start.edges = edge_contacts_->anchors();
  warm_start.cloth = pairs_.friction().anchors();
  warm_start.skin.reserve(contacts_.size());
  for (const BodyContact& contact : contacts_) warm_start.skin.push_back(contact.anchor());
  return warm_start;
}

std::vector<Vec3> ClothForces::state() const {
  std::vector<Vec3> state(model_.nodes);
  for (std::size_t n = 0; n < state.size(); ++n) state[n] = as_vec3(nodes_[n]);
  return state;
}

std::vector<Vec3> ClothForces::all_positions() const {
  std::vector<Vec3> all;
  all.reserve(vertices());
  for (const Vec4& p : positions()) all.push_back(as_vec3(p));
  return all;
}

void ClothForces::use_skin(bool points) {
  by_points_ = points;
  // Triangles are the same, of nodes as of points.
  const std::vector<LimitMultiplier> yarns =
      kernel_ && has_limits() ? kernel_->multipliers() : std::vector<LimitMultiplier>{};
  kernel_ = std::make_unique<ElasticKernel>(model_, points);
  elastics_ = std::make_unique<ElasticForces>(model_, points);
  attachments_ = std::make_unique<AttachmentForces>(model_, points);
  kernel_->start_multipliers(yarns);
  const std::size_t count = kernel_->vertices();
  vertex_force_.assign(count, Vec4{});
  vertices_of_.assign(model_.nodes, [&](const auto& add) {
    for (std::size_t v = 0; v < count; ++v) {
      add(points ? model_.node_of_point[v] : v, static_cast<int>(v));
    }
  });
  points_.clear();
  if (points) place_points();
  const std::vector<Triangle>& triangles = points ? model_.triangles : model_.node_triangles;
  body_bounds_.reset();
  if (options_.bounded && exact_body() && !points) {
    body_bounds_ = std::make_unique<BodyBounds>(*model_.scene.collider, triangles, count);
  }
  approach_bound_ = of_vertices(approach_bounds());
  edge_contacts_.reset();
  if (exact_body()) {
    const double shortest = std::sqrt(8 * body_curve * max_sagitta * model_.body_offset);
    edge_contacts_ = std::make_unique<EdgeContacts>(
        triangles, positions(), shortest, of_vertices(model_.friction_skin), approach_bound_);
  }
  contacts_.assign(count, {});
  safe_balls_.assign(count, Vec4{});
  pull_.clear();
  computed_ = 0;
  pairs_.clear();
  bound_.clear();
  search_due_ = true;
  if (!self_contact()) {
    set_safe_balls();
    return;
  }
  if (options_.friction) {
    pairs_.friction().set_coefficients(of_vertices(model_.friction_cloth));
  }
  std::vector<int> node = model_.node_of_point;
  if (!points) {
    node.resize(count);
    std::iota(node.begin(), node.end(), 0);
  }
  proximity_ =
      std::make_unique<ProximitySearch>(triangles, node, of_vertices(model_.shortest_edge));
  if (layer_contact()) {
    proximity_->add_layer(layers().triangles, static_cast<int>(layers().points.size()),
                          model_.scene.layer_gap);
  }
}

/// Metres that each node may come down onto the body in a step.
std::vector<double> ClothForces::approach_bounds() const {
  std::vector<double> steps;
  for (int n = 0; n < model_.nodes; ++n) {
    const double weight = model_.mass[n] * model_.scene.gravity.norm();
    const double bend = model_.bend.empty() ? 0 : model_.bend_diagonal[n];
    const double stiffness = isotropic_share * model_.stretch_diagonal[n] + bend;
    steps.push_back(
        std::min(max_coming_down, weights_coming_down * weight / std::max(stiffness, 1e-12)));
  }
  return steps;
}

std::vector<double> ClothForces::of_vertices(const std::vector<double>& of_nodes) const {
  if (!by_points_) return of_nodes;
  std::vector<double> values;
  for (const int node : model_.node_of_point) values.push_back(of_nodes[node]);
  return values;
}

void ClothForces::place_points() {
  if (points_.empty()) {
    points_.resize(model_.node_of_point.size());
    points_.insert(points_.end(), nodes_.begin() + model_.nodes, nodes_.end());
  }
  parallel_for_chunks(model_.node_of_point.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      points_[p] = nodes_[model_.node_of_point[p]] + open_ * as_vec4(model_.offsets[p]);
    }
  });
}

void ClothForces::close_seams(double wanted) {
  double open = wanted;
  if (bounded()) {
    // The closing moves points too: no farther than their bounds allow.
    for (std::size_t p = 0; p < model_.offsets.size(); ++p) {
      const Vec3 away = as_vec3(points_[p]) - searched_at_[p];
      const Vec3 way = (wanted - open_) * model_.offsets[p];
      const double share = clip_to_ball(away, way, bound_[p]);
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
    const Vec4 moved = points_[p] - safe_balls_[p];
    if (squared_length(moved) > safe_balls_[p][3]) set_safe_ball(p, as_vec3(points_[p]));
  }
}

bool ClothForces::update_multipliers() {
  if (!has_limits()) return true;
  const std::size_t tasks = chunks_of(kernel_->groups(), vertex_chunk);
  std::vector<ElasticKernel::Held> counts(tasks);
  parallel_for(tasks, [&](std::size_t c) {
    counts[c] = kernel_->hold(c * vertex_chunk, std::min(kernel_->groups(), (c + 1) * vertex_chunk),
                              stretch_, positions());
  });
  stiffening_.assign(model_.nodes, 0);
  for (std::size_t n = 0; n < stiffening_.size(); ++n) {
    for (const int v : vertices_of_[n]) stiffening_[n] += kernel_->stiffening(v);
  }
  return std::all_of(counts.begin(), counts.end(),
                     [](const ElasticKernel::Held& held) { return held.beyond == 0; });
}

void ClothForces::search_when_due(int interval, int max_interval) {
  update_body_bounds();
  if (!self_contact()) return;
  // Unbounded, a node may leave the searched neighbourhood: look again now and then.
  if (!options_.bounded && since_search_ >= max_interval) search_due_ = true;
  if (search_due_ && (since_search_ >= interval || bound_.empty())) {
    search();
    ++searches_;
  } else if (activation_due_) {
    activate_pairs();
  }
  ++since_search_;
}

void ClothForces::look_anew() {
  for (BodyContact& contact : contacts_) contact.forget();
  if (edge_contacts_) edge_contacts_->look_anew();
  if (self_contact()) activate_pairs();
  set_safe_balls();
}

void ClothForces::search() {
  const std::vector<Vec3> p = all_positions();
  const double gap = model_.self_gap;
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

void ClothForces::activate_pairs() {
  activated_at_ = all_positions();
  pairs_.activate(activated_at_);
  activation_due_ = false;
  set_safe_balls();
}

void ClothForces::set_safe_balls() {
  parallel_for_chunks(vertices(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) set_safe_ball(v, as_vec3(positions()[v]));
  });
}

void ClothForces::update_body_bounds() {
  if (!body_bounds_) return;
  constexpr int meeting_interval = 32;
  if (++looks_ % meeting_interval == 0) body_bounds_->look_at_meeting();
  if (!body_bounds_->due()) return;
  for (const int v : body_bounds_->look(positions())) {
    if (body_bounds_->extra_offset(v) > 0) contacts_[v].forget();
    set_safe_ball(v, as_vec3(nodes_[v]));
  }
}

/// How far a vertex that stands at `p` may go until it has to be looked after again: because the
/// body is near, its bound used up, or a pair may begin to push.
void ClothForces::set_safe_ball(std::size_t v, const Vec3& p) {
  double reach = 1e3;
  if (touches_body(model_.scene)) {
    if (contacts_[v].remaining(p) <= 0) {
      const double offset = model_.body_offset + extra_offset(static_cast<int>(v));
      contacts_[v].look(model_.scene, p, offset, options_.linearization_radius, approach_bound_[v]);
    }
    reach = contacts_[v].remaining(p);
  }
  if (bounded()) {
    const double used = (p - searched_at_[v]).norm();
    const double due = options_.search_share * bound_[v];
    if (used > due) search_due_ = true;
    reach = std::min(reach, std::max((used > due ? bound_[v] : due) - used, 0.0));
  }
  if (body_bounds_) reach = std::min(reach, body_bounds_->free(static_cast<int>(v), p));
  if (!bound_.empty()) {
    const double left = 0.5 * PairForces::margin - (p - activated_at_[v]).norm();
    if (left <= 0) activation_due_ = true;
    reach = std::min(reach, std::max(left, 0.0));
  }
  safe_balls_[v] = as_vec4(p);
  safe_balls_[v][3] = reach * reach;
}

void ClothForces::find_pull() {
  pull_.resize(vertices());
  parallel_for_chunks(model_.nodes, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const double weight = model_.mass[n] / static_cast<double>(vertices_of_[n].size()) *
                            model_.scene.gravity.norm() * options_.pull;
      for (const int v : vertices_of_[n]) {
        pull_[v] = as_vec4(pull_to_body(model_.scene, as_vec3(positions()[v]), weight));
      }
    }
  });
}

void ClothForces::compute(double bending) {
  bending_ = bending;
  const bool pulls_to_body = options_.pull > 0 && touches_body(model_.scene);
  if (pulls_to_body && computed_++ % pull_interval == 0) find_pull();
  const Vec4s& p = positions();
  const std::size_t edges = edge_contacts_ ? edge_contacts_->edges() : 0;
  // Each task has its share of all three, so that tasks are alike.
  const std::size_t tasks =
      std::max({chunks_of(kernel_->groups(), vertex_chunk), chunks_of(pairs_.active(), pair_chunk),
                chunks_of(edges, vertex_chunk)});
  parallel_for(tasks, [&](std::size_t task) {
    const auto share = [&](std::size_t items, const auto& work) {
      work(items * task / tasks, items * (task + 1) / tasks);
    };
    share(kernel_->groups(),
          [&](std::size_t begin, std::size_t end) { kernel_->pull(begin, end, stretch_, p); });
    share(pairs_.active(), [&](std::size_t begin, std::size_t end) {
      pairs_.push(begin, end, options_.bounded, options_.activation_distance, p);
    });
    if (edges == 0) return;
    share(edges, [&](std::size_t begin, std::size_t end) {
      edge_contacts_->push(begin, end, model_, options_, p);
    });
  });
  // Points of a node may be anywhere among the others.
  if (!by_points_) return;
  parallel_for_chunks(vertices(), [&](std::size_t begin, std::size_t end) { add_up(begin, end); });
}

void ClothForces::add_up(std::size_t begin, std::size_t end) {
  const Vec4s& p = positions();
  // A seam bends as one cloth only when it is sewn.
  kernel_->gather(begin, end, bending_, 1 - open_, p, vertex_force_);
  if (!elastics_->empty()) elastics_->add(begin, end, p, vertex_force_);
  if (!attachments_->empty()) attachments_->add(begin, end, p, vertex_force_);
  if (edge_contacts_ && !edge_contacts_->empty()) edge_contacts_->add(begin, end, vertex_force_);
}

/// Where a node comes to on its way to `wanted` without any of its vertices leaving its bound.
Vec3 ClothForces::within_bounds(std::size_t node, const Vec3& wanted) const {
  if (!by_points_) {
    const Vec3 away = wanted - searched_at_[node];
    const double distance = away.norm();
    return distance > bound_[node] ? searched_at_[node] + away * (bound_[node] / distance) : wanted;
  }
  const Vec3 from = as_vec3(nodes_[node]);
  const Vec3 way = wanted - from;
  double share = 1;
  for (const int v : vertices_of_[node]) {
    share = std::min(share, clip_to_ball(as_vec3(points_[v]) - searched_at_[v], way, bound_[v]));
  }
  return share < 1 ? Vec3(from + share * way) : wanted;
}

/// A node that leaves the guard of one of its vertices: stopped at its bounds, looked after anew.
bool ClothForces::leave_safe_ball(std::size_t node, const Vec4& wanted) {
  Vec3 next = as_vec3(wanted);
  bool allowed = true;
  if (bounded()) {
    const Vec3 within = within_bounds(node, next);
    allowed = within == next;
    if (!allowed) search_due_ = true;
    next = within;
  }
  if (body_bounds_) {
    const Vec3 from = as_vec3(nodes_[node]);
    const double share = body_bounds_->share(static_cast<int>(node), from, next);
    if (share < 1) {
      next = from + share * (next - from);
      allowed = false;
    }
  }
  nodes_[node] = as_vec4(next);
  if (!by_points_) {
    set_safe_ball(node, next);
    return allowed;
  }
  for (const int v : vertices_of_[node]) {
    set_safe_ball(v, next + open_ * model_.offsets[v]);
  }
  return allowed;
}

}  // namespace toile
