#include "cloth/start/centre_legs.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "cloth/start/constants.h"
#include "cloth/start/leg_divide.h"
#include "cloth/start/panel_parts.h"
#include "geometry/body/bones.h"

namespace toile {

namespace {

/// Metres between the bones and the seams of a leg, the least on either side. Negative: a seam
/// stands on the wrong side.
struct SeamRoom {
  double inner = std::numeric_limits<double>::infinity();
  double outer = std::numeric_limits<double>::infinity();
};

/// Mean metres beside the divide of a panel's points.
double middle_beside(const MeshedPanel& panel, const LegDivide& divide,
                     const std::vector<Vec3>& placed) {
  double sum = 0;
  for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
    sum += divide.beside(placed[p]);
  }
  return sum / panel.points;
}

/// `side` is 1 for the left leg and -1 for the right one.
SeamRoom seam_room(const PanelMesh& garment, const std::vector<bool>& of_leg,
                   const std::vector<int>& panel_of, const Bones& leg, const LegDivide& divide,
                   double side, const std::vector<Vec3>& placed) {
  SeamRoom room;
  for (const MeshedSeam& seam : garment.seams) {
    const int a = panel_of[seam.a.front()];
    const int b = panel_of[seam.b.front()];
    if (a == b || !of_leg[a] || !of_leg[b]) continue;
    const double panels = 0.5 * (middle_beside(garment.panels[a], divide, placed) +
                                 middle_beside(garment.panels[b], divide, placed));
    double beside = 0;
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      beside += 0.5 * (divide.beside(placed[seam.a[i]]) + divide.beside(placed[seam.b[i]]));
    }
    const bool is_outer = side * (beside / static_cast<double>(seam.a.size()) - panels) > 0;
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      const Vec3 middle = 0.5 * (placed[seam.a[i]] + placed[seam.b[i]]);
      const double along = leg.foot(middle);
      if (along < leg.along.front() || along > leg.along.back()) continue;
      const Vec3 bone = leg.at(along).first;
      // One side of the seam has to stand before the bones, and the other one behind.
      if ((placed[seam.a[i]].z() > bone.z()) == (placed[seam.b[i]].z() > bone.z())) continue;
      const double out = side * (divide.beside(middle) - divide.beside(bone));
      if (is_outer) {
        room.outer = std::min(room.outer, out);
      } else {
        room.inner = std::min(room.inner, -out);
      }
    }
  }
  return room;
}

}  // namespace

void centre_legs(const PanelMesh& garment, const Skeleton& skeleton, std::vector<Vec3>& placed) {
  if (!skeleton.joints.contains("left_hip") || !skeleton.joints.contains("right_hip")) return;
  const LegDivide divide = leg_divide(skeleton);
  const std::vector<BodyPart> parts = panel_parts(garment, skeleton);
  const std::vector<int> panel_of = panel_of_points(garment);
  for (const BodyPart part : {BodyPart::left_leg, BodyPart::right_leg}) {
    const double side = side_of(part);
    const Bones leg(skeleton, part);
    if (leg.joints.empty()) continue;
    std::vector<bool> of_leg(parts.size());
    for (std::size_t panel = 0; panel < parts.size(); ++panel) of_leg[panel] = parts[panel] == part;
    const SeamRoom room = seam_room(garment, of_leg, panel_of, leg, divide, side, placed);
    double out = 0;  // metres
    if (room.inner < 0 && room.outer >= 2 * leg_seam_clearance - room.inner) {
      out = room.inner - leg_seam_clearance;
    } else if (room.outer < 0 && room.inner >= 2 * leg_seam_clearance - room.outer) {
      out = leg_seam_clearance - room.outer;
    }
    if (out == 0) continue;
    for (std::size_t p = 0; p < placed.size(); ++p) {
      if (of_leg[panel_of[p]]) placed[p] += side * out * divide.left;
    }
  }
}

}  // namespace toile
