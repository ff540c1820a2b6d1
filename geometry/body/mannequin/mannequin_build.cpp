#include "geometry/body/mannequin/mannequin_build.h"

#include <math.h>  // pchip of Boost 1.74 asks for isnan without std::

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/error.h"

namespace toile {

namespace {

using Part = BuildPart;

/// Metres of the sample. Chin and shoulder have no control of their own.
constexpr double ankle_joint = 0.072;
constexpr double shoulder_joint = 1.357;
constexpr double chin = 1.490;
constexpr double wrist_row = 0.520;  // along the arm from the shoulder

/// A smooth curve through knots without overshoot, constant or straight beyond its ends.
class Curve {
 public:
  explicit Curve(std::vector<std::pair<double, double>> knots) : knots_(std::move(knots)) {
    std::vector<double> x;
    std::vector<double> y;
    for (const auto& [at, value] : knots_) {
      x.push_back(at);
      y.push_back(value);
    }
    curve_ = std::make_unique<Pchip>(std::move(x), std::move(y));
  }
  /// The value, outside of the knots that of the nearest one.
  double operator()(double x) const {
    return (*curve_)(std::clamp(x, knots_.front().first, knots_.back().first));
  }

 private:
  using Pchip = boost::math::interpolators::pchip<std::vector<double>>;
  std::vector<std::pair<double, double>> knots_;
  std::unique_ptr<Pchip> curve_;
};

/// Factor of the height from the nape to the crown.
double head_height(const MannequinBuild& b) {
  const double crown = sample_height(Part::height);
  const double nape = sample_height(Part::cervicale_height);
  return (crown * b[Part::height] - nape * b[Part::cervicale_height]) / (crown - nape);
}

double mean(double a, double b) { return std::sqrt(a * b); }

/// The levels of the sample, and those of the build.
std::vector<std::pair<double, double>> height_knots(const MannequinBuild& b) {
  const auto level = [&b](Part part) { return sample_height(part) * b[part]; };
  const double cervicale = level(Part::cervicale_height);
  const double waist = level(Part::waist_height);
  const double trunk = (cervicale - waist) /
                       (sample_height(Part::cervicale_height) - sample_height(Part::waist_height));
  const double top = level(Part::height);
  const double head = head_height(b);
  return {{0, 0},
          {ankle_joint, ankle_joint * b[Part::height]},
          {sample_height(Part::knee_height), level(Part::knee_height)},
          {sample_height(Part::crotch_height), level(Part::crotch_height)},
          {sample_height(Part::hip_height), level(Part::hip_height)},
          {sample_height(Part::waist_height), waist},
          {sample_height(Part::bust_height), level(Part::bust_height)},
          {shoulder_joint,
           cervicale - (sample_height(Part::cervicale_height) - shoulder_joint) * trunk},
          {sample_height(Part::cervicale_height), cervicale},
          {chin, top - head * (sample_height(Part::height) - chin)},
          {sample_height(Part::height), top}};
}

/// How the sample's places and sizes go over into those of a build.
class Deformation {
 public:
  explicit Deformation(const MannequinBuild& build)
      : b(build),
        size(build[Part::height]),
        height_(heights(build)),
        width(widths(build)),
        depth(depths(build)),
        limb(limbs(build)),
        arm(arms(build)) {}

  const MannequinBuild& b;
  const double size;  ///< of hands and feet

