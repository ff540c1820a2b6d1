#include "cloth/start/places_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cloth/start/constants.h"
#include "pattern/panel_kind.h"

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
  return std::acos(std::clamp(direction.normalized().y(), -1.0, 1.0)) * 180 / std::numbers::pi;
}

}  // namespace

std::string unfit_place(const PanelMesh& given, const PanelMesh& found,
                        const std::vector<FoundPlace>& places) {
  std::vector<std::size_t> counted;
  double largest = 0;
  for (std::size_t p = 0; p < places.size(); ++p) {
    const MeshedPanel& panel = given.panels[p];
    if (places[p].around || places[p].part.ends_with("_arm") || places[p].part == "head") continue;
    if (kind_of(panel) == PanelKind::sleeve || names_headwear(panel.name)) continue;
    counted.push_back(p);
    largest = std::max(largest, area_of(given, panel));
  }
  for (const std::size_t p : counted) {
    const MeshedPanel& panel = given.panels[p];
    if (area_of(given, panel) < min_telling_area * largest) continue;
    const Stand here(given, panel);
    const Stand there(found, found.panels[p]);
    // A gore of a round skirt is drawn upright, and lies aslant in its sheet.
    const Vec2 by_seams = there.axes.transpose() * Vec3::UnitY();
    const double lean = std::min(lean_of(here.axes * by_seams), lean_of(here.axes.col(1)));
    const std::string name = "panel '" + panel.name + "'";
    if (!(lean <= max_panel_lean)) {
      return name + " leans by " + std::to_string(std::lround(lean)) + " degrees";
    }
    const double off = (here.middle - there.middle).norm();
    if (off > max_place_distance) {
      return name + " stands " + std::to_string(std::lround(100 * off)) + " cm off";
    }
  }
  return "";
}

}  // namespace toile
