#include "cloth/start/panel_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloth/start/constants.h"
#include "geometry/body/bones.h"
#include "pattern/panel_kind.h"

namespace toile {

namespace {

/// "torso", "_arm" or "_leg" as the panel's label says; empty: it says nothing.
std::string labelled_limb(const MeshedPanel& panel) {
  if (panel.label == "body") return "torso";
  if (panel.label == "arm") return "_arm";
  if (panel.label == "leg") return kind_of(panel) == PanelKind::trousers ? "_leg" : "torso";
  return "";
}

}  // namespace

std::vector<std::string> panel_parts(const PanelMesh& garment, const Skeleton& skeleton) {
  std::vector<std::string> parts;
  for (const MeshedPanel& panel : garment.panels) {
    if (!panel.part.empty()) {
      parts.push_back(panel.part);
      continue;
    }
    const std::string limb = labelled_limb(panel);
    if (limb == "torso") {
      parts.push_back(limb);
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
    double distance = limb.empty() ? Bones(skeleton, nearest).distance(middle)
                                   : std::numeric_limits<double>::infinity();
    for (const std::string part : {"left_arm", "right_arm", "left_leg", "right_leg"}) {
      if (limb.empty() ? both_sides : !part.ends_with(limb)) continue;
      // Before an arm that hangs down or swings, half a front is nearer to that than to the spine.
      if (limb.empty() && innermost < innermost_sleeve && part.ends_with("_arm")) continue;
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
