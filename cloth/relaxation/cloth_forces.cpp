#include "cloth/relaxation/cloth_forces.h"

#include <algorithm>
#include <cmath>

#include "cloth/contact/body_attraction.h"
#include "cloth/contact/edge_face_intersections.h"
#include "cloth/relaxation/constants.h"
#include "cloth/scene/collider.h"

namespace toile {

namespace {

/// Active pairs that one task handles. Each costs as much as several triangles.
constexpr std::size_t pair_chunk = 16;

}  // namespace

ClothForces::ClothForces(const GarmentModel& model, const ForceOptions& options,
                         const SearchInterval& interval, const std::vector<Vec3>& x,
                         bool open_seams)
    : model_(model),
      options_(options),
      interval_(interval),
      stretch_{model.scene.strain_limit.value_or(-1), options.compression,
               model.scene.shear_limit.value_or(-1)},
      gravity_(options.gravity * as_vec4(model.scene.gravity)),
      nodes_(as_vec4(x)),
      node_force_(model.nodes, Vec4{}),
      open_(open_seams ? model.nodes : 0, 1.0),
      max_open_(open_seams ? 1 : 0) {
  if (touches_layers(model, options)) {
    for (const Vec3& p : model.scene.collider->cloth().points) nodes_.push_back(as_vec4(p));
  }
  use_vertices(open_seams);
  if (has_limits()) {
    if (options.warm_start != nullptr) kernel_->start_multipliers(options.warm_start->multipliers);
    update_multipliers();
  }
  if (options.warm_start == nullptr || open_seams) return;
  neighbourhood_->pairs().friction().set_anchors(options.warm_start->pair_anchors);
  if (edge_contacts_) edge_contacts_->set_anchors(options.warm_start->edge_anchors);
  const auto& skin = options.warm_start->skin_anchors;
  for (std::size_t n = 0; n < std::min(skin.size(), vertices_->count); ++n) {
    if (skin[n]) neighbourhood_->contact(n).set_anchor(*skin[n]);
  }
}

WarmStart ClothForces::warm_start() const {
  WarmStart warm_start;
  if (has_limits()) warm_start.multipliers = kernel_->multipliers();
  if (seams_stand_open()) return warm_start;
  if (edge_contacts_) warm_start.edge_anchors = edge_contacts_->anchors();
  warm_start.pair_anchors = neighbourhood_->pairs().friction().anchors();
  warm_start.skin_anchors.reserve(vertices_->count);
  for (const BodyContact& contact : neighbourhood_->contacts()) {
    warm_start.skin_anchors.push_back(contact.anchor());
  }
  return warm_start;
}

std::vector<Vec3> ClothForces::state() const {
  std::vector<Vec3> state(model_.nodes);
  for (std::size_t n = 0; n < state.size(); ++n) state[n] = as_vec3(nodes_[n]);
  return state;
}

void ClothForces::use_vertices(bool points) {
  // Points and nodes have the same triangles, so the multipliers stay.
  const std::vector<LimitMultiplier> multipliers =
      kernel_ && has_limits() ? kernel_->multipliers() : std::vector<LimitMultiplier>{};
  if (neighbourhood_) searches_before_ += neighbourhood_->searches();
  neighbourhood_.reset();
  edge_contacts_.reset();
  vertices_ = std::make_unique<Vertices>(model_, points);
  kernel_ = std::make_unique<ElasticKernel>(model_, points);
  kernel_->start_multipliers(multipliers);
  elastics_ = std::make_unique<ElasticForces>(model_, points);
  attachments_ = std::make_unique<AttachmentForces>(model_, points);
  vertex_force_.assign(vertices_->count, Vec4{});
  points_.clear();
  if (points) place_points();
  attraction_.clear();
  computed_ = 0;
  neighbourhood_ = std::make_unique<Neighbourhood>(model_, options_, *vertices_, positions(),
                                                   !passes_cloth_, !passes_body_);
  barrier_.reset();
  if (options_.barrier && touches_body(model_.scene)) {
    std::vector<BodyBarrier::Pair> seams;
    for (int n = 0; points && n < model_.nodes; ++n) {
      const auto& sewn = vertices_->of_node[n];
      for (std::size_t i = 1; i < sewn.size(); ++i) seams.push_back({sewn[0], sewn[i]});
    }
    barrier_ =
        std::make_unique<BodyBarrier>(model_.scene, vertices_->triangles, seams, positions());
    way_out_.assign(model_.nodes, Vec3::Zero());
  }
  if (!touches_body_exactly(model_.scene)) return;
  const double shortest =
      std::sqrt(8 * edge_contact_radius * max_sagitta_share * model_.body_offset);
  edge_contacts_ = std::make_unique<EdgeContacts>(vertices_->triangles, positions(), shortest,
                                                  vertices_->spread(model_.friction_skin),
                                                  neighbourhood_->approach_bound());
}

void ClothForces::place_points() {
  if (points_.empty()) {
    points_.resize(model_.node_of_point.size());
    points_.insert(points_.end(), nodes_.begin() + model_.nodes, nodes_.end());
  }
  parallel_for_chunks(model_.node_of_point.size(),
                      [&](std::size_t begin, std::size_t end) { place_points(begin, end); });
}

TOILE_CLONES
void ClothForces::place_points(std::size_t begin, std::size_t end) {
  for (std::size_t p = begin; p < end; ++p) {
    const int n = model_.node_of_point[p];
    points_[p] = nodes_[n] + open_[n] * as_vec4(model_.offsets[p]);
  }
}

void ClothForces::close_seams(double wanted) {
  max_open_ = 0;
  for (std::size_t n = 0; n < open_.size(); ++n) {
    if (vertices_->of_node[n].size() < 2) {
      open_[n] = std::min(open_[n], wanted);
      continue;
    }
    const double change = std::min(wanted - open_[n], 0.0);
    double share = 1;
    // The closing moves the points, no farther than their bounds allow.
    if (change < 0 && neighbourhood_->bounded()) {
      for (const int p : vertices_->of_node[n]) {
        share = std::min(share, neighbourhood_->allowed_share(p, change * model_.offsets[p]));
      }
      if (share < 1) neighbourhood_->request_search();
    }
    if (change < 0) {
      for (const int p : vertices_->of_node[n]) {
        const Vec3 at = as_vec3(points_[p]);
        const Vec3 to = at + change * model_.offsets[p];
        share = std::min(share, neighbourhood_->allowed_share_beside_body(p, at, to));
      }
    }
    open_[n] += share * change;
    max_open_ = std::max(max_open_, open_[n]);
  }
  if (max_open_ <= 0) {
    open_.clear();
    use_vertices(false);
    return;
  }
  place_points();
  for (std::size_t p = 0; p < vertices_->count; ++p) {
    if (!neighbourhood_->is_safe(p, points_[p])) {
      neighbourhood_->set_safe_ball(p, as_vec3(points_[p]));
    }
  }
}

const std::vector<int>& ClothForces::leave_body() {
  left_body_.clear();
  if (!barrier_) return left_body_;
  const auto node_of = [&](int vertex) {
    return seams_stand_open() ? model_.node_of_point[vertex] : vertex;
  };
  const auto take = [&](int vertex, const Vec3& way) {
    const int n = node_of(vertex);
    if (way_out_[n].isZero()) left_body_.push_back(n);
    if (way.squaredNorm() > way_out_[n].squaredNorm()) way_out_[n] = way;
  };
  for (const auto& [place, out] : barrier_->find(positions())) {
    const auto& [points, weights] = place;
    // The two points that a seam will join move as one node.
    if (points[1] == points[2] && node_of(points[0]) == node_of(points[1])) {
      take(points[0], out);
      continue;
    }
    double squares = 0;
    for (const double w : weights) squares += w * w;
    for (int i = 0; i < 3; ++i) {
      if (weights[i] > 0) take(points[i], weights[i] / squares * out);
    }
  }
  for (const int n : left_body_) {
    move_on(n, nodes_[n] + as_vec4(way_out_[n]));
    way_out_[n] = Vec3::Zero();
  }
  if (!left_body_.empty() && seams_stand_open()) place_points();
  return left_body_;
}

const std::vector<int>& ClothForces::leave_cloth() {
  left_cloth_.clear();
  std::vector<char> crossing(vertices_->count, 0);
  std::vector<Vec3> way(model_.nodes, Vec3::Zero());
  for (const EdgeFaceIntersection& found :
       find_edge_face_intersections(state(), model_.node_triangles)) {
    const double length = found.way.norm();
    const Vec3 step = crossing_step / std::max(length, min_crossing_way) * found.way;
    double squares = 0;
    for (const double w : found.weights) squares += w * w;
    for (int i = 0; i < 5; ++i) {
      const int v = i < 2 ? found.edge[i] : found.face[i - 2];
      if (crossing[v] == 0) left_cloth_.push_back(v);
      crossing[v] = 1;
      way[v] += (i < 2 ? 1 : -1) * found.weights[i] / squares * step;
    }
  }
  for (const int n : left_cloth_) {
    const double length = way[n].norm();
    if (length > max_crossing_step) way[n] *= max_crossing_step / length;
    move_on(n, nodes_[n] + as_vec4(way[n]));
  }
  neighbourhood_->ignore(std::move(crossing));
  return left_cloth_;
}

void ClothForces::pass_through_cloth(bool and_body) {
  passes_cloth_ = true;
  passes_body_ = and_body;
  use_vertices(true);
}

bool ClothForces::update_multipliers() {
  if (!has_limits()) return true;
  const std::size_t tasks = chunks_of(kernel_->groups(), vertex_chunk);
  std::vector<ElasticKernel::LimitViolations> counts(tasks);
  parallel_for(tasks, [&](std::size_t c) {
    counts[c] = kernel_->update_multipliers(c * vertex_chunk,
                                            std::min(kernel_->groups(), (c + 1) * vertex_chunk),
                                            stretch_, positions());
  });
  limit_stiffness_.assign(model_.nodes, 0);
  for (std::size_t n = 0; n < limit_stiffness_.size(); ++n) {
    for (const int v : vertices_->of_node[n]) limit_stiffness_[n] += kernel_->stiffening(v);
  }
  return std::all_of(counts.begin(), counts.end(),
                     [](const ElasticKernel::LimitViolations& found) { return found.beyond == 0; });
}

void ClothForces::find_attraction() {
  attraction_.resize(vertices_->count);
  parallel_for_chunks(model_.nodes, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const double weight = model_.mass[n] / static_cast<double>(vertices_->of_node[n].size()) *
                            model_.scene.gravity.norm() * options_.body_attraction;
      for (const int v : vertices_->of_node[n]) {
        attraction_[v] = as_vec4(body_attraction(model_.scene, as_vec3(positions()[v]), weight));
      }
    }
  });
}