 private:
  Curve height_;
  static Curve heights(const MannequinBuild& b) {
    if (!levels_rise(b)) {
      throw Error("measures", "levels of the body do not rise from knee to crown",
                  "check the heights");
    }
    return Curve(height_knots(b));
  }
  static Curve widths(const MannequinBuild& b) {
    return Curve({{0.785, b[Part::hip]},
                  {0.860, b[Part::hip]},
                  {0.950, b[Part::abdomen]},
                  {1.050, b[Part::waist]},
                  {1.150, b[Part::underbust]},
                  {1.230, b[Part::chest]},
                  {1.290, mean(b[Part::chest], b[Part::shoulder_width])},
                  {shoulder_joint, b[Part::shoulder_width]},
                  {1.430, mean(b[Part::shoulder_width], b[Part::neck])}});
  }
  static Curve depths(const MannequinBuild& b) {
    return Curve({{0.785, b[Part::hip]},
                  {0.860, b[Part::hip]},
                  {0.950, b[Part::abdomen]},
                  {1.050, b[Part::waist]},
                  {1.150, b[Part::underbust]},
                  {1.230, b[Part::chest]},
                  {1.290, b[Part::chest]},
                  {shoulder_joint, mean(b[Part::chest], b[Part::shoulder_width])},
                  {1.430, b[Part::neck]}});
  }
  static Curve limbs(const MannequinBuild& b) {
    return Curve({{0.140, b[Part::ankle]},
                  {0.340, b[Part::calf]},
                  {0.460, b[Part::knee]},
                  {0.620, b[Part::mid_thigh]},
                  {0.735, b[Part::upper_thigh]}});
  }
  static Curve arms(const MannequinBuild& b) {
    return Curve({{0.150, b[Part::upper_arm]},
                  {0.290, b[Part::elbow]},
                  {wrist_row, b[Part::wrist]},
                  {0.640, b[Part::height]}});
  }

 public:
  const Curve width;  ///< of the trunk, by the sample's height
  const Curve depth;
  const Curve limb;  ///< sections of a leg, by the sample's height
  const Curve arm;   ///< sections of an arm, by the sample's way along it

  /// The height of a level at `y` of the sample.
  double height(double y) const { return height_(y); }

  double along_arm(double t) const {
    const double length = b[Part::arm_length];
    if (t < 0) return t * b[Part::shoulder_width];
    return t < wrist_row ? t * length : wrist_row * length + (t - wrist_row) * size;
  }

