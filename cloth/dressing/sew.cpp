#include "cloth/dressing/sew.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "cloth/dressing/constants.h"
#include "cloth/dressing/stages.h"
#include "cloth/scene/collider.h"
#include "cloth/start/panel_parts.h"
#include "geometry/body/bones.h"
#include "geometry/body/raise_arms.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

/// A body with its arms out of the way, and a scene around it.
struct RaisedScene {
  RaisedScene(const Scene& standing, const ArmRaise& raise)
      : RaisedScene(standing, raise, raise.raised(standing.collider->body())) {}
  RaisedScene(const Scene& standing, const ArmRaise& raise, const TriangleMesh& body)
      : collider(body, standing.raised_distances != nullptr ? standing.raised_distances->known(body)
                                                            : DistanceCache()),
        skeleton(raise.raised(*standing.skeleton)),
        scene(standing) {
    scene.collider = &collider;
    scene.skeleton = &skeleton;
  }

  const Collider collider;
  const Skeleton skeleton;
  Scene scene;
};

/// Whether a panel stands before or behind an arm, or near it.
bool arms_are_in_the_way(const PanelMesh& garment, const Skeleton& skeleton) {
  const auto flat = [](Vec3 p) {
    p.z() = 0;
    return p;
  };
  for (const BodyPart part : {BodyPart::left_arm, BodyPart::right_arm}) {
    Bones arm(skeleton, part);
    if (arm.joints.empty()) continue;
    for (Vec3& joint : arm.joints) joint = flat(joint);
    // The hand goes on where the bones end.
    arm.joints.push_back(arm.joints.back() +
                         0.2 * (arm.joints.back() - arm.joints.front()).normalized());
    if (std::ranges::any_of(garment.placed,
                            [&](const Vec3& p) { return arm.distance(flat(p)) < arm_clearance; })) {
      return true;
    }
  }
  return false;
}

/// Per panel, whether it hangs down below the pelvis, as a skirt's.
std::vector<bool> hang_below_pelvis(const PanelMesh& garment, const Skeleton& skeleton) {
  std::vector<bool> hang(garment.panels.size(), false);
  const auto pelvis = skeleton.joints.find("pelvis");
  if (pelvis == skeleton.joints.end()) return hang;
  const std::vector<int> panel_of = panel_of_points(garment);
  for (std::size_t p = 0; p < garment.placed.size(); ++p) {
    if (garment.placed[p].y() < pelvis->second.y()) hang[panel_of[p]] = true;
  }
  return hang;
}

/// Radians above the horizontal at which raised arms are above all of a skirt. The upper corners of
/// a wide one's panels may stand above the shoulders.
double raised_angle(const PanelMesh& garment, const Skeleton& skeleton) {
  const std::vector<BodyPart> parts = panel_parts(garment, skeleton);
  const std::vector<int> panel_of = panel_of_points(garment);
  const std::vector<bool> hangs = hang_below_pelvis(garment, skeleton);
  double angle = ArmRaise::usual_angle;
  for (const BodyPart part : {BodyPart::left_arm, BodyPart::right_arm}) {
    const double side = side_of(part);
    const Bones arm(skeleton, part);
    if (arm.joints.empty()) continue;
    const Vec3 shoulder = arm.joints.front();
    const double reach = arm_reach * (arm.joints.back() - shoulder).norm();
    for (std::size_t p = 0; p < garment.placed.size(); ++p) {
      if (!hangs[panel_of[p]] || is_arm(parts[panel_of[p]])) continue;
      const Vec3 away = garment.placed[p] - shoulder;
      const double across = side * away.x();
      if (across < min_wing || std::hypot(across, away.y()) > reach) continue;
      angle = std::max(angle, std::atan2(away.y(), across) + wing_room);
    }
  }
  return std::min(angle, ArmRaise::max_angle);
}

std::optional<ArmRaise> arm_raise(const PanelMesh& garment, const Scene& scene) {
  if (scene.skeleton == nullptr || has_layers(scene) || !touches_body(scene)) return std::nullopt;
  if (garment.seams.empty() || !arms_are_in_the_way(garment, *scene.skeleton)) return std::nullopt;
  ArmRaise raise(*scene.skeleton, scene.collider->body(), raised_angle(garment, *scene.skeleton));
  return raise.any() ? std::optional(std::move(raise)) : std::nullopt;
}

