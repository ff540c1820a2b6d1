// What is near each vertex of the cloth, and how far it may go until that has to be found anew.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "cloth/contact/body_bounds.h"
#include "cloth/contact/body_contact.h"
#include "cloth/contact/pair_forces.h"
#include "cloth/contact/proximity.h"
#include "cloth/model/garment_model.h"
#include "cloth/relaxation/force_options.h"
#include "cloth/relaxation/vertices.h"
#include "geometry/vec4.h"

namespace toile {

/// Steps between two searches for near cloth.
struct SearchInterval {
  int min = 1;   ///< a node that has used up its bound waits so long
  int max = 50;  ///< unbounded, a node may leave the searched neighbourhood by then
};

/// Whether a run keeps the cloth off the layers below.
inline bool touches_layers(const GarmentModel& model, const ForceOptions& options) {
  return model.scene.self_contact && options.layer_contact && has_layers(model.scene);
}

/// Each vertex has a safe ball: as long as it stays inside, nothing new can touch it, and nothing
/// that bounds keep apart can meet. Different vertices may ask at the same time.
class Neighbourhood {
 public:
  /// `x`: metres, one a vertex, then the points of the layers below; it stays where it is and is
  /// read whenever the neighbourhood is updated. So stay model, options and vertices.
  Neighbourhood(const GarmentModel& model, const ForceOptions& options, const Vertices& vertices,
                const Vec4s& x);

  /// Searches for near cloth when vertices have used up their bounds, and looks after the body's.
  void update(const SearchInterval& interval);
  /// Forgets the body and the active pairs, and finds them anew where the vertices are.
  void refresh();
  int searches() const { return searches_; }

  BodyContact& contact(std::size_t v) { return contacts_[v]; }
  PairForces& pairs() { return pairs_; }
  const PairForces& pairs() const { return pairs_; }
  const std::vector<BodyContact>& contacts() const { return contacts_; }
  /// Metres, per vertex, that it may come down onto the body in a step.
  const std::vector<double>& approach_bound() const { return approach_bound_; }
  /// Metres that a vertex is held off the body beyond the offset of all.
  double extra_offset(int v) const { return body_bounds_ ? body_bounds_->extra_offset(v) : 0; }

  /// Whether a vertex at `p` is inside its safe ball.
  [[gnu::always_inline]] bool is_safe(std::size_t v, const Vec4& p) const {
    return !(squared_length(p - safe_balls_[v]) > safe_balls_[v][3]);
  }
  /// Finds the safe ball of a vertex that has come to `p`.
  void set_safe_ball(std::size_t v, const Vec3& p);

  /// Whether vertices keep within the bounds of the last search.
  bool bounded() const { return options_.bounded && !bound_.empty(); }
  /// Share in [0, 1] of a displacement of vertex v, from where it is, that its bound allows.
  double allowed_share(std::size_t v, const Vec3& displacement) const;
  /// The place nearest to `wanted` that the bound of vertex v allows.
  Vec3 clipped(std::size_t v, const Vec3& wanted) const;
  /// Share in [0, 1] of the path of vertex v that the body's bounds allow; 1 without such bounds.
  double allowed_by_body(std::size_t v, const Vec3& from, const Vec3& to);
  /// A vertex has used up its bound: the next update() may search.
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
  std::vector<BodyContact> contacts_;  // per vertex
  std::vector<double> approach_bound_;
  /// Per vertex: where it was when its ball was found, and the square of the ball's radius.
  Vec4s safe_balls_;
  std::unique_ptr<BodyBounds> body_bounds_;
  std::unique_ptr<ProximitySearch> proximity_;
  PairForces pairs_;
  std::vector<double> bound_;  // metres, per vertex, around searched_at_; empty: never searched
  std::vector<Vec3> searched_at_;
  std::vector<Vec3> activated_at_;
  int since_search_ = 0;
  int searches_ = 0;
  int body_updates_ = 0;
  std::atomic<bool> search_due_ = true;
  std::atomic<bool> activation_due_ = true;
};

}  // namespace toile
