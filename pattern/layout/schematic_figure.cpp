#include "pattern/layout/schematic_figure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "geometry/angles.h"

namespace toile {

namespace {

/// Metres above the ground, for a figure 1.7 m tall.
const std::map<std::string, double> joint_heights = {
    {"pelvis", 0.77}, {"waist", 1.05},    {"chest", 1.25}, {"neck", 1.45},
    {"head", 1.7},    {"shoulder", 1.35}, {"elbow", 1.1},  {"wrist", 0.85},
    {"hip", 0.83},    {"knee", 0.46},     {"ankle", 0.07}};

/// The vertical axis of a body part of the figure, and where panels of the part stand.
struct PartAxis {
  double aside;     ///< metres from the middle of the body
  double distance;  ///< metres from the axis to the panels
  const char* top;  ///< joint that the upper ends of panels are level with
};

PartAxis axis_of(BodyPart part) {
  if (is_arm(part)) return {0.45, 0.12, "shoulder"};
  if (is_leg(part)) return {0.15, 0.12, "waist"};
  return part == BodyPart::head ? PartAxis{0, 0.15, "head"} : PartAxis{0, 0.25, "neck"};
}

}  // namespace

void stand_schematically(PatternPanel& panel) {
  const PanelPlacement& placement = panel.placement;
  Vec2 low = Vec2::Constant(1e300);
  Vec2 high = -low;
  for (const PatternEdge& edge : panel.edges) {
    for (const Vec2& drawn : edge.curve.sample(8)) {
      const Vec2 point = upright(placement.axis, drawn);
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  }
  const PartAxis axis = axis_of(panel.part);
  std::string joint = placement.at.empty() ? axis.top : placement.at;
  joint = joint.substr(joint.find('_') + 1);  // npos + 1 is 0
  const double middle = (low.x() + high.x()) / 2 - placement.shift;
  const double level = placement.level.value_or(high.y());
  const double angle = to_radians(degrees_around(placement, panel.part));
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 2; ++i) {
    turned.col(i).head<2>() = upright(placement.axis, Vec2::Unit(i));
  }
  const Eigen::Matrix3d around = Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
  const double aside = side_of(panel.part) < 0 ? -axis.aside : axis.aside;
  panel.rotation = around * turned;
  panel.translation =
      Vec3(aside, joint_heights.at(joint), 0) + around * Vec3(-middle, -level, axis.distance);
}

}  // namespace toile