  Vec3 in_trunk(const Vec3& p) const {
    return {p.x() * width(p.y()), height(p.y()), p.z() * depth(p.y())};
  }
  Vec3 in_leg(const Vec3& p) const {
    return {p.x() * limb(p.y()), height(p.y()), p.z() * limb(p.y())};
  }
  /// In a foot, which hangs on the ankle.
  Vec3 in_foot(const Vec3& p) const {
    const Vec3 ankle(0.088, 0, -0.038);
    return b[Part::ankle] * ankle + size * (p - ankle);
  }
  Vec3 shoulder() const {
    const Vec3& at = sample_bones().joints.joint("left_shoulder");
    return {at.x() * b[Part::shoulder_width], height(at.y()), at.z() * depth(at.y())};
  }
};

/// A loft with each row and its frame changed. Rows have to keep their order.
template <class Change>
Loft changed(const Loft& loft, const LoftFrame& frame, double rounding, const Change& change) {
  std::vector<LoftRow> rows;
  for (const LoftRow& row : loft.rows()) rows.push_back(change(row));
  return {frame, rows, rounding};
}

LoftRow scaled(LoftRow row, double width, double depth) {
  row.half_width *= width;
  row.front *= depth;
  row.back *= depth;
  return row;
}

Ellipsoid in_trunk(const Deformation& to, const Ellipsoid& solid) {
  const double y = solid.centre.y();
  const double r = solid.radii.y();
  return {to.in_trunk(solid.centre),
          {solid.radii.x() * to.width(y), (to.height(y + r) - to.height(y - r)) / 2,
           solid.radii.z() * to.depth(y)},
          solid.tilt};
}

/// The breast keeps its root on the chest. A factor of 0.5 leaves the chest flat.
Ellipsoid scaled_breast(const Deformation& to, const Ellipsoid& sample) {
  const double chest = to.b[Part::chest];
  const double factor = to.b[Part::breast];
  Ellipsoid made = sample;
  made.centre = to.in_trunk(sample.centre);
  made.centre.x() = sample.centre.x() * chest * to.b[Part::bust_span];
  made.radii = factor * chest * sample.radii;
  return made;
}

Ellipsoid in_head(const Deformation& to, const Ellipsoid& solid) {
  const double factor = to.b[Part::head];
  const double y = solid.centre.y();
  const double top = sample_height(Part::height);
  const double high = head_height(to.b);
  return {{solid.centre.x() * factor, to.height(top) - (top - y) * high, solid.centre.z() * factor},
          {factor * solid.radii.x(), high * solid.radii.y(), factor * solid.radii.z()},
          solid.tilt};
}

MannequinSolids deformed(const MannequinSolids& sample, const Deformation& to) {
  const MannequinBuild& b = to.b;
  MannequinSolids made = sample;
  const Loft& torso = sample.part(MannequinPart::torso);
  made.part(MannequinPart::torso) =
      changed(torso, torso.frame(), torso.rounding() * to.size, [&to](LoftRow row) {
        const double depth = to.depth(row.t);
        row = scaled(row, to.width(row.t), depth);
        row.v *= depth;
        row.t = to.height(row.t);
        return row;
      });
  const double deep = to.depth(shoulder_joint);
  made.yoke = changed(sample.yoke, sample.yoke.frame(), sample.yoke.rounding() * to.size,
                      [&to, &b, deep](LoftRow row) {
                        const double centre = to.height(row.v);
                        row.front = to.height(row.v + row.front) - centre;
                        row.back = centre - to.height(row.v - row.back);
                        row.half_width *= deep;
                        row.u *= deep;
                        row.v = centre;
                        row.t *= b[Part::shoulder_width];
                        return row;
                      });
  const Loft& neck = sample.part(MannequinPart::neck);
  const Curve thick({{1.380, mean(b[Part::neck], b[Part::shoulder_width])},
                     {1.420, b[Part::neck]},
                     {1.510, b[Part::neck]},
                     {1.580, mean(b[Part::neck], b[Part::head])}});
  const Curve forward({{1.380, to.depth(1.380)},
                       {1.420, to.depth(1.420)},
                       {1.510, mean(b[Part::neck], b[Part::head])},
                       {1.580, b[Part::head]}});
  made.part(MannequinPart::neck) =
      changed(neck, neck.frame(), neck.rounding() * to.size, [&](LoftRow row) {
        row = scaled(row, thick(row.t), thick(row.t));
        row.v *= forward(row.t);
        row.t = to.height(row.t);
        return row;
      });
  const Loft& arm = sample.part(MannequinPart::arm);
  LoftFrame arm_frame = arm.frame();
  arm_frame.origin = to.shoulder();
  made.part(MannequinPart::arm) =
      changed(arm, arm_frame, arm.rounding() * to.size, [&to](LoftRow row) {
        const double factor = to.arm(row.t);
        row = scaled(row, factor, factor);
        row.u *= factor;
        row.v *= factor;
        row.t = to.along_arm(row.t);
        return row;
      });
  LoftFrame thumb_frame = sample.thumb.frame();
  const Vec3 root = thumb_frame.origin - arm.frame().origin;
  const double way = root.dot(arm_frame.along);
  thumb_frame.origin = arm_frame.origin + to.along_arm(way) * arm_frame.along +
                       to.arm(way) * (root - way * arm_frame.along);
  made.thumb =
      changed(sample.thumb, thumb_frame, sample.thumb.rounding() * to.size, [&to](LoftRow row) {
        row = scaled(row, to.size, to.size);
        row.t *= to.size;
        row.u *= to.size;
        return row;
      });
  // Metres: thin legs stand farther apart than their scale says, so that a mesh can part them.
  constexpr double apart = 0.014;
  const Loft& leg = sample.part(MannequinPart::leg);
  made.part(MannequinPart::leg) =
      changed(leg, leg.frame(), leg.rounding() * to.size, [&to](LoftRow row) {
        const double factor = to.limb(row.t);
        row = scaled(row, factor, factor);
        row.u = factor * row.u + std::max(1 - factor, 0.0) * apart;
        row.v *= factor;
        row.t = to.height(row.t);
        return row;
      });
  made.foot = changed(sample.foot, sample.foot.frame(), sample.foot.rounding() * to.size,
                      [&to](LoftRow row) {
                        const Vec3 at = to.in_foot({row.u, row.v, row.t});
                        row = scaled(row, to.size, to.size);
                        row.u = at.x();
                        row.v = at.y();
                        row.t = at.z();
                        return row;
                      });
  made.buttock = in_trunk(to, sample.buttock);
  made.breast = scaled_breast(to, sample.breast);
  made.size = to.size;
  for (Ellipsoid* part : {&made.cranium, &made.jaw, &made.nose}) *part = in_head(to, *part);
  return made;
}

MannequinBones deformed(const MannequinBones& sample, const Deformation& to) {
  MannequinBones made = sample;
  for (auto& [name, joint] : made.joints.joints) {
    const bool is_left = name.starts_with("left_");
    if (!is_left && !name.starts_with("right_")) {
      joint = to.in_trunk(joint);
      continue;
    }
    const std::string bone = name.substr(name.find('_') + 1);
    const Vec3 at = sample.joints.joint("left_" + bone);
    Vec3 moved;
    if (bone == "hip") {
      moved = Vec3(at.x() * to.b[Part::hip], to.height(at.y()), at.z() * to.b[Part::hip]);
    } else if (bone == "knee" || bone == "ankle") {
      moved = to.in_leg(at);
    } else {
      const Vec3 from = sample.joints.joint("left_shoulder");
      const Vec3 along = Vec3(1, -1, 0) / std::numbers::sqrt2;
      const double way = (at - from).dot(along);
      moved = to.shoulder() + to.along_arm(way) * along + to.arm(way) * (at - from - way * along);
    }
    joint = is_left ? moved : Vec3(-moved.x(), moved.y(), moved.z());
  }
  made.ball_of_foot = to.in_foot(sample.ball_of_foot);
  made.ball_of_foot.y() = 0;
  made.toe_tip = to.in_foot(sample.toe_tip);
  made.heel = to.in_foot(sample.heel);
  const Vec3 wrist = sample.joints.joint("left_wrist");
  made.finger_tip = made.joints.joint("left_wrist") + to.size * (sample.finger_tip - wrist);
  made.knee_reach *= to.b[Part::knee];
  made.elbow_reach *= to.b[Part::elbow];
  made.toes_reach *= to.size;
  const double wide = std::max({to.b[Part::hip], to.b[Part::abdomen], to.b[Part::waist],
                                to.b[Part::chest], to.b[Part::shoulder_width]});
  const double deep = std::max({wide, to.b[Part::breast] * to.b[Part::chest], to.b[Part::head]});
  made.trunk_low = {wide * sample.trunk_low.x(), to.height(0.75), deep * sample.trunk_low.z()};
  made.trunk_high = {wide * sample.trunk_high.x(), to.height(sample_height(Part::height)) + 0.01,
                     deep * sample.trunk_high.z()};
  constexpr double margin = 0.04;  // metres
  const double aside = std::max(made.finger_tip.x(), made.trunk_high.x()) + margin;
  made.low = {-aside, -0.01, std::min(made.trunk_low.z(), made.heel.z()) - margin};
  made.high = {aside, made.trunk_high.y() + 0.01,
               std::max(made.trunk_high.z(), made.toe_tip.z()) + margin};
  return made;
}

}  // namespace

double sample_height(BuildPart part) {
  // Of the first parts, in their order.
  constexpr std::array heights = {1.700, 1.443, 1.226, 1.050, 0.860, 0.763, 0.465};
  const auto i = static_cast<std::size_t>(part);
  return i < heights.size() ? heights[i] : 0;
}

bool levels_rise(const MannequinBuild& build) {
  const std::vector<std::pair<double, double>> knots = height_knots(build);
  return std::adjacent_find(knots.begin(), knots.end(), [](const auto& below, const auto& above) {
           return above.second <= below.second;
         }) == knots.end();
}

MannequinShape built_mannequin(const MannequinBuild& build) {
  const MannequinShape& sample = sample_shape();
  const Deformation to(build);
  std::vector<GirthTarget> girths;
  for (GirthTarget girth : sample.girths()) {
    girth.t = girth.part == MannequinPart::arm ? to.along_arm(girth.t) : to.height(girth.t);
    girths.push_back(girth);
  }
  return {deformed(sample.solids(), to), deformed(sample.bones(), to), girths};
}

}  // namespace toile
