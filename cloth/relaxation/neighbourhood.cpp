#include "cloth/relaxation/neighbourhood.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cloth/contact/clip_to_ball.h"
#include "cloth/contact/constants.h"
#include "cloth/relaxation/constants.h"
#include "cloth/scene/collider.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

/// Metres: the radius of a safe ball that nothing limits.
constexpr double boundless = 1e3;

/// Metres by which each node may approach the body in a step.
std::vector<double> approach_bounds(const GarmentModel& model) {
  std::vector<double> bounds;
  for (int n = 0; n < model.nodes; ++n) {
    const double weight = model.mass[n] * model.scene.gravity.norm();
    const double bend = model.bend.empty() ? 0 : model.bend_diagonal[n];
    const double stiffness = max_isotropic_share * model.stretch_diagonal[n] + bend;
    bounds.push_back(
        std::min(max_approach_bound, approach_weights * weight / std::max(stiffness, 1e-12)));
  }
  return bounds;
}

}  // namespace

Neighbourhood::Neighbourhood(const GarmentModel& model, const ForceOptions& options,
                             const Vertices& vertices, const Vec4s& x, bool self_contact,
                             bool body_bounds)
    : model_(model),
      options_(options),
      vertices_(vertices),
      x_(x),
      contacts_(vertices.count),
      near_body_(vertices.count, 0),
      approach_bound_(vertices.spread(approach_bounds(model))),
      safe_balls_(vertices.count, Vec4{}) {
  if (body_bounds && ((options.bounded && !vertices.are_points) || options.bounded_by_body) &&
      touches_body_exactly(model.scene)) {
    body_bounds_ =
        std::make_unique<BodyBounds>(*model.scene.collider, vertices.triangles, vertices.count);
  }
  if (!model.scene.self_contact || !self_contact) {
    set_safe_balls();
    return;
  }
  if (options.friction) {
    pairs_.friction().set_coefficients(vertices.spread(model.friction_cloth));
  }
  std::vector<int> node = model.node_of_point;
  if (!vertices.are_points) {
    node.resize(vertices.count);
    std::iota(node.begin(), node.end(), 0);
  }
  proximity_ = std::make_unique<ProximitySearch>(vertices.triangles, node,
                                                 vertices.spread(model.shortest_edge));
  if (touches_layers(model, options)) {
    const TriangleMesh& layers = model.scene.collider->cloth();
    proximity_->add_layer(layers.triangles, static_cast<int>(layers.points.size()),
                          model.scene.layer_gap);
  }
}

void Neighbourhood::update(const SearchInterval& interval) {
  update_body_bounds();
  if (!proximity_) return;
  if (!options_.bounded && since_search_ >= interval.max) search_due_ = true;
  if (search_due_ && (since_search_ >= interval.min || bound_.empty())) {
    search();
    ++searches_;
  } else if (activation_due_) {
    activate_pairs();
  }
  ++since_search_;
}

void Neighbourhood::refresh() {
  for (BodyContact& contact : contacts_) contact.forget();
  if (proximity_) activate_pairs();
  set_safe_balls();
}

double Neighbourhood::allowed_share(std::size_t v, const Vec3& displacement) const {
  return clip_to_ball(as_vec3(x_[v]) - searched_at_[v], displacement, bound_[v]);
}

Vec3 Neighbourhood::clipped(std::size_t v, const Vec3& wanted) const {
  const Vec3 away = wanted - searched_at_[v];
  const double distance = away.norm();
  return distance > bound_[v] ? searched_at_[v] + away * (bound_[v] / distance) : wanted;
}

double Neighbourhood::allowed_share_beside_body(std::size_t v, const Vec3& from, const Vec3& to) {
  return body_bounds_ ? body_bounds_->allowed_share(static_cast<int>(v), from, to) : 1;
}

Vec3 Neighbourhood::reached_beside_body(std::size_t v, const Vec3& from, const Vec3& to) {
  return body_bounds_ ? body_bounds_->reached(static_cast<int>(v), from, to) : to;
}

std::vector<Vec3> Neighbourhood::positions() const {
  std::vector<Vec3> all;
  all.reserve(x_.size());
  for (const Vec4& p : x_) all.push_back(as_vec3(p));
  return all;
}

void Neighbourhood::search() {
  const std::vector<Vec3> p = positions();
  const double gap = model_.self_gap;
  // update() needs vertices that have kept their bounds.
  if (bounded()) {
    proximity_->update(p, options_.self_radius, gap, pairs_.pairs(), bound_, searched_at_,
                       vertices_.are_points);
  } else {
    proximity_->find(p, options_.self_radius, gap, pairs_.pairs(), bound_, vertices_.are_points);
    searched_at_ = p;
  }
  since_search_ = 0;
  search_due_ = false;
  activate_pairs();
}

void Neighbourhood::activate_pairs() {
  activated_at_ = positions();
  pairs_.activate(activated_at_, ignored_);
  activation_due_ = false;
  set_safe_balls();
}

void Neighbourhood::set_safe_balls() {
  parallel_for_chunks(vertices_.count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) set_safe_ball(v, as_vec3(x_[v]));
  });
}

void Neighbourhood::update_body_bounds() {
  if (!body_bounds_) return;
  if (++body_updates_ % intersecting_update_interval == 0) body_bounds_->recheck_intersecting();
  if (!body_bounds_->is_due()) return;
  for (const int v : body_bounds_->update(x_)) {
    if (body_bounds_->extra_offset(v) > 0) contacts_[v].forget();
    set_safe_ball(v, as_vec3(x_[v]));
  }
}

void Neighbourhood::set_safe_ball(std::size_t v, const Vec3& p) {
  double radius = boundless;
  if (touches_body(model_.scene)) {
    if (contacts_[v].remaining(p) <= 0) {
      const double offset = model_.body_offset + extra_offset(static_cast<int>(v));
      contacts_[v].linearize(model_.scene, p, offset, options_.linearization_radius,
                             approach_bound_[v], options_.firm_push);
      near_body_[v] = contacts_[v].near();
    }
    radius = contacts_[v].remaining(p);
  }
  if (bounded()) {
    const double used = (p - searched_at_[v]).norm();
    const double due = options_.search_share * bound_[v];
    if (used > due) search_due_ = true;
    radius = std::min(radius, std::max((used > due ? bound_[v] : due) - used, 0.0));
  }
  if (body_bounds_) radius = std::min(radius, body_bounds_->free_radius(static_cast<int>(v), p));
  if (!bound_.empty()) {
    const double left = 0.5 * pair_activation_margin - (p - activated_at_[v]).norm();
    if (left <= 0) activation_due_ = true;
    radius = std::min(radius, std::max(left, 0.0));
  }
  safe_balls_[v] = as_vec4(p);
  safe_balls_[v][3] = radius * radius;
}

}  // namespace toile
