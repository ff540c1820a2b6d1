#include "cloth/relaxation/multilevel_preconditioner.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cloth/relaxation/constants.h"
#include "geometry/parallel.h"

namespace toile {

MultilevelPreconditioner::MultilevelPreconditioner(const GarmentModel& model,
                                                   bool with_aggregates) {
  const std::vector<Triangle> coarsest = add_nested_levels(model);
  if (levels_.empty()) return;
  nested_ = levels();
  if (!with_aggregates) return;
  Neighbours joined = neighbours_of(coarsest, levels_.back().mass.size());
  for (int i = 0; i < max_aggregate_levels; ++i) {
    Aggregates aggregates = aggregate(joined);
    if (static_cast<int>(aggregates.middles.size()) < min_aggregates) break;
    add_aggregate_level(aggregates);
    joined = std::move(aggregates.neighbours);
  }
}

/// Adds a level for each nested mesh. Returns the triangles of the coarsest one.
std::vector<Triangle> MultilevelPreconditioner::add_nested_levels(const GarmentModel& model) {
  std::vector<Triangle> triangles = model.node_triangles;
  std::vector<int> own(model.nodes);  // per node of the level, the node of the model
  std::iota(own.begin(), own.end(), 0);
  for (int depth = 0; depth < model.subdivisions; ++depth) {
    const std::size_t count = own.size();
    // Child i of a triangle holds its corner i; child 3 the middles of its sides.
    std::vector<int> index(count, -1);
    for (std::size_t t = 0; t < triangles.size(); t += 4) {
      for (int i = 0; i < 3; ++i) index[triangles[t + i][i]] = 0;
    }
    Level level;
    std::vector<int> coarse_own;
    for (std::size_t n = 0; n < count; ++n) {
      if (index[n] < 0) continue;
      index[n] = static_cast<int>(coarse_own.size());
      coarse_own.push_back(own[n]);
    }
    level.parents.assign(count, {-1, -1});
    std::vector<Triangle> coarse(triangles.size() / 4);
    for (std::size_t t = 0; t < coarse.size(); ++t) {
      for (int i = 0; i < 3; ++i) coarse[t][i] = index[triangles[4 * t + i][i]];
      for (int i = 0; i < 3; ++i) {
        level.parents[triangles[4 * t + i][i]] = {coarse[t][i], coarse[t][i]};
        auto& middle = level.parents[triangles[4 * t + 3][i]];
        if (middle[0] < 0) middle = {coarse[t][i], coarse[t][(i + 1) % 3]};
      }
    }
    level.shares = Adjacency<Share>(coarse_own.size(), [&](const auto& add) {
      for (std::size_t n = 0; n < count; ++n) {
        const auto& [a, b] = level.parents[n];
        add(a, {static_cast<int>(n), a == b ? 1.0 : 0.5});
        if (a != b) add(b, {static_cast<int>(n), 0.5});
      }
    });
    for (const int n : coarse_own) {
      level.stretch.push_back(model.stretch_diagonal[n]);
      level.bend.push_back(model.bend.empty() ? 0 : model.bend_diagonal[n]);
    }
    const std::vector<double>& finer = levels_.empty() ? model.mass : levels_.back().mass;
    level.mass.assign(coarse_own.size(), 0);
    for (std::size_t n = 0; n < coarse_own.size(); ++n) {
      for (const auto& [node, weight] : level.shares[n]) level.mass[n] += weight * finer[node];
    }
    add_level(std::move(level));
    triangles = std::move(coarse);
    own = std::move(coarse_own);
  }
  return triangles;
}

void MultilevelPreconditioner::add_aggregate_level(const Aggregates& aggregates) {
  const Level& finer = levels_.back();
  Level level;
  level.patches = aggregates.of_vertices;
  level.shares.assign(aggregates.middles.size(), [&](const auto& add) {
    for (std::size_t n = 0; n < aggregates.of_vertices.size(); ++n) {
      for (const auto& [patch, weight] : aggregates.of_vertices[n]) {
        add(patch, {static_cast<int>(n), weight});
      }
    }
  });
  for (std::size_t p = 0; p < aggregates.middles.size(); ++p) {
    level.stretch.push_back(finer.stretch[aggregates.middles[p]]);
    level.bend.push_back(finer.bend[aggregates.middles[p]]);
    level.mass.push_back(0);
    for (const auto& [node, weight] : level.shares[p]) level.mass[p] += weight * finer.mass[node];
  }
  add_level(std::move(level));
}

void MultilevelPreconditioner::add_level(Level level) {
  const std::size_t patches = level.mass.size();
  level.blocks.assign(patches, StiffnessBlock{});
  level.isotropic_share.assign(patches, 1);
  level.force.assign(patches, Vec4{});
  level.displacement.assign(patches, Vec4{});
  levels_.push_back(std::move(level));
}

/// Finds the forces on patches `begin` to `end` of a level.
TOILE_CLONES
void MultilevelPreconditioner::restrict_forces(std::size_t begin, std::size_t end,
                                               const Vec4s& finer, Level& level) {
  for (std::size_t n = begin; n < end; ++n) {
    Vec4 sum = {0, 0, 0, 0};
    for (const auto& [node, weight] : level.shares[n]) sum += weight * finer[node];
    level.force[n] = sum;
  }
}

void MultilevelPreconditioner::set_blocks(const std::vector<StiffnessBlock>& of_nodes,
                                          const std::vector<double>& isotropic_share) {
  const std::vector<StiffnessBlock>* finer = &of_nodes;
  const std::vector<double>* finer_share = &isotropic_share;
  for (Level& level : levels_) {
    parallel_for_chunks(level.blocks.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        StiffnessBlock sum{};
        double weight = 0;
        double isotropic = 0;
        for (const Share& share : level.shares[n]) {
          weight += share.weight;
          isotropic += share.weight * (*finer_share)[share.node];
          for (std::size_t k = 0; k < sum.size(); ++k) {
            sum[k] += share.weight * (*finer)[share.node][k];
          }
        }
        for (double& k : sum) k /= weight;
        level.blocks[n] = sum;
        level.isotropic_share[n] = isotropic / weight;
      }
    });
    finer = &level.blocks;
    finer_share = &level.isotropic_share;
  }
}

