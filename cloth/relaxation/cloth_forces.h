// All that acts on the nodes of a garment, and how far each may go: what relaxation and release,
// which move them, have in common.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "cloth/contact/body_bounds.h"
#include "cloth/contact/body_contact.h"
#include "cloth/contact/pair_forces.h"
#include "cloth/contact/proximity.h"
#include "cloth/model/garment_model.h"
#include "cloth/relaxation/attachment_forces.h"
#include "cloth/relaxation/edge_contacts.h"
#include "cloth/relaxation/elastic_forces.h"
#include "cloth/relaxation/elastic_kernel.h"
#include "cloth/relaxation/force_options.h"
#include "geometry/adjacency.h"
#include "geometry/vec4.h"

namespace toile {

/// Nodes stand where move() brought them. A step of all of them: search_when_due(), compute(), then
/// gather() of disjoint ranges, for each of their nodes at(), and, after all of that, move() for
/// each node. These may run side by side; then moved(). The options and the model stay where they
/// are as long as this lives.
class ClothForces {
 public:
  /// `x`: one a node, metres. With `open_seams`, seams stand as they were placed, until
  /// close_seams(); vertices, which touch things, are material points until then, else nodes.
  ClothForces(const GarmentModel& model, const ForceOptions& options, const std::vector<Vec3>& x,
              bool open_seams);

  const Vec4& node(std::size_t n) const { return nodes_[n]; }
  const Vec4s& nodes() const { return nodes_; }  ///< and then what does not move
  std::vector<Vec3> state() const;
  WarmStart warm_start() const;
  double open() const { return open_; }  ///< 1: seams as placed, 0: closed
  bool seams_stand_open() const { return by_points_; }
  /// Closes them until `open` is left, or as far as bounds allow; at 0 they are sewn for good.
  void close_seams(double open);

  /// Looks for near cloth when nodes have used up their bounds; `interval` compute()s apart at
  /// least, and, unbounded, `max_interval` at most.
  void search_when_due(int interval, int max_interval);
  int searches() const { return searches_; }
  /// Share of the stiffness that resists compression from now on.
  void resist_compression(double share) { stretch_.compression = share; }
  /// Tightens and loosens what holds the yarns to the scene's limits, now and then. Returns whether
  /// they are within them, but for those that are held as much as they can be.
  bool update_multipliers();
  /// Metres that node n is held off the body beyond the options' offset.
  double extra_offset(int n) const { return body_bounds_ ? body_bounds_->extra_offset(n) : 0; }
  bool has_limits() const { return stretch_.limit >= 0 || stretch_.shear_limit >= 0; }
  /// A bound of the cloth's own stiffness in its plane at node n, N/m; and what of it limits add.
  double stretch_stiffness(std::size_t n) const {
    return model_.stretch_diagonal[n] + stiffening(n);
  }
  double stiffening(std::size_t n) const { return stiffening_.empty() ? 0 : stiffening_[n]; }

  /// Forgets what is known of the body and of who is near, to see it anew where the nodes are.
  void look_anew();

  /// Between cloth and cloth, and within the cloth. `bending` multiplies its bending stiffness.
  void compute(double bending);
  /// Adds up what compute() found for nodes `begin` to `end`.
  void gather(std::size_t begin, std::size_t end) {
    if (!by_points_) add_up(begin, end);
  }
  /// What gather() found, with weight, body and friction: the force (N) and a bound of its
  /// stiffness (N/m). Once for each compute(), for friction slides along.
  [[gnu::always_inline]] void at(std::size_t n, Vec4& force, double& stiffness);

  /// Moves a node to `wanted`, or as far as its bounds allow: then false.
  [[gnu::always_inline]] bool move(std::size_t n, const Vec4& wanted);
  void moved() {
    if (by_points_) place_points();
  }

