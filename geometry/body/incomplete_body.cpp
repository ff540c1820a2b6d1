#include "geometry/body/incomplete_body.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/body/body_frame.h"
#include "geometry/body/trunk_levels.h"

namespace toile {

std::optional<IncompleteBody> incomplete_body(const TriangleMesh& body, const std::string& name) {
  BodyFrame frame = body_frame(body, name);
  IncompleteBody found;
  if (frame.skeleton) {
    if (frame.missing.empty()) return std::nullopt;
    found.skeleton = *frame.skeleton;
    found.problem = "a part of the body is not found, and has no joints: ";
    std::string between;
    for (const auto& [part, why] : frame.missing) {
      found.problem += std::exchange(between, ", ") + why;
    }
  } else {
    const TrunkLevels levels = facing_trunk_levels(frame);
    auto torso = torso_joints(frame, levels);
    if (!torso) return std::nullopt;
    found.skeleton = std::move(*torso);
    found.problem = "the surface shows a torso alone, so only the torso has joints";
  }
  for (auto& [joint, place] : found.skeleton.joints) place = frame.given(place);
  const Eigen::Matrix3d& turn = frame.rotation;
  found.degrees = std::atan2(turn(0, 2), turn(0, 0)) * 180 / std::numbers::pi;
  return found;
}

}  // namespace toile