double MultilevelPreconditioner::rms_acceleration() const {
  if (nested_ == 0 || levels_[nested_ - 1].mass.empty()) return 0;
  const Level& level = levels_[nested_ - 1];
  double sum = 0;
  for (std::size_t n = 0; n < level.mass.size(); ++n) {
    const Vec4 force = {level.force[n][0], level.force[n][1], level.force[n][2], 0};
    if (level.mass[n] > 0) sum += squared_length(force) / (level.mass[n] * level.mass[n]);
  }
  return std::sqrt(sum / static_cast<double>(level.mass.size()));
}

/// The displacement of a level's patches at a finer node.
[[gnu::always_inline]] inline Vec4 MultilevelPreconditioner::displacement_at(const Level& level,
                                                                             std::size_t finer) {
  if (level.patches.empty()) return between_parents(level, finer);
  Vec4 displacement = {0, 0, 0, 0};
  for (const auto& [patch, weight] : level.patches[finer])
    displacement += weight * level.displacement[patch];
  return displacement;
}

/// Finds the displacements of patches `begin` to `end` of a level, with those of the coarser ones.
TOILE_CLONES
void MultilevelPreconditioner::displace(std::size_t begin, std::size_t end, double bending,
                                        const Level* coarser, Level& level) {
  for (std::size_t n = begin; n < end; ++n) {
    const double stiffness =
        std::min(1.0, isotropic_share_of_patches * level.isotropic_share[n]) * level.stretch[n] +
        bending * level.bend[n] + level.force[n][3];
    Vec4 displacement = solve_block(level.blocks[n], stiffness, level.force[n]);
    if (coarser != nullptr) displacement += displacement_at(*coarser, n);
    level.displacement[n] = displacement;
  }
}

void MultilevelPreconditioner::compute(const Vec4s& forces, double bending) {
  const Vec4s* finer = &forces;
  for (Level& level : levels_) {
    parallel_for_chunks(level.force.size(), [&](std::size_t begin, std::size_t end) {
      restrict_forces(begin, end, *finer, level);
    });
    finer = &level.force;
  }
  for (std::size_t l = levels_.size(); l-- > 0;) {
    const Level* const coarser = l + 1 < levels_.size() ? &levels_[l + 1] : nullptr;
    parallel_for_chunks(levels_[l].displacement.size(), [&](std::size_t begin, std::size_t end) {
      displace(begin, end, bending, coarser, levels_[l]);
    });
  }
}

}  // namespace toile
