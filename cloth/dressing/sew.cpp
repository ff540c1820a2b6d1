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
  return !body_intersections(level, state).empty();
}

/// A mesh as its seams close and as the garment is then worn, with its arms down.
struct SewingLevels {
  Level closing;  ///< compiled for closing_scene(), with the arms raised if any are
  Level worn;     ///< the same around the body as it stands
};

/// Sews one garment; see sew().
class Sewing {
 public:
  Sewing(const PanelMesh& mesh, int depth, const Scene& scene, double resting_offset,
         Journal& journal)
      : mesh_(mesh),
        depth_(depth),
        scene_(scene),
        resting_offset_(resting_offset),
        journal_(journal),
        attempt_(journal.attempt()),
        raise_(arm_raise(mesh, scene)) {
    if (raise_) raised_.emplace(scene, *raise_);
  }

  Sewn run(bool once) {
    PanelMesh turned;
    if (raise_) turned = with_sleeves_raised(mesh_, *scene_.skeleton, *raise_);
    if (raise_) journal_.show_through([&](const Vec3& p) { return raise_->lowered(p); });
    Positioned positioned =
        position(raise_ ? turned : mesh_, depth_, around(), resting_offset_, journal_);
    sewn_.placement = std::move(positioned.placement);
    if (mesh_.seams.empty()) {
      sewn_.state.nodes = positioned.level.model.start;
      sewn_.is_clear = is_clear_of_itself(positioned.level, sewn_.state);
      return std::move(sewn_);
    }
    starts_at_ = sewn_.placement.placed;
    if (raise_) sewn_.placement.placed = lowered(*raise_, starts_at_);
    Level worn = raise_ ? worn_level(mesh_) : positioned.level;
    close_in_some_way({std::move(positioned.level), std::move(worn)}, once);
    if (raised_ && scene_.raised_distances != nullptr) {
      scene_.raised_distances->keep(raised_->collider);
    }
    return std::move(sewn_);
  }

 private:
  /// The scene in which seams close.
  const Scene& around() const { return raise_ ? raised_->scene : scene_; }

  Level closing_level(const PanelMesh& mesh, const std::vector<Vec3>& starts_at) const {
    return compiled_level(mesh, depth_, closing_scene(around()), starts_at, resting_offset_);
  }

  Level worn_level(const PanelMesh& mesh) const {
    return compiled_level(mesh, depth_, closing_scene(scene_), sewn_.placement.placed,
                          resting_offset_);
  }

  void close_in_some_way(const SewingLevels& levels, bool once) {
    HeldApart held{{}, starts_at_, {}};
    bool is_first = true;
    for (const Closing& closing : closing_attempts) {
      begin_attempt();
      Staged closed = close(levels.closing, closing, {});
      if (held.seams.open.empty()) held.seams = std::move(closed.held);
      take(worn_after(levels, std::move(closed), closing.pull, {}));
      if (once) return;
      if (levels.closing.model.nodes > max_resewn_nodes) break;
      if (is_first && sewn_.crosses_body) close_widened(levels, held);
      is_first = false;
      if (sewn_.is_clear) break;
    }
    // Fewer crossings come out while the garment settles.
    if (body_crossings_ > max_hopeful_intersections && !held.seams.open.empty()) {
      leave_seams_open(held);
    }
  }

  void begin_attempt() {
    journal_.begin_attempt(attempt_++);
    if (raise_) journal_.show_through([&](const Vec3& p) { return raise_->lowered(p); });
  }

  Staged close(const Level& level, const Closing& closing, const Widening& wide) {
    State start;
    start.nodes = level.model.start;
    return close_seams(widened(level, wide), std::move(start), closing,
                       mesh_.edge_length <= sewing_edge, journal_);
  }

  /// Where seams stood when they did not close any more, of panels that had started so.
  struct HeldApart {
    HeldSeams seams;              ///< empty: all closed
    std::vector<Vec3> starts_at;  ///< metres, per material point
    Widening wide;
  };

  /// A garment whose seams are closed, with the arms down.
  struct Closed {
    State state;
    bool is_clear = false;           ///< of itself
    std::vector<char> cuts;          ///< per panel, not 0 where it crosses the body
    std::size_t body_crossings = 0;  ///< pairs of triangles
  };

  /// Sews with those panels wider whose seams the body held apart, or that cross it although their
  /// seams closed. `held` is then the attempt that left the fewest seams open.
  void close_widened(const SewingLevels& levels, HeldApart& held) {
    if (around().skeleton == nullptr) return;
    const std::vector<int> panel_of = panel_of_points(mesh_);
    std::vector<WidePanel> panels;
    std::vector<char> open = held_points(levels.closing.model, held.seams);
    auto fewest = std::ranges::count(open, 1);
    std::vector<char> cuts = cuts_;
    for (int i = 0; i < wide_attempts; ++i) {
      // A tight sleeve closes around a slim arm, which cuts into it as it comes down.
      if (std::ranges::count(open, 1) == 0) {
        for (std::size_t p = 0; p < open.size(); ++p) open[p] = cuts[panel_of[p]];
      }
      if (!widen(mesh_, starts_at_, *around().skeleton, open, widening, panels)) break;
      HeldApart trial{{}, starts_at_, widening_of(levels.closing, panels)};
      for (std::size_t p = 0; p < trial.starts_at.size(); ++p) {
        trial.starts_at[p] = panels[panel_of[p]].moved(trial.starts_at[p]);
      }
      const SewingLevels widely = {closing_level(mesh_, trial.starts_at), levels.worn};
      begin_attempt();
      Closing closing = closing_attempts.front();
      closing.through_body = false;
      Staged closed = close(widely.closing, closing, trial.wide);
      trial.seams = std::move(closed.held);
      open = held_points(widely.closing.model, {closed.state.nodes, closed.open});
      cuts.assign(cuts.size(), 0);
      if (closed.report.converged) {
        Closed worn = worn_after(widely, std::move(closed), closing.pull, trial.wide);
        cuts = worn.cuts;
        // What is tangled has not shrunk.
        const bool is_done = worn.is_clear && worn.body_crossings == 0;
        if (worn.is_clear) take_if_better(std::move(worn));
        if (is_done) break;
      }
      const auto count = std::ranges::count(held_points(widely.closing.model, trial.seams), 1);
      if (count == 0 || count >= fewest) continue;
      fewest = count;
      held = std::move(trial);
    }
    journal_.show_through({});
  }

