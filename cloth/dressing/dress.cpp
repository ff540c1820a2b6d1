#include "cloth/dressing/dress.h"

#include <cmath>
#include <optional>
#include <utility>

#include "cloth/dressing/constants.h"
#include "cloth/dressing/level.h"
#include "cloth/dressing/stability_test.h"
#include "cloth/dressing/stages.h"
#include "cloth/model/nested_meshes.h"
#include "cloth/relaxation/release.h"
#include "geometry/error.h"

namespace toile {

namespace {

/// The panels with their seams closed, as far as they close.
struct Sewn {
  Level level;
  State state;
  bool is_clear = false;  ///< of itself
  bool jammed = false;    ///< seams stay far open
  double open = 0;        ///< what is left of the seams' offset
};

Sewn sew(Level level, Journal& journal) {
  Sewn sewn{std::move(level), {}};
  sewn.state.nodes = sewn.level.model.start;
  if (sewn.level.mesh->seams.empty()) {
    sewn.is_clear = is_clear_of_itself(sewn.level, sewn.state);
    return sewn;
  }
  for (int attempt = 0; attempt < max_sewing_attempts && !sewn.is_clear && !sewn.jammed;
       ++attempt) {
    const double care = std::pow(2.0, attempt);
    journal.begin_attempt(attempt + 1);
    sewn.state.nodes = sewn.level.model.start;
    Staged staged = close_seams(sewn.level, std::move(sewn.state), care, journal);
    sewn.open = staged.report.open;
    sewn.jammed = sewn.open > jammed_open;
    if (staged.report.converged) {
      staged = untangle(sewn.level, std::move(staged.state), care, journal);
      sewn.is_clear = staged.report.converged;
    }
    sewn.state = std::move(staged.state);
  }
  return sewn;
}

/// Settles on the coarsest mesh. What slides off without friction, and stays with it, has it from
/// here on: then `friction` is set.
State first_settled(const Level& level, const State& sewn, bool bounded, bool& friction,
                    Journal& journal) {
  State slid = settle(level, sewn, bounded, false, journal).state;
  if (fallen(level, slid, sewn.nodes) <= slid_off_fall) return slid;
  State held = settle(level, {sewn.nodes, slid.warm_start, {}}, bounded, true, journal).state;
  friction = fallen(level, held, sewn.nodes) <= slid_off_fall;
  return friction ? held : slid;
}

bool has_temporary_attachments(const Level& level) {
  return lasting(level.model.attachments).size() < level.model.attachments.size();
}

/// What attachments held on the way is measured, and from here on held by friction; what is
/// attached for good stays so.
void detach(Level& level, const State& state, std::vector<AttachmentFigures>& figures) {
  if (level.model.attachments.empty() || !figures.empty()) return;
  figures = measure_attachments(*level.mesh, level.model.attachments, points_of(level, state));
  level.model.attachments = lasting(std::move(level.model.attachments));
}

/// Brings the finest mesh to rest, released from what holds it while it is dressed.
Staged come_to_rest(Level& level, State state, bool bounded, const DressOptions& options,
                    std::vector<AttachmentFigures>& attachments, Journal& journal) {
  if (!has_temporary_attachments(level)) {
    return rest(level, std::move(state), bounded, true, options, journal);
  }
  state =
      release_attachments(level, std::move(state), bounded, options.max_iterations, journal).state;
  detach(level, state, attachments);
  return rest(level, std::move(state), bounded, false, options, journal);
}

/// Releases a copy of the garment for a while, and brings it to rest anew where it does not stay.
ReleaseReport release_for_a_while(const Level& level, Staged& staged, bool bounded,
                                  const DressOptions& wanted, Journal& journal) {
  ReleaseOptions options;
  options.self_radius = search_radius(level);
  options.bounded = bounded;
  options.layer_contact = is_clear_of_layers(level, staged.state);
  options.seconds = wanted.release_seconds;
  RestingState state = {staged.state.nodes, staged.state.warm_start, staged.report.converged};
  return test_stability(level.model, options, state, [&](RestingState& moved) {
    staged.state.nodes = std::move(moved.nodes);
    staged.state.warm_start = std::move(moved.warm_start);
    staged = rest(level, std::move(staged.state), bounded, false, wanted, journal);
    moved = {staged.state.nodes, staged.state.warm_start, staged.report.converged};
  });
}

/// The garment as far as it came, its seams open, on its own mesh.
DressResult given_up(const Sewn& sewn, const std::vector<PanelMesh>& meshes, DressResult result,
                     const Journal& journal) {
  std::vector<Vec3> points = points_of(sewn.level, sewn.state, sewn.open);
  result.attachments = measure_attachments(*sewn.level.mesh, sewn.level.model.attachments, points);
  for (int depth = sewn.level.depth; depth > 0; --depth) {
    points = refine_points(meshes[depth], points, meshes[depth - 1]);
  }
  result.terms = term_counts(sewn.level.model);
  result.warm_start = sewn.state.warm_start;
  result.extra_offset = sewn.state.extra_offset;
  result.residual = journal.stages().back().residual;
  result.nodes = std::move(points);
  result.triangles = meshes.front().triangles;
  result.stages = journal.stages();
  result.during = journal.during();
  return result;
}

}  // namespace

DressResult dress(const PanelMesh& garment, const Scene& scene, const DressOptions& options,
                  const FrameWatcher& watcher) {
  if (scene.collider == nullptr) throw Error("scene", "has no body", "give one to dress");
  const std::vector<PanelMesh> meshes = nested_meshes(garment);
  const int coarsest = static_cast<int>(meshes.size()) - 1;
  Journal journal(watcher);
  DressResult result;
  result.body_offset = resting_offset(garment, scene);

  Positioned positioned = position(meshes[coarsest], coarsest, scene, result.body_offset, journal);
  result.placement = std::move(positioned.placement);
  for (int depth = coarsest; depth > 0; --depth) {
    result.placement.initial =
        refine_placed(meshes[depth], result.placement.initial, meshes[depth - 1]);
  }
  const Sewn sewn = sew(std::move(positioned.level), journal);
  if (sewn.jammed) return given_up(sewn, meshes, std::move(result), journal);

  Level level = compiled_level(meshes[coarsest], coarsest, scene, result.placement.placed,
                               result.body_offset);
  bool friction = false;
  bool is_clear = sewn.is_clear;
  State state = first_settled(level, sewn.state, is_clear, friction, journal);
  const auto is_lost = [&] {
    return fallen(level, state, result.placement.placed) > fallen_off_drop;
  };
  is_clear = is_clear || is_clear_of_itself(level, state);
  while (level.depth > 0) {
    level = finer_level(level, meshes[level.depth - 1], scene, result.body_offset, state);
    if (level.depth == 0) break;
    if (!is_lost()) state = settle(level, std::move(state), is_clear, friction, journal).state;
    is_clear = is_clear || is_clear_of_itself(level, state);
  }

  level.model.body_offset = result.body_offset;
  if (!is_lost()) {
    Staged staged =
        come_to_rest(level, std::move(state), is_clear, options, result.attachments, journal);
    if (options.release_seconds > 0) {
      result.release = release_for_a_while(level, staged, is_clear, options, journal);
    }
    result.residual = staged.report.residual;
    result.converged = is_at_rest(staged.report, options);
    state = std::move(staged.state);
  }
  detach(level, state, result.attachments);

  measure_lasting(garment, level.model.attachments, points_of(level, state), result.attachments);
  result.attached = level.model.attachments;
  result.terms = term_counts(level.model);
  result.triangles = level.model.node_triangles;
  result.tight_seams = tight_seams(garment, level.model, state.nodes, state.warm_start.multipliers);
  if (scene.strain_limit) {
    result.tight_regions =
        tight_regions(garment, level.model, state.nodes, state.warm_start.multipliers);
  }
  result.nodes = std::move(state.nodes);
  result.warm_start = std::move(state.warm_start);
  result.extra_offset = std::move(state.extra_offset);
  result.stages = journal.stages();
  result.during = journal.during();
  return result;
}

std::vector<Vec3> material_points(const PanelMesh& garment, const DressResult& result) {
  std::vector<Vec3> points(garment.flat.size(), Vec3::Zero());
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      points[garment.triangles[t][i]] = result.nodes[result.triangles[t][i]];
    }
  }
  return points;
}

}  // namespace toile