 private:
  void use_skin(bool points);
  bool bounded() const { return options_.bounded && !bound_.empty(); }
  void search();
  void activate_pairs();
  bool leave_safe_ball(std::size_t node, const Vec4& wanted);
  Vec3 within_bounds(std::size_t node, const Vec3& wanted) const;
  void set_safe_ball(std::size_t vertex, const Vec3& p);
  void set_safe_balls();
  void update_body_bounds();
  void place_points();
  void find_pull();
  void add_up(std::size_t begin, std::size_t end);
  std::vector<double> approach_bounds() const;
  std::vector<double> of_vertices(const std::vector<double>& of_nodes) const;
  std::vector<Vec3> all_positions() const;
  std::size_t vertices() const { return kernel_->vertices(); }
  const Vec4s& positions() const { return by_points_ ? points_ : nodes_; }
  bool self_contact() const { return model_.scene.self_contact; }
  bool exact_body() const {
    return touches_body(model_.scene) && model_.scene.body_contact == BodyContactTerm::faces;
  }
  bool layer_contact() const {
    return self_contact() && options_.layer_contact && has_layers(model_.scene);
  }
  const TriangleMesh& layers() const { return model_.scene.collider->cloth(); }

  const GarmentModel& model_;
  const ForceOptions& options_;
  StretchOptions stretch_;
  const Vec4 gravity_;
  Vec4s nodes_;  // then the layers' points
  std::unique_ptr<ElasticKernel> kernel_;
  std::unique_ptr<ElasticForces> elastics_;
  std::unique_ptr<AttachmentForces> attachments_;
  Vec4s vertex_force_;
  Vec4s pull_;  // N, per vertex, to the body; empty: none
  int computed_ = 0;
  std::vector<double> stiffening_;  // N/m, per node: by the limits; empty: there are none

  bool by_points_ = false;
  double open_ = 0;
  double bending_ = 1;
  Vec4s points_;                        // as nodes_, of the material points, while seams stand open
  Adjacency<int> vertices_of_;          // per node: its material points, while seams stand open
  std::vector<BodyContact> contacts_;   // per vertex
  std::vector<double> approach_bound_;  // metres, per vertex, onto the body
  /// Per vertex: where it was last looked after, and the square of how far it may go from there
  /// before it has to be looked after again.
  Vec4s safe_balls_;

  std::unique_ptr<EdgeContacts> edge_contacts_;
  std::unique_ptr<BodyBounds> body_bounds_;
  std::unique_ptr<ProximitySearch> proximity_;
  PairForces pairs_;
  std::vector<double> bound_;
  std::vector<Vec3> searched_at_;
  std::vector<Vec3> activated_at_;
  int since_search_ = 0;
  int searches_ = 0;
  int looks_ = 0;
  std::atomic<bool> search_due_ = true;
  std::atomic<bool> activation_due_ = true;
};

inline void ClothForces::at(std::size_t n, Vec4& force, double& stiffness) {
  const bool has_body = touches_body(model_.scene);
  force = model_.mass[n] * gravity_;
  stiffness = stretch_stiffness(n);
  if (!model_.bend.empty()) stiffness += bending_ * model_.bend_diagonal[n];
  const double friction = options_.friction ? model_.friction_skin[n] : 0;
  for (const int v : vertices_of_[n]) {
    const Vec4& p = positions()[v];
    stiffness += vertex_force_[v][3];
    force += vertex_force_[v];
    pairs_.add(v, force, stiffness);
    if (has_body) contacts_[v].add(p, friction, force, stiffness);
    if (!pull_.empty()) force += pull_[v];
  }
  force[3] = 0;
}

inline bool ClothForces::move(std::size_t n, const Vec4& wanted) {
  for (const int v : vertices_of_[n]) {
    const Vec4 moved = positions()[v] + (wanted - nodes_[n]) - safe_balls_[v];
    if (squared_length(moved) > safe_balls_[v][3]) return leave_safe_ball(n, wanted);
  }
  nodes_[n] = wanted;
  return true;
}

}  // namespace toile
