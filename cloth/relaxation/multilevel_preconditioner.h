// A multilevel preconditioner: it moves whole patches of the cloth by the forces on them. So wide
// and soft motions need as few iterations as on a coarse mesh.
#pragma once

#include <array>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/relaxation/aggregates.h"
#include "cloth/relaxation/block_stiffness.h"
#include "geometry/adjacency.h"
#include "geometry/vec4.h"

namespace toile {

/// Additive multilevel preconditioner [Bramble, Pasciak & Xu 1990]. On each coarser level, the
/// displacement of a patch is the force on it over a bound of its stiffness.
///
/// Patches are the hat functions of the coarse nodes of the model's nested mesh. Above the coarsest
/// of these there are up to two levels of aggregates, where there are enough nodes for them.
///
/// A patch has the stiffness bounds of its middle node. The bound of a membrane does not depend on
/// the size of its triangles, and that of bending grows with finer ones. The stiffness of contacts
/// is summed over a patch.
class MultilevelPreconditioner {
 public:
  /// Without a nested mesh there are no levels. O(n).
  MultilevelPreconditioner(const GarmentModel& model, bool with_aggregates);

  /// Number of levels.
  int levels() const { return static_cast<int>(levels_.size()); }
  /// Number of levels of the nested mesh; the others are aggregates.
  int nested_levels() const { return nested_; }

  /// Sets the stiffness of each patch to the mean of the blocks of its nodes, instead of the
  /// isotropic bound. `of_nodes` has one block a node of the model, `isotropic_share` the share of
  /// the isotropic bound that is added to it.
  void set_blocks(const std::vector<StiffnessBlock>& of_nodes,
                  const std::vector<double>& isotropic_share);

  /// Finds the displacements of all patches. `forces` has the force (N) on each node, and the
  /// stiffness (N/m) of its contacts as the fourth component. `bending` is a factor on the bending
  /// stiffness. Linear in the nodes.
  void compute(const Vec4s& forces, double bending);
  /// Metres: the displacement that compute() found for node n.
  [[gnu::always_inline]] Vec4 of_node(std::size_t n) const {
    if (levels_.empty()) return Vec4{};
    return between_parents(levels_.front(), n);
  }
  /// m/s²: root mean square acceleration of the patches of the nested mesh's coarsest level, by the
  /// forces of the last compute(). 0 without levels. Forces of neighbours on each other cancel; the
  /// rest sets the cloth in motion as a whole.
  double rms_acceleration() const;

 private:
  struct Share {
    int node;
    double weight;
  };
  struct Level {
    std::vector<std::array<int, 2>>
        parents;                        // per finer node; twice the same for a node of this level
    Adjacency<AggregateShare> patches;  // per finer node; of a level of aggregates, without parents
    Adjacency<Share> shares;            // per node, its finer nodes
    std::vector<double> stretch;        // N/m, per node: isotropic bounds
    std::vector<StiffnessBlock> blocks;   // N/m, per node
    std::vector<double> isotropic_share;  // per node, mean over its finer nodes
    std::vector<double> bend;             // N/m, per node
    std::vector<double> mass;             // kg, per node
    Vec4s force;                          // N, per node; stiffness of contacts (N/m) as the fourth
    Vec4s displacement;                   // metres, per node
  };
  [[gnu::always_inline]] static Vec4 between_parents(const Level& level, std::size_t finer) {
    const auto& [a, b] = level.parents[finer];
    return 0.5 * (level.displacement[a] + level.displacement[b]);
  }
  std::vector<Triangle> add_nested_levels(const GarmentModel& model);
  void add_aggregate_level(const Aggregates& aggregates);
  void add_level(Level level);
  static Vec4 displacement_at(const Level& level, std::size_t finer);
  static void restrict_forces(std::size_t begin, std::size_t end, const Vec4s& finer, Level& level);
  static void displace(std::size_t begin, std::size_t end, double bending, const Level* coarser,
                       Level& level);

  int nested_ = 0;
  std::vector<Level> levels_;  // from fine to coarse
};

}  // namespace toile
