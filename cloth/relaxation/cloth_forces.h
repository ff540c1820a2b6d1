// All forces on the nodes of a garment, and how far each node may move: the common part of
// relaxation and release.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/relaxation/attachment_forces.h"
#include "cloth/relaxation/body_barrier.h"
#include "cloth/relaxation/edge_contacts.h"
#include "cloth/relaxation/elastic_forces.h"
#include "cloth/relaxation/elastic_kernel.h"
#include "cloth/relaxation/force_options.h"
#include "cloth/relaxation/neighbourhood.h"
#include "cloth/relaxation/vertices.h"
#include "geometry/parallel.h"
#include "geometry/vec4.h"

namespace toile {

/// The nodes of a garment in motion. A step is two calls: step_forces() finds the forces at the
/// present positions, advance() moves the nodes. Model and options must outlive this.
class ClothForces {
 public:
  /// `x`: metres, one a node. With `open_seams`, seams stand as they were placed until
  /// close_seams(). `interval` limits the searches for near cloth.
  ClothForces(const GarmentModel& model, const ForceOptions& options,
              const SearchInterval& interval, const std::vector<Vec3>& x, bool open_seams);

  /// Metres: the position of node n.
  const Vec4& node(std::size_t n) const { return nodes_[n]; }
  const Vec4s& nodes() const { return nodes_; }  ///< metres; the layers' points come last
  /// Metres, one a node.
  std::vector<Vec3> state() const;
  /// Anchors and multipliers at the end, for the next run.
  WarmStart warm_start() const;

  /// Share of their offset by which the points of each node stand apart. 1: as placed, 0: closed.
  const std::vector<double>& open() const { return open_; }
  bool seams_stand_open() const { return vertices_->are_points; }
  /// Closes the seams until the share `open` of their width is left, each node by itself, as far
  /// as its bounds allow. Once all are at 0, they are sewn for good.
  void close_seams(double open);
  /// From here on cloth passes through cloth while the seams close, and through the body if asked.
  void pass_through_cloth(bool and_body);

  /// Finds the forces of one step. Calls take(begin, end, forces) for ranges of nodes, in parallel.
  /// `forces` has the force (N) of each node, with a bound of its stiffness (N/m) as the fourth
  /// component. `bending` is a factor on the bending stiffness. A call may search for near cloth,
  /// and it slides the anchors of friction. So there is one call a step. Linear in the triangles
  /// and active pairs.
  template <typename Take>
  void step_forces(double bending, const Take& take) {
    bending_ = bending;
    neighbourhood_->update(interval_);
    compute();
    gather_all(take);
  }
  /// Finds the forces as step_forces() does, but first finds contacts and active pairs anew at the
  /// present positions. It does not search for near cloth.
  template <typename Take>
  void fresh_forces(double bending, const Take& take) {
    bending_ = bending;
    refresh();
    compute();
    gather_all(take);
  }

  /// N: the sum of the cloth's own forces on node n in the last step, which contacts and weight
  /// balance at rest. Seams are closed.
  double load(std::size_t n) const { return std::sqrt(squared_length(vertex_force_[n])); }

  /// Moves nodes for advance().
  class Mover {
   public:
    /// Moves node n to `wanted` (metres), or as far as its bounds allow. Returns whether it got
    /// there.
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
  /// Calls step(begin, end, mover) for ranges of nodes, in parallel. `step` calls `mover` once for
  /// each node.
  template <typename Step>
  void advance(const Step& step) {
    parallel_for_chunks(
        model_.nodes, [&](std::size_t begin, std::size_t end) { step(begin, end, Mover(*this)); });
    if (seams_stand_open()) place_points();
  }

  /// Moves nodes so that cloth leaves the body, as far as bounds allow. Returns the nodes that were
  /// moved; none without ForceOptions::barrier.
  const std::vector<int>& leave_body();

  /// Draws cloth that has come through cloth back by a small step. Returns the nodes that were
  /// moved; none: no cloth crosses cloth. Seams are closed.
  const std::vector<int>& leave_cloth();

  /// Number of searches for near cloth so far.
  int searches() const { return searches_before_ + neighbourhood_->searches(); }
  /// Sets the share of the stiffness that resists compression.
  void resist_compression(double share) { stretch_.compression = share; }
  /// Whether the scene limits strain or shear.
  bool has_limits() const { return stretch_.limit >= 0 || stretch_.shear_limit >= 0; }
  /// Updates the multipliers of the scene's limits. Returns whether all yarns are within their
  /// limits, except those whose multiplier is at its largest.
  bool update_multipliers();
  /// Metres that node n keeps from the body beyond the model's offset.
  double extra_offset(int n) const {
    double most = 0;
    for (const int v : vertices_->of_node[n])
      most = std::max(most, neighbourhood_->extra_offset(v));
    return most;
  }
  /// N/m: a bound of the cloth's stiffness in its plane at node n, limits included.
  double stretch_stiffness(std::size_t n) const {
    return model_.stretch_diagonal[n] + limit_stiffness(n);
  }
  /// N/m: the part of it that limits add.
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
  double allowed_share(std::size_t n, const Vec3& displacement) const;
  Vec3 within_bounds(std::size_t n, const Vec3& wanted) const;
  Vec3 reached_beside_body(std::size_t n, const Vec3& from, const Vec3& to) const;
  void place_points();
  void place_points(std::size_t begin, std::size_t end);
  void find_attraction();
  const Vec4s& positions() const { return seams_stand_open() ? points_ : nodes_; }

  const GarmentModel& model_;
  const ForceOptions& options_;
  const SearchInterval interval_;
  StretchOptions stretch_;
  const Vec4 gravity_;
  Vec4s nodes_;   // metres: the nodes, then the layers' points
  Vec4s points_;  // metres: the material points, then the layers' points; while seams stand open
  Vec4s node_force_;  // per node, the argument of take(): force (N), stiffness (N/m) as the fourth
  Vec4s vertex_force_;  // per vertex, of the cloth's own forces: N, stiffness (N/m) as the fourth
  Vec4s attraction_;    // N, per vertex, to the body; empty: no attraction
  std::vector<double> limit_stiffness_;  // N/m, per node; empty: no limits
  std::vector<double> open_;             // per node; empty: the seams are closed
  double max_open_ = 0;
  bool passes_cloth_ = false;
  bool passes_body_ = false;
  double bending_ = 1;
  int computed_ = 0;
  int searches_before_ = 0;  // by the neighbourhood of the material points

  // Made anew when the seams are sewn and nodes replace points as vertices.
  std::unique_ptr<Vertices> vertices_;
  std::unique_ptr<ElasticKernel> kernel_;
  std::unique_ptr<ElasticForces> elastics_;
  std::unique_ptr<AttachmentForces> attachments_;
  std::unique_ptr<EdgeContacts> edge_contacts_;  // null: no edge is long enough
  std::unique_ptr<Neighbourhood> neighbourhood_;
  std::unique_ptr<BodyBarrier> barrier_;  // null: not asked for, or there is no body
  std::vector<int> left_body_;
  std::vector<int> left_cloth_;
  std::vector<Vec3> way_out_;  // metres, per node
};

}  // namespace toile
