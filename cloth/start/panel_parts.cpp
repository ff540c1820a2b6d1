#include "cloth/start/panel_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "cloth/start/constants.h"
#include "geometry/body/bones.h"

namespace toile {

std::vector<std::string> panel_parts(const PanelMesh& garment, const Skeleton& skeleton) {
  std::vector<std::string> parts;
  for (const MeshedPanel& panel : garment.panels) {
    if (!panel.part.empty()) {
      parts.push_back(panel.part);
      continue;
    }
    Vec3 middle = Vec3::Zero();
    double left = 0;
    double right = 0;
    double innermost = std::numeric_limits<double>::max();
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      middle += garment.placed[p];
      left = std::max(left, garment.placed[p].x());
      right = std::max(right, -garment.placed[p].x());
      innermost = std::min(innermost, std::abs(garment.placed[p].x()));
    }
    middle /= panel.points;
    const bool both_sides = std::min(left, right) > both_sides_share * (left + right);
    std::string nearest = "torso";
    double distance = Bones(skeleton, nearest).distance(middle);
    for (const char* part : {"left_arm", "right_arm", "left_leg", "right_leg"}) {
      if (both_sides) break;
      // Before an arm that hangs down or swings, half a front is nearer to that than to the spine.
      if (innermost < innermost_sleeve && std::string_view(part).ends_with("_arm")) continue;
      const Bones bones(skeleton, part);
      if (bones.joints.empty() || bones.distance(middle) >= distance) continue;
      nearest = part;
      distance = bones.distance(middle);
    }
    parts.push_back(nearest);
  }
  return parts;
}

}  // namespace toile
