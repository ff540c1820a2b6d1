// All that acts on the nodes of a garment, and how far each may go: what relaxation and release,
// which move them, have in common.
#pragma once

#include <memory>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/relaxation/attachment_forces.h"
#include "cloth/relaxation/edge_contacts.h"
#include "cloth/relaxation/elastic_forces.h"
#include "cloth/relaxation/elastic_kernel.h"
#include "cloth/relaxation/force_options.h"
#include "cloth/relaxation/neighbourhood.h"
#include "cloth/relaxation/vertices.h"
#include "geometry/parallel.h"
#include "geometry/vec4.h"

namespace toile {

/// The nodes of a garment in motion. A step is two calls: step_forces(), which finds the forces
/// where the nodes stand, and advance(), which moves them. Model and options stay where they are as
/// long as this lives.
class ClothForces {
 public:
  /// `x`: metres, one a node. With `open_seams`, seams stand as they were placed until
  /// close_seams().
  ClothForces(const GarmentModel& model, const ForceOptions& options,
              const SearchInterval& interval, const std::vector<Vec3>& x, bool open_seams);

  const Vec4& node(std::size_t n) const { return nodes_[n]; }
  const Vec4s& nodes() const { return nodes_; }  ///< and then what does not move
  std::vector<Vec3> state() const;
  WarmStart warm_start() const;

  double open() const { return open_; }  ///< 1: seams as placed, 0: closed
  bool seams_stand_open() const { return vertices_->are_points; }
  /// Closes the seams until `open` is left, or as far as bounds allow; at 0 they are sewn for good.
  void close_seams(double open);

  /// Finds the forces of one step. Calls take(begin, end, forces) for ranges of nodes, in parallel:
  /// per node the force (N), with a bound of its stiffness (N/m) as the fourth. `bending`
  /// multiplies the bending stiffness. Searches for near cloth where that is due, and friction
  /// slides along, so each call is a step's.
  template <typename Take>
  void step_forces(double bending, const Take& take) {
    bending_ = bending;
    neighbourhood_->update(interval_);
    compute();
    gather_all(take);
  }
  /// The same forces where the nodes stand, all that is near found anew, without a search.
  template <typename Take>
  void fresh_forces(double bending, const Take& take) {
    bending_ = bending;
    refresh();
    compute();
    gather_all(take);
  }

  /// Moves nodes for advance().
  class Mover {
   public:
    /// Moves node n to `wanted`, or as far as its bounds allow: then false.
    [[gnu::always_inline]] bool operator()(std::size_t n, const Vec4& wanted) const {
      for (const int v : of_node_[n]) {
        if (!neighbourhood_.is_safe(v, positions_[v] + (wanted - nodes_[n]))) {
          return forces_.move_on(n, wanted);
        }
      }
      nodes_[n] = wanted;
      return true;
    }

   private:
    friend class ClothForces;
    explicit Mover(ClothForces& forces)
        : forces_(forces),
          neighbourhood_(*forces.neighbourhood_),
          of_node_(forces.vertices_->of_node),
          positions_(forces.positions().data()),
          nodes_(forces.nodes_.data()) {}
    ClothForces& forces_;
    const Neighbourhood& neighbourhood_;
    const Adjacency<int>& of_node_;
    const Vec4* const positions_;
    Vec4* const nodes_;
  };
  /// Calls step(begin, end, mover) for ranges of nodes, in parallel, to move each node once.
  template <typename Step>
  void advance(const Step& step) {
    parallel_for_chunks(
        model_.nodes, [&](std::size_t begin, std::size_t end) { step(begin, end, Mover(*this)); });
    if (seams_stand_open()) place_points();
  }

  int searches() const { return searches_before_ + neighbourhood_->searches(); }
  /// Share of the stiffness that resists compression from now on.
  void resist_compression(double share) { stretch_.compression = share; }
  bool has_limits() const { return stretch_.limit >= 0 || stretch_.shear_limit >= 0; }
  /// Tightens and loosens the multipliers of the scene's limits. Returns whether the yarns are
  /// within them, but for those whose multiplier is at its largest.
  bool update_multipliers();
  /// Metres that node n is held off the body beyond the model's offset.
  double extra_offset(int n) const { return neighbourhood_->extra_offset(n); }
  /// A bound of the cloth's own stiffness in its plane at node n, N/m, limits included.
  double stretch_stiffness(std::size_t n) const {
    return model_.stretch_diagonal[n] + limit_stiffness(n);
  }
  /// What limits add to that.
  double limit_stiffness(std::size_t n) const {
    return limit_stiffness_.empty() ? 0 : limit_stiffness_[n];
  }

 private:
  void use_vertices(bool points);
  void refresh();
  void compute();
  void gather(std::size_t begin, std::size_t end);
  template <typename Take>
  void gather_all(const Take& take) {
    parallel_for_chunks(model_.nodes, [&](std::size_t begin, std::size_t end) {
      gather(begin, end);
      take(begin, end, node_force_);
    });
  }
  void add_up(std::size_t begin, std::size_t end);
  bool move_on(std::size_t n, const Vec4& wanted);
  Vec3 within_bounds(std::size_t n, const Vec3& wanted) const;
  void place_points();
  void find_attraction();
  const Vec4s& positions() const { return seams_stand_open() ? points_ : nodes_; }

  const GarmentModel& model_;
  const ForceOptions& options_;
  const SearchInterval interval_;
  StretchOptions stretch_;
  const Vec4 gravity_;
  Vec4s nodes_;         // then the layers' points
  Vec4s points_;        // likewise the material points, while seams stand open
  Vec4s node_force_;    // what step_forces() hands out
  Vec4s vertex_force_;  // N, with the stiffness as the fourth: from the cloth itself
  Vec4s attraction_;    // N, per vertex, to the body; empty: none
  std::vector<double> limit_stiffness_;  // N/m, per node; empty: no limits
  double open_ = 0;
  double bending_ = 1;
  int computed_ = 0;
  int searches_before_ = 0;  // of the vertices before these

  // Made anew when the vertices become the nodes.
  std::unique_ptr<Vertices> vertices_;
  std::unique_ptr<ElasticKernel> kernel_;
  std::unique_ptr<ElasticForces> elastics_;
  std::unique_ptr<AttachmentForces> attachments_;
  std::unique_ptr<EdgeContacts> edge_contacts_;  // null: no edge is long enough
  std::unique_ptr<Neighbourhood> neighbourhood_;
};

}  // namespace toile
