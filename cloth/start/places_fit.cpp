#include "cloth/start/places_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "cloth/start/constants.h"
#include "geometry/angles.h"
#include "pattern/classify/panel_class.h"

namespace toile {

namespace {

/// Where a panel stands: placed = axes * flat + origin, as nearly as it is flat.
struct Stand {
  Eigen::Matrix<double, 3, 2> axes;
  Vec3 middle = Vec3::Zero();

  Stand(const PanelMesh& garment, const MeshedPanel& panel) {
    Vec2 flat = Vec2::Zero();
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      flat += garment.flat[p] / panel.points;
      middle += garment.placed[p] / panel.points;
    }
    Eigen::Matrix<double, 3, 2> product = Eigen::Matrix<double, 3, 2>::Zero();
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      const Vec2 from = garment.flat[p] - flat;
      product += (garment.placed[p] - middle) * from.transpose();
      spread += from * from.transpose();
    }
    axes = product * spread.inverse();
  }
};

double area_of(const PanelMesh& garment, const MeshedPanel& panel) {
  double twice = 0;
  for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
    const auto& [a, b, c] = garment.triangles[t];
    const Vec2 ab = garment.flat[b] - garment.flat[a];
    const Vec2 ac = garment.flat[c] - garment.flat[a];
    twice += ab.x() * ac.y() - ab.y() * ac.x();
  }
  return std::abs(twice) / 2;
}

/// Degrees from the upright.
double lean_of(const Vec3& direction) {
  return to_degrees(std::acos(std::clamp(direction.normalized().y(), -1.0, 1.0)));
}

/// Indices of the panels whose places tell. `places` may be empty.
std::vector<std::size_t> telling_panels(const PanelMesh& garment,
                                        const std::vector<FoundPlace>& places) {
  std::vector<std::size_t> panels;
  double largest = 0;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const MeshedPanel& panel = garment.panels[p];
    if (panel.placement.by_part() || panel.is.worn_as == PanelRole::sleeve) continue;
    if (panel.is.is_headwear()) continue;
    if (!places.empty()) {
      const FoundPlace& place = places[p];
      if (place.around || is_arm(place.part) || place.part == BodyPart::head) continue;
    }
    panels.push_back(p);
    largest = std::max(largest, area_of(garment, panel));
  }
  std::erase_if(panels, [&](std::size_t p) {
    return area_of(garment, garment.panels[p]) < min_telling_area * largest;
  });
  return panels;
}

}  // namespace

bool stands_as_drawn(const PanelMesh& garment) {
  return std::ranges::all_of(telling_panels(garment, {}), [&](std::size_t p) {
    return lean_of(Stand(garment, garment.panels[p]).axes.col(1)) <= max_panel_lean;
  });
}

std::string unfit_place(const PanelMesh& given, const PanelMesh& found,
                        const std::vector<FoundPlace>& places) {
  for (const std::size_t p : telling_panels(given, places)) {
    const Stand here(given, given.panels[p]);
    const Stand there(found, found.panels[p]);
    // A gore of a round skirt is drawn upright, and lies aslant in its face.
    const Vec2 by_seams = there.axes.transpose() * Vec3::UnitY();
    const double lean = std::min(lean_of(here.axes * by_seams), lean_of(here.axes.col(1)));
    if (!(lean <= max_panel_lean)) {
      return "panel '" + given.panels[p].name + "' leans by " + std::to_string(std::lround(lean)) +
             " degrees";
    }
  }
  return "";
}

}  // namespace toile