void ClothForces::refresh() {
  if (edge_contacts_) edge_contacts_->forget();
  neighbourhood_->refresh();
}

void ClothForces::compute() {
  const bool attracts = options_.body_attraction > 0 && touches_body(model_.scene);
  if (attracts && computed_++ % attraction_interval == 0) find_attraction();
  const Vec4s& p = positions();
  PairForces& pairs = neighbourhood_->pairs();
  pairs.follow(p);
  const std::size_t edges = edge_contacts_ ? edge_contacts_->edges() : 0;
  // Each task gets a share of groups, pairs and edges, so that all tasks take about as long.
  const std::size_t tasks =
      std::max({chunks_of(kernel_->groups(), vertex_chunk), chunks_of(pairs.active(), pair_chunk),
                chunks_of(edges, vertex_chunk)});
  parallel_for(tasks, [&](std::size_t task) {
    const auto share = [&](std::size_t items, const auto& work) {
      work(items * task / tasks, items * (task + 1) / tasks);
    };
    share(kernel_->groups(),
          [&](std::size_t begin, std::size_t end) { kernel_->pull(begin, end, stretch_, p); });
    share(pairs.active(), [&](std::size_t begin, std::size_t end) {
      pairs.push(begin, end, options_.bounded, options_.activation_distance, p);
    });
    if (edges == 0) return;
    share(edges, [&](std::size_t begin, std::size_t end) {
      edge_contacts_->push(begin, end, model_, options_, p);
    });
  });
  // The points of a node may lie in several chunks, so their forces come before the nodes'.
  if (seams_stand_open()) {
    parallel_for_chunks(vertices_->count,
                        [&](std::size_t begin, std::size_t end) { add_up(begin, end); });
  }
}

