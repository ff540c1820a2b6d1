// Contacts of each vertex of the cloth, and how far it may move until they must be found anew.
#pragma once

#include <atomic>
#include <memory>
#include <utility>
#include <vector>

#include "cloth/contact/body_bounds.h"
#include "cloth/contact/body_contact.h"
#include "cloth/contact/pair_forces.h"
#include "cloth/contact/proximity.h"
#include "cloth/model/garment_model.h"
#include "cloth/relaxation/constants.h"
#include "cloth/relaxation/force_options.h"
#include "cloth/relaxation/vertices.h"
#include "geometry/vec4.h"

namespace toile {

/// Steps between two searches for near cloth.
struct SearchInterval {
  int min = 1;  ///< for so many steps a node that has used up its bound waits
  /// Without bounds, a node may leave the searched neighbourhood after so many.
  int max = max_search_interval;
};

/// Whether a run keeps the cloth off motionless layers.
inline bool touches_layers(const GarmentModel& model, const ForceOptions& options) {
  return model.scene.self_contact && options.layer_contact && has_layers(model.scene);
}

/// The contacts of all vertices. Each vertex has a safe ball. While it stays inside, nothing new
/// can touch it, and its bounds hold. Calls for different vertices may run in parallel.
class Neighbourhood {
 public:
  /// `x`: metres, one a vertex, then the points of the scene's layers. It is read at each update.
  /// Model, options, vertices and `x` must outlive this.
  /// Without `self_contact`, cloth passes through cloth, whatever the scene says. Without
  /// `body_bounds`, nothing but a push keeps it off the body.
  Neighbourhood(const GarmentModel& model, const ForceOptions& options, const Vertices& vertices,
                const Vec4s& x, bool self_contact = true, bool body_bounds = true);

  /// Searches for near cloth when vertices have used up their bounds, and updates the body's
  /// bounds.
  void update(const SearchInterval& interval);
  /// Finds all contacts with the body and the active pairs anew at the present positions.
  void refresh();
  /// Number of searches for near cloth so far.
  int searches() const { return searches_; }

  BodyContact& contact(std::size_t v) { return contacts_[v]; }
  /// Whether the body is near enough to push vertex v: contact(v).near(), kept in a byte.
  [[gnu::always_inline]] bool near_body(std::size_t v) const { return near_body_[v] != 0; }
  PairForces& pairs() { return pairs_; }
  const PairForces& pairs() const { return pairs_; }
  const std::vector<BodyContact>& contacts() const { return contacts_; }
  /// Metres, per vertex, by which it may approach the body in a step.
  const std::vector<double>& approach_bound() const { return approach_bound_; }
  /// Metres that a vertex keeps from the body beyond the model's offset.
  double extra_offset(int v) const { return body_bounds_ ? body_bounds_->extra_offset(v) : 0; }

  /// Whether `p` (metres) is inside the safe ball of vertex v.
  [[gnu::always_inline]] bool is_safe(std::size_t v, const Vec4& p) const {
    return !(squared_length(p - safe_balls_[v]) > safe_balls_[v][3]);
  }
  /// Finds the safe ball of vertex v, which has come to `p` (metres).
  void set_safe_ball(std::size_t v, const Vec3& p);

  /// Whether vertices keep within the bounds of the last search.
  bool bounded() const { return options_.bounded && !bound_.empty(); }
  /// Share in [0, 1] of a displacement (metres) of vertex v that its bound allows.
  double allowed_share(std::size_t v, const Vec3& displacement) const;
  /// The point nearest to `wanted` (metres) that the bound of vertex v allows.
  Vec3 clipped(std::size_t v, const Vec3& wanted) const;
  /// Share in [0, 1] of the path of vertex v that the body's bounds allow; 1 without bounds.
  double allowed_share_beside_body(std::size_t v, const Vec3& from, const Vec3& to);
  /// Where vertex v comes on its path within the body's bounds; `to` without bounds.
  Vec3 reached_beside_body(std::size_t v, const Vec3& from, const Vec3& to);
  /// Lets the pairs of some vertices push nothing: per vertex, not 0 for those.
  void ignore(std::vector<char> vertices) {
    ignored_ = std::move(vertices);
    activation_due_ = true;
  }
  /// Reports that a vertex has used up its bound, so that the next update() may search.
  void request_search() { search_due_ = true; }

 private:
  void search();
  void activate_pairs();
  void set_safe_balls();
  void update_body_bounds();
  std::vector<Vec3> positions() const;

  const GarmentModel& model_;
  const ForceOptions& options_;
  const Vertices& vertices_;
  const Vec4s& x_;
  std::vector<BodyContact> contacts_;   // per vertex
  std::vector<char> near_body_;         // per vertex
  std::vector<double> approach_bound_;  // metres, per vertex
  /// Metres, per vertex: the centre of its ball, and the squared radius as the fourth.
  Vec4s safe_balls_;
  std::unique_ptr<BodyBounds> body_bounds_;
  std::unique_ptr<ProximitySearch> proximity_;
  PairForces pairs_;
  std::vector<double> bound_;  // metres, per vertex, around searched_at_; empty before a search
  std::vector<Vec3> searched_at_;
  std::vector<Vec3> activated_at_;
  std::vector<char> ignored_;  // per vertex; empty: none
  int since_search_ = 0;
  int searches_ = 0;
  int body_updates_ = 0;
  std::atomic<bool> search_due_ = true;
  std::atomic<bool> activation_due_ = true;
};

}  // namespace toile
