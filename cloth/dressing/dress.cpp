#include "cloth/dressing/dress.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "cloth/dressing/carry_drape.h"
#include "cloth/dressing/constants.h"
#include "cloth/dressing/follow_body.h"
#include "cloth/dressing/level.h"
#include "cloth/dressing/sew.h"
#include "cloth/dressing/stability_test.h"
#include "cloth/dressing/stages.h"
#include "cloth/judge/wear_check.h"
#include "cloth/model/nested_meshes.h"
#include "cloth/relaxation/release.h"
#include "cloth/scene/collider.h"
#include "cloth/scene/standing_body.h"
#include "cloth/start/positioning.h"
#include "geometry/error.h"
#include "geometry/intersections.h"
#include "pattern/constants.h"

namespace toile {

namespace {

/// Whether the garment is worn where it belongs, as far as a skeleton tells.
bool is_in_place(const Level& level, const State& state) {
  const Scene& scene = level.model.scene;
  if (scene.skeleton == nullptr) return true;
  PanelMesh garment = *level.mesh;
  garment.placed = level.placed;
  const DressedGarment dressed = as_dressed(garment, state.nodes, level.model.node_triangles);
  return !check_worn(garment, dressed, *scene.skeleton).misplaced;
}

/// Settles on the coarsest mesh. What slides off without friction, and stays with it, has it from
/// here on: then `friction` is set.
State first_settled(const Level& level, const State& sewn, bool bounded, bool& friction,
                    Journal& journal) {
  State slid = settle(level, sewn, bounded, false, journal).state;
  const bool fell = fallen(level, slid, sewn.nodes) > slid_off_fall;
  if (!fell && is_in_place(level, slid)) return slid;
  State held = settle(level, {sewn.nodes, slid.warm_start, {}}, bounded, true, journal).state;
  friction = fell ? fallen(level, held, sewn.nodes) <= slid_off_fall : is_in_place(level, held);
  return friction ? held : slid;
}

/// A garment that is sewn, and has settled on its coarsest mesh.
struct SettledGarment {
  std::vector<PanelMesh> meshes;  // the finest first
  Placement placement;            // of the coarsest
  Level level;
  State state;
  bool was_held_apart = false;
  bool is_clear = false;
  bool is_in_place = false;
  bool friction = false;
};

/// Sews the garment on the last of its meshes. One that is coarser than seams need closes them in a
/// fraction of the time. What does not come out of it clear is sewn on the next finer mesh instead,
/// and `meshes` end there.
Sewn sew_on_coarsest(std::vector<PanelMesh>& meshes, const Scene& scene, double resting_offset,
                     Journal& journal) {
  const auto sewn_on_last = [&](bool once) {
    const int depth = static_cast<int>(meshes.size()) - 1;
    return sew(meshes.back(), depth, scene, resting_offset, once, journal);
  };
  const bool is_very_coarse =
      meshes.size() > 2 && meshes.back().edge_length > sewing_edge &&
      static_cast<double>(meshes[meshes.size() - 2].triangles.size()) < max_coarsest_triangles;
  if (!is_very_coarse) return sewn_on_last(false);
  Sewn quick = sewn_on_last(true);
  if (quick.is_clear && !quick.crosses_body) return quick;
  meshes.pop_back();
  for (PanelMesh& mesh : meshes) --mesh.subdivisions;
  journal.begin_attempt(journal.attempt() + 1);
  return sewn_on_last(false);
}

SettledGarment sew_and_settle(const PanelMesh& garment, const Scene& scene, double resting_offset,
                              Journal& journal) {
  SettledGarment settled;
  settled.meshes = nested_meshes(garment);
  Sewn sewn = sew_on_coarsest(settled.meshes, scene, resting_offset, journal);
  const PanelMesh& coarsest = settled.meshes.back();
  const int depth = static_cast<int>(settled.meshes.size()) - 1;
  settled.placement = std::move(sewn.placement);
  settled.was_held_apart = sewn.crosses_body || !sewn.unsewn.empty();
  if (!sewn.unsewn.empty()) leave_open(settled.meshes, std::move(sewn.unsewn));
  settled.level = compiled_level(coarsest, depth, scene, settled.placement.placed, resting_offset);
  sewn.state = lifted(settled.level, std::move(sewn.state), sewn.is_clear, journal);
  settled.state =
      first_settled(settled.level, sewn.state, sewn.is_clear, settled.friction, journal);
  settled.is_clear = sewn.is_clear || is_clear_of_itself(settled.level, settled.state);
  settled.is_in_place = is_in_place(settled.level, settled.state);
  return settled;
}

/// Sews the garment around the body, as it stood if the scene has it, and takes it into the pose.
/// What is tangled is lost, and comes there at once.
SettledGarment put_on(const PanelMesh& garment, const Scene& scene, double resting_offset,
                      Journal& journal) {
  SettledGarment worn = sew_and_settle(garment, standing_scene(scene), resting_offset, journal);
  if (scene.standing == nullptr) return worn;
  if (worn.is_clear) {
    worn.is_clear = follow_body(worn.level, worn.state, scene, resting_offset, worn.is_clear,
                                worn.friction, journal);
    worn.state = first_settled(worn.level, worn.state, worn.is_clear, worn.friction, journal);
  } else {
    take_along(worn.level, worn.state, scene, resting_offset);
  }
  worn.placement.placed = worn.level.placed;
  worn.is_in_place = is_in_place(worn.level, worn.state);
  return worn;
}

bool has_temporary_attachments(const Level& level) {
  return lasting(level.model.attachments).size() < level.model.attachments.size();
}

/// What attachments held on the way is measured, and from here on held by friction; what is
/// attached for good stays so.
void detach(Level& level, const State& state, std::vector<AttachmentMeasurement>& measured) {
  if (level.model.attachments.empty() || !measured.empty()) return;
  measured = measure_attachments(*level.mesh, level.model.attachments, points_of(level, state));
  level.model.attachments = lasting(std::move(level.model.attachments));
}

/// Brings the finest mesh to rest, released from what holds it while it is dressed.
Staged come_to_rest(Level& level, State state, bool bounded, const DressOptions& options,
                    std::vector<AttachmentMeasurement>& attachments, Journal& journal) {
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

/// Where pattern and skeleton put the garment's points, metres, found on the coarsest mesh.
std::vector<Vec3> positioned_points(const std::vector<PanelMesh>& meshes, const Scene& scene) {
  std::vector<Vec3> points =
      position_panels(meshes.back(), scene.collider->grid(), scene.skeleton).placed;
  for (std::size_t depth = meshes.size() - 1; depth > 0; --depth) {
    points = refine_placed(meshes[depth], points, meshes[depth - 1]);
  }
  return points;
}

/// Takes the last state of the finest mesh.
void take_end(const PanelMesh& garment, const Level& level, State state, const Journal& journal,
              DressResult& result) {
  measure_lasting(garment, level.model.attachments, points_of(level, state), result.attachments);
  result.attached = level.model.attachments;
  result.terms = term_counts(level.model);
  result.triangles = level.model.node_triangles;
  result.tight_seams = tight_seams(garment, level.model, state.nodes, state.warm_start.multipliers);
  if (level.model.scene.strain_limit) {
    result.tight_regions =
        tight_regions(garment, points_of(level, state), *level.model.scene.strain_limit,
                      state.warm_start.multipliers);
  }
  result.nodes = std::move(state.nodes);
  result.warm_start = std::move(state.warm_start);
  result.extra_offset = std::move(state.extra_offset);
  result.stages = journal.stages();
  result.during = journal.during();
}

void check_body(const Scene& scene) {
  if (scene.collider == nullptr) throw Error("scene", "has no body", "give one to dress");
}

}  // namespace

DressResult dress(const PanelMesh& garment, const Scene& scene, const DressOptions& options,
                  const FrameWatcher& watcher) {
  check_body(scene);
  Journal journal(watcher);
  DressResult result;
  result.body_offset = resting_offset(garment, scene);

  SettledGarment settled = put_on(garment, scene, result.body_offset, journal);
  // What was sewn tangled, or was held apart by the body, did not slip.
  if (!settled.is_in_place && settled.is_clear && !settled.was_held_apart) {
    if (const std::optional<PanelMesh> held = hold_what_slips(garment)) {
      journal.begin_attempt(journal.attempt() + 1);
      SettledGarment anew = put_on(*held, scene, result.body_offset, journal);
      if (anew.is_in_place && anew.is_clear && !anew.was_held_apart) settled = std::move(anew);
    }
  }
  const std::vector<PanelMesh>& meshes = settled.meshes;
  Level& level = settled.level;
  State& state = settled.state;
  bool& is_clear = settled.is_clear;
  result.placement = std::move(settled.placement);
  for (std::size_t depth = meshes.size() - 1; depth > 0; --depth) {
    result.placement.initial =
        refine_placed(meshes[depth], result.placement.initial, meshes[depth - 1]);
  }
  const bool is_tangled =
      (!is_clear && count_self_intersections(level, state) > max_hopeful_intersections) ||
      (settled.was_held_apart &&
       body_intersections(level, state).size() > max_hopeful_intersections);
  const auto is_lost = [&] {
    return is_tangled || fallen(level, state, result.placement.placed) > fallen_off_drop;
  };
  while (level.depth > 0) {
    level = finer_level(level, meshes[level.depth - 1], scene, result.body_offset, state);
    if (level.depth == 0) break;
    if (!is_lost()) {
      // Cloth slid into place on the coarsest mesh. Without friction one of two sleeves that are
      // as tight would slip here, and draw the other one up.
      state = settle(level, std::move(state), is_clear, true, journal).state;
    }
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

  take_end(garment, level, std::move(state), journal, result);
  return result;
}

ContinuedDress continue_dress(const PanelMesh& garment, const Scene& scene,
                              const DressOptions& options, const DressedGarment& earlier,
                              const FrameWatcher& watcher) {
  check_body(scene);
  ContinuedDress continued;
  CarriedDrape carried = carry_drape(earlier, garment);
  continued.outside = carried.outside;
  continued.refusal = std::move(carried.refusal);
  if (!continued.refusal.empty()) return continued;
  const std::vector<PanelMesh> meshes = nested_meshes(garment);
  Journal journal(watcher);
  DressResult result;
  result.body_offset = resting_offset(garment, scene);
  result.placement.initial = positioned_points(meshes, scene);
  result.placement.placed = carried.points;
  result.placement.points_inside = points_inside(carried.points, scene.collider->grid());
  Level level = compiled_level(meshes.front(), 0, scene, carried.points, result.body_offset);
  level.model.body_offset = result.body_offset;
  if (!lasting(level.model.attachments).empty()) {
    continued.refusal = "what is attached for good is placed with the panels";
    return continued;
  }
  level.model.attachments.clear();

  State state;
  state.nodes = level.model.start;
  const bool crosses_at_first = !is_clear_of_itself(level, state);
  if (crosses_at_first) {
    Staged untangled = untangle_worn(level, std::move(state), journal);
    if (!untangled.report.converged) {
      continued.refusal = "it can't be drawn apart where it crosses itself at first";
      return continued;
    }
    state = std::move(untangled.state);
  }
  // Cloth that has to go elsewhere gives way to compression first, or it stands on creases.
  const bool stiffens =
      crosses_at_first || std::max(carried.outside, carried.shifted) > min_carried_shift;
  Staged staged = rest(level, std::move(state), true, stiffens, options, journal);
  if (options.release_seconds > 0) {
    result.release = release_for_a_while(level, staged, true, options, journal);
  }
  result.residual = staged.report.residual;
  result.converged = is_at_rest(staged.report, options);
  const TriangleMesh drape{staged.state.nodes, level.model.node_triangles};
  if (!result.converged) {
    continued.refusal = "it does not come to rest from there";
  } else if (!self_intersections(drape).empty()) {
    continued.refusal = "it crosses itself from there";
  } else if (!intersections(drape, scene.collider->body()).empty()) {
    continued.refusal = "it crosses the body from there";
  }
  if (!continued.refusal.empty()) return continued;
  take_end(garment, level, std::move(staged.state), journal, result);
  continued.result = std::move(result);
  return continued;
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