  /// Lets cloth whose seams are closed come clear of itself, and takes it down with the arms.
  Closed worn_after(const SewingLevels& levels, Staged staged, double pull, const Widening& wide) {
    const Level large = widened(levels.closing, wide);
    staged = untangle(large, std::move(staged.state), pull, journal_);
    // A tangle that falls only gets worse.
    if (raise_ && staged.report.converged &&
        is_in_the_way(levels.worn, staged.state.nodes, *raise_)) {
      staged = settle(large, std::move(staged.state), true, true, journal_);
    }
    journal_.show_through({});
    if (raise_) {
      staged.state.nodes = lowered(*raise_, std::move(staged.state.nodes));
      staged.state.warm_start = {};  // friction held it on the raised body
      staged = untangle(widened(levels.worn, wide), std::move(staged.state), pull, journal_);
    }
    if (staged.report.converged) {
      staged = shrink(levels.worn, std::move(staged), wide, pull, journal_);
    }
    Closed closed{std::move(staged.state), staged.report.converged, {}, 0};
    closed.cuts.assign(mesh_.panels.size(), 0);
    const std::vector<int> panel_of = panel_of_triangles(mesh_);
    for (const TrianglePair& pair : body_intersections(levels.worn, closed.state)) {
      closed.cuts[panel_of[pair[0]]] = 1;
      ++closed.body_crossings;
    }
    return closed;
  }

  void take(Closed closed) {
    sewn_.state = std::move(closed.state);
    sewn_.is_clear = closed.is_clear;
    sewn_.crosses_body = closed.body_crossings > 0;
    body_crossings_ = closed.body_crossings;
    cuts_ = std::move(closed.cuts);
  }

  /// The same, where it crosses less of the body.
  bool take_if_better(Closed closed) {
    if (closed.body_crossings >= body_crossings_) return false;
    take(std::move(closed));
    return true;
  }

  /// Per material point, whether the sides of its seams stood apart.
  std::vector<char> held_points(const GarmentModel& model, const HeldSeams& held) const {
    if (held.open.empty()) return std::vector<char>(model.node_of_point.size(), 0);
    const std::vector<Vec3> points = point_positions(model, held.nodes, held.open);
    // Where several seams meet in one node, they open together.
    std::vector<char> is_open(model.nodes, 0);
    for (const MeshedSeam& seam : mesh_.seams) {
      for (std::size_t i = 0; i < seam.a.size(); ++i) {
        if (points[seam.a[i]] != points[seam.b[i]]) is_open[model.node_of_point[seam.a[i]]] = 1;
      }
    }
    std::vector<char> are_open;
    are_open.reserve(points.size());
    for (const int node : model.node_of_point) are_open.push_back(is_open[node]);
    return are_open;
  }

  /// Goes on from seams that were held apart, with those open, where that crosses less of the body.
  void leave_seams_open(const HeldApart& held) {
    const GarmentModel whole = closing_level(mesh_, held.starts_at).model;
    PanelMesh open = mesh_;
    open.unsewn = held_points(whole, held.seams);
    const SewingLevels levels = {closing_level(open, held.starts_at), worn_level(open)};
    const std::vector<Vec3> points = point_positions(whole, held.seams.nodes, held.seams.open);
    State state;
    state.nodes.resize(levels.closing.model.nodes);
    for (std::size_t p = 0; p < points.size(); ++p) {
      state.nodes[levels.closing.model.node_of_point[p]] = points[p];
    }
    begin_attempt();
    if (take_if_better(worn_after(levels, {std::move(state), {}}, closing_pull, held.wide))) {
      sewn_.unsewn = std::move(open.unsewn);
    }
  }

  const PanelMesh& mesh_;
  int depth_;
  const Scene& scene_;
  double resting_offset_;
  Journal& journal_;
  int attempt_;
  std::optional<ArmRaise> raise_;
  std::optional<RaisedScene> raised_;
  std::vector<Vec3> starts_at_;  // metres, per material point, with the arms raised
  Sewn sewn_;
  std::size_t body_crossings_ = 0;  // of sewn_, as the next
  std::vector<char> cuts_;
};

}  // namespace

Sewn sew(const PanelMesh& mesh, int depth, const Scene& scene, double resting_offset, bool once,
         Journal& journal) {
  return Sewing(mesh, depth, scene, resting_offset, journal).run(once);
}

}  // namespace toile
