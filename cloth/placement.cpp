#include "cloth/placement.h"

#include <algorithm>

namespace toile {

namespace {

constexpr double lift_step = 0.01;  // metres
constexpr int lift_steps = 20;
/// Metres that a meeting place has to keep from the skin, so that the seam finds its way out.
constexpr double clearance = 0.01;
/// Metres added to the least lift: room for the cloth to come down onto the shoulders.
constexpr double margin = 0.03;

}  // namespace

Placement place_panels(const PanelMesh& garment, const DistanceGrid& body) {
  const auto inside = [&](double lift) {
    int count = 0;
    for (const MeshedSeam& seam : garment.seams) {
      for (std::size_t i = 0; i < seam.a.size(); ++i) {
        const Vec3 middle = 0.5 * (garment.placed[seam.a[i]] + garment.placed[seam.b[i]]);
        count += body.at(middle + Vec3(0, lift, 0)).distance < clearance;
      }
    }
    return count;
  };
  Placement placement;
  int fewest = inside(0);
  for (int step = 1; step <= lift_steps && fewest > 0; ++step) {
    const int count = inside(step * lift_step);
    if (count < fewest) {
      fewest = count;
      placement.lift = step * lift_step;
    }
  }
  if (placement.lift > 0) placement.lift += margin;
  placement.seams_inside = inside(placement.lift);
  placement.placed = garment.placed;
  for (Vec3& p : placement.placed) {
    p.y() += placement.lift;
    placement.points_inside += body.at(p).distance < 0;
  }
  return placement;
}

}  // namespace toile
