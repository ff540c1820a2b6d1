#include "cloth/start/narrow_leg_panels.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "cloth/start/constants.h"
#include "cloth/start/leg_divide.h"
#include "cloth/start/panel_parts.h"

namespace toile {

namespace {

/// Metres beside the divide, the mean of the points that other panels are sewn to this one with;
/// none: it is sewn to none.
std::optional<double> partners_beside(const PanelMesh& garment, int panel,
                                      const std::vector<int>& panel_of, const LegDivide& divide,
                                      const std::vector<Vec3>& placed) {
  double sum = 0;
  int count = 0;
  const auto add = [&](const std::vector<int>& mine, const std::vector<int>& partners) {
    if (panel_of[mine.front()] != panel || panel_of[partners.front()] == panel) return;
    for (const int p : partners) sum += divide.beside(placed[p]);
    count += static_cast<int>(partners.size());
  };
  for (const MeshedSeam& seam : garment.seams) {
    add(seam.a, seam.b);
    add(seam.b, seam.a);
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

}  // namespace

void narrow_leg_panels(const PanelMesh& garment, const Skeleton& skeleton,
                       std::vector<Vec3>& placed) {
  if (!skeleton.joints.contains("left_hip") || !skeleton.joints.contains("right_hip")) return;
  const LegDivide divide = leg_divide(skeleton);
  const std::vector<BodyPart> parts = panel_parts(garment, skeleton);
  const std::vector<int> panel_of = panel_of_points(garment);
  const std::vector<Vec3> before = placed;
  for (std::size_t i = 0; i < garment.panels.size(); ++i) {
    if (!is_leg(parts[i])) continue;
    const double side = side_of(parts[i]);
    const MeshedPanel& panel = garment.panels[i];
    double inner = std::numeric_limits<double>::infinity();
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      inner = std::min(inner, side * divide.beside(before[p]));
    }
    if (inner > -max_leg_panel_overlap) continue;
    const auto middle = partners_beside(garment, static_cast<int>(i), panel_of, divide, before);
    if (!middle || side * *middle <= leg_panel_gap) continue;
    const double share = (side * *middle - leg_panel_gap) / (side * *middle - inner);
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      placed[p] += (share - 1) * (divide.beside(before[p]) - *middle) * divide.left;
    }
  }
}

}  // namespace toile
