#include "cloth/dressing/follow_body.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "cloth/dressing/constants.h"
#include "cloth/dressing/stages.h"
#include "cloth/scene/standing_body.h"
#include "geometry/closest_points.h"

namespace toile {

namespace {

/// Share of the way that is nothing.
constexpr double rounding = 1e-9;

/// The points, each moved with the skin that is nearest to it.
std::vector<Vec3> moved_with_skin(std::vector<Vec3> points, const Collider& from, double from_share,
                                  const std::vector<Vec3>& to, double to_share,
                                  const SurfaceMorph& motion) {
  const TriangleMesh& body = from.body();
  for (Vec3& p : points) {
    const SurfacePoint skin = from.skin().closest_point(p);
    const Triangle& t = body.triangles[skin.triangle];
    const Vec3 shares =
        closest_on_triangle(skin.point, body.points[t[0]], body.points[t[1]], body.points[t[2]]);
    const Vec3 moved = shares[0] * to[t[0]] + shares[1] * to[t[1]] + shares[2] * to[t[2]];
    p = moved + motion.turn(skin.triangle, to_share) *
                    (motion.turn(skin.triangle, from_share).conjugate() * (p - skin.point));
  }
  return points;
}

/// Whether a joint moves with a limb; those of the trunk go straight.
bool is_of_limb(const std::string& joint) {
  return joint.ends_with("_elbow") || joint.ends_with("_wrist") || joint.ends_with("_knee") ||
         joint.ends_with("_ankle");
}

/// The joints at a share of the way, where `body` is.
Skeleton joints_at(const StandingBody& standing, const Skeleton& posed, const TriangleMesh& body,
                   double share) {
  Skeleton skeleton = standing.skeleton;
  for (auto& [name, joint] : skeleton.joints) {
    const auto end = posed.joints.find(name);
    if (is_of_limb(name)) {
      joint = moved_with_skin({joint}, standing.collider, 0, body.points, share, standing.motion)
                  .front();
    } else if (end != posed.joints.end()) {
      joint = (1 - share) * joint + share * end->second;
    }
  }
  return skeleton;
}

/// The body at a share of its way, and the scene around it.
struct Station {
  Station(const Scene& posed, const TriangleMesh& body, double share)
      : collider(body),
        skeleton(joints_at(*posed.standing, *posed.skeleton, body, share)),
        scene(posed) {
    scene.collider = &collider;
    scene.skeleton = &skeleton;
    scene.standing = nullptr;
  }

  const Collider collider;
  const Skeleton skeleton;
  Scene scene;
};

/// Steps in which no skin near the cloth moves by more than near_step, and no other by far_step.
int step_count(const std::vector<Vec3>& cloth, const StandingBody& standing) {
  constexpr int samples = 8;
  const TriangleMesh& body = standing.collider.body();
  std::vector<double> path(body.points.size(), 0);
  std::vector<Vec3> before = body.points;
  for (int i = 1; i <= samples; ++i) {
    std::vector<Vec3> now = standing.motion.at(static_cast<double>(i) / samples).points;
    for (std::size_t p = 0; p < path.size(); ++p) path[p] += (now[p] - before[p]).norm();
    before = std::move(now);
  }
  double steps = *std::ranges::max_element(path) / far_step;
  for (const Vec3& p : cloth) {
    const SurfacePoint skin = standing.collider.skin().closest_point(p);
    for (const int corner : body.triangles[skin.triangle]) {
      steps = std::max(steps, path[corner] / near_step);
    }
  }
  return std::max(1, static_cast<int>(std::ceil(steps)));
}

}  // namespace

std::vector<Vec3> taken_along(std::vector<Vec3> points, const Scene& scene) {
  const StandingBody& standing = *scene.standing;
  return moved_with_skin(std::move(points), standing.collider, 0, scene.collider->body().points, 1,
                         standing.motion);
}

bool follow_body(Level& level, State& state, const Scene& scene, double resting_offset,
                 bool bounded, bool friction, Journal& journal) {
  const StandingBody& standing = *scene.standing;
  const PanelMesh& mesh = *level.mesh;
  const double step = 1.0 / step_count(state.nodes, standing);
  const std::size_t first_stage = journal.stages().size();
  std::vector<Vec3> placed = level.placed;

  double share = 0;
  double ahead = step;
  std::unique_ptr<Station> station;
  while (share < 1) {
    ahead = std::min(ahead, 1 - share);
    const double next = share + ahead > 1 - rounding ? 1 : share + ahead;
    const Collider& from = station ? station->collider : standing.collider;
    const TriangleMesh body = standing.motion.at(next);
    State moved;
    moved.nodes = moved_with_skin(state.nodes, from, share, body.points, next, standing.motion);
    moved.warm_start.multipliers = state.warm_start.multipliers;
    if (bounded && !is_clear_of_itself(level, moved)) {
      if (ahead > least_step_share * step) {
        ahead = std::max(ahead / 2, least_step_share * step);
        continue;
      }
      moved.nodes = state.nodes;
    }
    placed = moved_with_skin(std::move(placed), from, share, body.points, next, standing.motion);
    auto there = std::make_unique<Station>(scene, body, next);
    level =
        compiled_level(mesh, level.depth, next == 1 ? scene : there->scene, placed, resting_offset);
    state = follow(level, std::move(moved), bounded, friction, journal).state;
    station = std::move(there);
    share = next;
    ahead = step;
  }
  journal.join_stages(first_stage);
  return bounded || is_clear_of_itself(level, state);
}

void take_along(Level& level, State& state, const Scene& scene, double resting_offset) {
  state.nodes = taken_along(std::move(state.nodes), scene);
  level = compiled_level(*level.mesh, level.depth, scene, taken_along(level.placed, scene),
                         resting_offset);
}

}  // namespace toile