/// Finds the cloth's own forces on vertices `begin` to `end`.
void ClothForces::add_up(std::size_t begin, std::size_t end) {
  const Vec4s& p = positions();
  // A seam bends as one cloth only when it is sewn.
  kernel_->gather(begin, end, bending_, 1 - max_open_, p, vertex_force_);
  if (!elastics_->empty()) elastics_->add(begin, end, p, vertex_force_);
  if (!attachments_->empty()) attachments_->add(begin, end, p, vertex_force_);
  if (edge_contacts_ && !edge_contacts_->empty()) edge_contacts_->add(begin, end, vertex_force_);
}

/// Adds up all forces on nodes `begin` to `end`.
TOILE_CLONES
void ClothForces::gather(std::size_t begin, std::size_t end) {
  if (!seams_stand_open()) add_up(begin, end);
  const bool has_body = touches_body(model_.scene);
  const bool bends = !model_.bend.empty();
  const bool attracts = !attraction_.empty();
  const PairForces& pairs = neighbourhood_->pairs();
  const Adjacency<int>& of_node = vertices_->of_node;
  const Vec4* const p = positions().data();
  for (std::size_t n = begin; n < end; ++n) {
    Vec4 force = model_.mass[n] * gravity_;
    double stiffness = stretch_stiffness(n);
    if (bends) stiffness += bending_ * model_.bend_diagonal[n];
    const double friction = options_.friction ? model_.friction_skin[n] : 0;
    for (const int v : of_node[n]) {
      stiffness += vertex_force_[v][3];
      force += vertex_force_[v];
      pairs.add(v, force, stiffness);
      if (has_body && neighbourhood_->near_body(v)) {
        neighbourhood_->contact(v).add(p[v], friction, force, stiffness);
      }
      if (attracts) force += attraction_[v];
    }
    force[3] = stiffness;
    node_force_[n] = force;
  }
}

