#include "cloth/start/narrow_leg_panels.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "cloth/start/constants.h"
#include "cloth/start/panel_parts.h"

namespace toile {

namespace {

/// The mean x of the points that other panels are sewn to this one with; none: it is sewn to none.
std::optional<double> partners_middle(const PanelMesh& garment, int panel,
                                      const std::vector<int>& panel_of,
                                      const std::vector<Vec3>& placed) {
  double sum = 0;
  int count = 0;
  const auto add = [&](const std::vector<int>& mine, const std::vector<int>& partners) {
    if (panel_of[mine.front()] != panel || panel_of[partners.front()] == panel) return;
    for (const int p : partners) sum += placed[p].x();
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
  const auto pelvis = skeleton.joints.find("pelvis");
  if (pelvis == skeleton.joints.end()) return;
  const double plane = pelvis->second.x();
  const std::vector<std::string> parts = panel_parts(garment, skeleton);
  const std::vector<int> panel_of = panel_of_points(garment);
  const std::vector<Vec3> before = placed;
  for (std::size_t i = 0; i < garment.panels.size(); ++i) {
    if (!parts[i].ends_with("_leg")) continue;
    const double side = parts[i] == "left_leg" ? 1 : -1;
    const MeshedPanel& panel = garment.panels[i];
    double inner = std::numeric_limits<double>::infinity();
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      inner = std::min(inner, side * (before[p].x() - plane));
    }
    const std::optional<double> middle =
        partners_middle(garment, static_cast<int>(i), panel_of, before);
    if (inner > -max_leg_panel_overlap || !middle) continue;
    const double aside = side * (*middle - plane);
    if (aside <= leg_panel_gap) continue;
    const double share = (aside - leg_panel_gap) / (aside - inner);
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      placed[p].x() = *middle + share * (before[p].x() - *middle);
    }
  }
}

}  // namespace toile