/// The garment with its sleeves turned up with the arms.
PanelMesh with_sleeves_raised(PanelMesh garment, const Skeleton& skeleton, const ArmRaise& raise) {
  const std::vector<BodyPart> parts = panel_parts(garment, skeleton);
  const std::vector<int> panel_of = panel_of_points(garment);
  for (std::size_t p = 0; p < garment.placed.size(); ++p) {
    garment.placed[p] = raise.turned_with(parts[panel_of[p]], garment.placed[p]);
  }
  return garment;
}

std::vector<Vec3> lowered(const ArmRaise& raise, std::vector<Vec3> nodes) {
  for (Vec3& p : nodes) p = raise.lowered(p);
  return nodes;
}

/// Whether the arms would come down into the cloth, as into a wide skirt that stands out.
bool is_in_the_way(const Level& level, const std::vector<Vec3>& nodes, const ArmRaise& raise) {
  State state;
  state.nodes = lowered(raise, nodes);
  return count_body_intersections(level, state) > 0;
}

/// Closes the seams from where the panels start, and lets the cloth come clear of itself.
Staged close_and_untangle(const Level& level, const Closing& closing, Journal& journal) {
  State state;
  state.nodes = level.model.start;
  Staged staged = close_seams(level, std::move(state), closing, journal);
  return untangle(level, std::move(staged.state), closing, journal);
}

}  // namespace

Sewn sew(const PanelMesh& mesh, int depth, const Scene& scene, double resting_offset, bool once,
         Journal& journal) {
  const std::optional<ArmRaise> raise = arm_raise(mesh, scene);
  std::optional<RaisedScene> raised;
  if (raise) raised.emplace(scene, *raise);
  PanelMesh turned;
  if (raise) turned = with_sleeves_raised(mesh, *scene.skeleton, *raise);
  if (raise) journal.show_through([&](const Vec3& p) { return raise->lowered(p); });
  Positioned positioned = position(raise ? turned : mesh, depth, raised ? raised->scene : scene,
                                   resting_offset, journal);
  Sewn sewn;
  sewn.placement = std::move(positioned.placement);
  sewn.level = std::move(positioned.level);
  if (mesh.seams.empty()) {
    sewn.state.nodes = sewn.level.model.start;
    sewn.is_clear = is_clear_of_itself(sewn.level, sewn.state);
    return sewn;
  }
  Level standing;
  if (raise) {
    for (Vec3& p : sewn.placement.placed) p = raise->lowered(p);
    standing =
        compiled_level(mesh, depth, closing_scene(scene), sewn.placement.placed, resting_offset);
  }
  int attempt = journal.attempt();
  for (const Closing& closing : closing_attempts) {
    // Stiffer cloth helps where it came out tangled, larger cloth where it crosses the body.
    if (closing.size > 1 ? !sewn.crosses_body : sewn.is_clear) continue;
    journal.begin_attempt(attempt++);
    if (raise) journal.show_through([&](const Vec3& p) { return raise->lowered(p); });
    const Level large = enlarged(sewn.level, closing.size);
    Staged staged = close_and_untangle(large, closing, journal);
    // A tangle that falls only gets worse.
    if (raise && staged.report.converged && is_in_the_way(standing, staged.state.nodes, *raise)) {
      staged = settle(large, std::move(staged.state), true, true, journal);
    }
    journal.show_through({});
    if (raise) {
      staged.state.nodes = lowered(*raise, std::move(staged.state.nodes));
      staged.state.warm_start = {};  // friction held it on the raised body
      staged =
          untangle(enlarged(standing, closing.size), std::move(staged.state), closing, journal);
    }
    const Level& worn = raise ? standing : sewn.level;
    if (staged.report.converged) staged = shrink(worn, std::move(staged), closing, journal);
    sewn.is_clear = staged.report.converged;
    sewn.state = std::move(staged.state);
    sewn.crosses_body = count_body_intersections(worn, sewn.state) > 0;
    if (once || sewn.level.model.nodes > max_resewn_nodes) break;
  }
  if (raised && scene.raised_distances != nullptr) scene.raised_distances->keep(raised->collider);
  if (raise) sewn.level = std::move(standing);
  return sewn;
}

}  // namespace toile
