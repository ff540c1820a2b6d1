// Moves whole patches of the cloth by the forces on them: what is soft and wide comes to rest with
// the coarse meshes' iterations, not the fine one's.
#pragma once

#include <array>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/relaxation/aggregates.h"
#include "cloth/relaxation/block_stiffness.h"
#include "geometry/adjacency.h"
#include "geometry/vec4.h"

namespace toile {

/// Additive multilevel preconditioner [Bramble, Pasciak & Xu 1990]: on each coarser level, the
/// forces on a patch over a bound of its stiffness. Patches are the hat functions of the coarse
/// nodes of the model's nested mesh, and beyond the coarsest of them two levels of wide patches,
/// where there are enough nodes for them; without a nested mesh, or unless `wide`, none. A patch's
/// bound is its middle node's, for the stiffness of a membrane does not depend on the size of its
/// triangles, and that of bending grows with finer ones; what touches adds up.
class MultilevelPreconditioner {
 public:
  MultilevelPreconditioner(const GarmentModel& model, bool with_aggregates);

  int levels() const { return static_cast<int>(levels_.size()); }
  /// Those of the nested mesh; the others are wide.
  int nested_levels() const { return nested_; }

  /// The cloth's stiffness at each of the model's nodes: from now on a patch has the mean of its
  /// nodes', instead of the same in all directions.
  void set_blocks(const std::vector<StiffnessBlock>& of_nodes);

  /// Ways of the coarse nodes, by the forces (N) on all nodes, with the stiffness (N/m) of what
  /// they touch as the fourth. `bending` multiplies the bending stiffness.
  void compute(const Vec4s& forces, double bending);
  /// What compute() found for a node, metres.
  [[gnu::always_inline]] Vec4 of_node(std::size_t n) const {
    if (levels_.empty()) return Vec4{};
    return between_parents(levels_.front(), n);
  }
  /// Of the nested mesh's coarsest patches by what compute() was given, m/s²; 0 without. Forces
  /// that neighbours have on each other cancel: what is left sets cloth in motion as a whole.
  double rms_acceleration() const;

 private:
  struct Share {
    int node;
    double weight;
  };
  struct Level {
    std::vector<std::array<int, 2>> parents;  // per finer node; the same twice: it is one of these
    Adjacency<AggregateShare> patches;        // per finer node, of a wide level; it has no parents
    Adjacency<Share> shares;                  // per node, of finer ones
    std::vector<double> stretch;              // N/m, per node, in all directions
    std::vector<StiffnessBlock> blocks;       // per node
    std::vector<double> bend;
    std::vector<double> mass;  // kg
    Vec4s force;
    Vec4s displacement;
  };
  [[gnu::always_inline]] static Vec4 between_parents(const Level& level, std::size_t finer) {
    const auto& [a, b] = level.parents[finer];
    return 0.5 * (level.displacement[a] + level.displacement[b]);
  }
  std::vector<Triangle> add_nested_levels(const GarmentModel& model);
  void add_aggregate_level(const Aggregates& aggregates);
  void add_level(Level level);
  static Vec4 displacement_at(const Level& level, std::size_t finer);
  void restrict_forces(const Level& level, const Vec4s& finer, Vec4s& force) const;

  int nested_ = 0;
  double isotropic_share_ = 1;  // share of the levels' stretch
  std::vector<Level> levels_;   // the finer first
};

}  // namespace toile