/// Share in [0, 1] of a displacement (metres) of node n that the bounds of all its vertices allow.
double ClothForces::allowed_share(std::size_t n, const Vec3& displacement) const {
  double share = 1;
  for (const int v : vertices_->of_node[n]) {
    share = std::min(share, neighbourhood_->allowed_share(v, displacement));
  }
  return share;
}

/// The position on the path to `wanted` that node n reaches before one of its vertices leaves its
/// bound.
Vec3 ClothForces::within_bounds(std::size_t n, const Vec3& wanted) const {
  if (!seams_stand_open()) return neighbourhood_->clipped(n, wanted);
  const Vec3 from = as_vec3(nodes_[n]);
  const Vec3 displacement = wanted - from;
  const double share = allowed_share(n, displacement);
  return share < 1 ? Vec3(from + share * displacement) : wanted;
}

/// Where node n comes on its path beside the body. No point of an open seam leaves its bounds.
Vec3 ClothForces::reached_beside_body(std::size_t n, const Vec3& from, const Vec3& to) const {
  if (!seams_stand_open()) return neighbourhood_->reached_beside_body(n, from, to);
  Vec3 reached = to;
  const auto offset = [&](int p) { return Vec3(open_[n] * model_.offsets[p]); };
  for (const int p : vertices_->of_node[n]) {
    const Vec3 wanted = reached + offset(p);
    const Vec3 beside = neighbourhood_->reached_beside_body(p, from + offset(p), wanted);
    if (beside != wanted) reached = beside - offset(p);
  }
  if (reached == to) return to;
  double share = 1;
  for (const int p : vertices_->of_node[n]) {
    share = std::min(
        share, neighbourhood_->allowed_share_beside_body(p, from + offset(p), reached + offset(p)));
  }
  return from + share * (reached - from);
}

/// Moves a node that leaves the safe ball of one of its vertices. It stops at its bounds, and its
/// vertices get new balls. Returns whether it got to `wanted`.
bool ClothForces::move_on(std::size_t n, const Vec4& wanted) {
  Vec3 next = as_vec3(wanted);
  bool allowed = true;
  if (neighbourhood_->bounded()) {
    const Vec3 within = within_bounds(n, next);
    allowed = within == next;
    if (!allowed) neighbourhood_->request_search();
    next = within;
  }
  const Vec3 from = as_vec3(nodes_[n]);
  const Vec3 beside = reached_beside_body(n, from, next);
  if (beside != next) {
    allowed = false;
    next = beside;
    // The way along the body may leave the ball that cloth allows.
    if (neighbourhood_->bounded()) {
      next = from + allowed_share(n, next - from) * (next - from);
    }
  }
  nodes_[n] = as_vec4(next);
  if (!seams_stand_open()) {
    neighbourhood_->set_safe_ball(n, next);
    return allowed;
  }
  for (const int v : vertices_->of_node[n]) {
    neighbourhood_->set_safe_ball(v, next + open_[n] * model_.offsets[v]);
  }
  return allowed;
}

}  // namespace toile
