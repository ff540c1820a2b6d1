#include "cloth/start/turn_and_lift.h"

#include <algorithm>

#include "cloth/start/align_sleeves.h"
#include "cloth/start/centre_sleeves.h"
#include "cloth/start/constants.h"
#include "cloth/start/panel_parts.h"
#include "cloth/start/seam_paths.h"

namespace toile {

namespace {

/// Per material point, 1 if it is lifted with the garment and 0 if not: a tube around a limb has to
/// stay there.
std::vector<double> lifted_points(const PanelMesh& garment) {
  std::vector<double> lifted;
  for (const MeshedPanel& panel : garment.panels) {
    const bool is_tube = is_limb(panel.is.part) && panel.placement.around > 0;
    lifted.insert(lifted.end(), panel.points, is_tube ? 0.0 : 1.0);
  }
  return lifted;
}

bool hangs_from_shoulders(const PanelMesh& garment, const std::vector<Vec3>& placed,
                          const Skeleton& skeleton) {
  const double height = skeleton.joint("chest").y() + shoulder_seam_height;
  return std::any_of(garment.seams.begin(), garment.seams.end(), [&](const MeshedSeam& seam) {
    return placed[seam.a.front()].y() > height && placed[seam.b.front()].y() > height;
  });
}

}  // namespace

int points_inside(const std::vector<Vec3>& points, const DistanceGrid& body) {
  return static_cast<int>(
      std::ranges::count_if(points, [&](const Vec3& p) { return body.at(p).distance < 0; }));
}

Placement turn_and_lift(const PanelMesh& garment, const DistanceGrid& body,
                        const Skeleton* skeleton, double hang, const TriangleMesh* skin) {
  Placement placement;
  placement.placed = garment.placed;
  bool hangs = false;
  bool has_sleeves = false;
  std::map<BodyPart, double> on_arms;
  std::vector<BodyPart> part_of_point;
  if (skeleton != nullptr) {
    hangs = hangs_from_shoulders(garment, garment.placed, *skeleton);
    const std::vector<BodyPart> parts = panel_parts(garment, *skeleton);
    has_sleeves = std::ranges::any_of(parts, is_arm);
    for (const int panel : panel_of_points(garment)) part_of_point.push_back(parts[panel]);
    placement.turned = turn_sleeves(garment, part_of_point, *skeleton, placement.placed);
    if (skin != nullptr) {
      on_arms = centre_sleeves(garment, part_of_point, *skin, *skeleton, placement.placed);
    }
  }
  std::vector<double> lifted = lifted_points(garment);
  for (std::size_t p = 0; p < part_of_point.size(); ++p) {
    if (on_arms.contains(part_of_point[p])) lifted[p] = 0;
  }
  SeamPaths paths(garment, placement.placed, lifted, body, skeleton);
  const auto lifted_inside = [&](double lift) {
    int count = 0;
    for (std::size_t p = 0; p < placement.placed.size(); ++p) {
      count += body.at(placement.placed[p] + Vec3(0, lifted[p] * lift, 0)).distance < 0;
    }
    return count;
  };
  // A garment that hangs from the shoulders has to come over them. A skirt must not come into the
  // armpits.
  const bool may_meet_arms = skeleton == nullptr || hangs || has_sleeves;
  const int inside_unlifted = lifted_inside(0);
  const int unlifted = paths.obstructed(0);
  int fewest = unlifted;
  for (int step = 1; step <= max_lift_steps && fewest > paths.at_arms(); ++step) {
    const double lift = step * lift_step;
    const int count = paths.obstructed(lift);
    if (count >= fewest) continue;
    if (!may_meet_arms && lifted_inside(lift + lift_margin) > inside_unlifted) continue;
    fewest = count;
    placement.lift = lift;
  }
  if (fewest > lift_share * unlifted) placement.lift = 0;
  if (placement.lift > 0) placement.lift += lift_margin;
  const bool has_tubes =
      on_arms.empty() && std::find(lifted.begin(), lifted.end(), 0.0) != lifted.end();
  if (hangs && !has_tubes) placement.lift = std::max(placement.lift, hang);
  placement.seams_inside = paths.meeting_inside(placement.lift);
  for (std::size_t p = 0; p < placement.placed.size(); ++p) {
    placement.placed[p].y() += lifted[p] * placement.lift;
  }
  placement.points_inside = points_inside(placement.placed, body);
  return placement;
}

}  // namespace toile
