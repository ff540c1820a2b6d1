#include "cloth/start/panel_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloth/start/constants.h"
#include "geometry/body/bones.h"

namespace toile {

std::vector<BodyPart> panel_parts(const PanelMesh& garment, const Skeleton& skeleton) {
  std::vector<BodyPart> parts;
  parts.reserve(garment.panels.size());
  for (const MeshedPanel& panel : garment.panels) {
    if (panel.is.part != BodyPart::none) {
      parts.push_back(panel.is.part);
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
    const bool is_sleeve = panel.is.worn_as == PanelRole::sleeve;
    const bool is_of_leg = panel.is.worn_as == PanelRole::trousers && !both_sides;
    BodyPart nearest = BodyPart::torso;
    double distance = is_sleeve || is_of_leg ? std::numeric_limits<double>::infinity()
                                             : Bones(skeleton, nearest).distance(middle);
    for (const BodyPart part :
         {BodyPart::left_arm, BodyPart::right_arm, BodyPart::left_leg, BodyPart::right_leg}) {
      if (both_sides && !is_sleeve) continue;
      if (is_arm(part) ? is_of_leg : is_sleeve) continue;
      // Before an arm that hangs down or swings, half a front is nearer to that than to the spine.
      if (!is_sleeve && innermost < innermost_sleeve && is_arm(part)) continue;
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
