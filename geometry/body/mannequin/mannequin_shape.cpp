#include "geometry/body/mannequin/mannequin_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/error.h"
#include "geometry/slice.h"

namespace toile {

namespace {

// The tables' columns, metres: height along the axis; centre u and v; half width, front depth and
// back depth; squareness. The frames give their directions.

Loft torso() {
  return Loft({},
              {{0.785, 0, -0.010, 0.150, 0.082, 0.100, 2.2},
               {0.820, 0, -0.010, 0.163, 0.095, 0.112, 2.25},
               {0.860, 0, -0.010, 0.170, 0.105, 0.118, 2.3},
               {0.900, 0, -0.008, 0.167, 0.113, 0.112, 2.3},
               {0.950, 0, -0.004, 0.155, 0.117, 0.094, 2.25},
               {1.000, 0, 0.000, 0.139, 0.113, 0.082, 2.2},
               {1.050, 0, 0.000, 0.126, 0.106, 0.081, 2.2},
               {1.100, 0, -0.002, 0.126, 0.103, 0.087, 2.25},
               {1.150, 0, -0.006, 0.135, 0.104, 0.096, 2.3},
               {1.230, 0, -0.012, 0.147, 0.106, 0.105, 2.35},
               {1.290, 0, -0.020, 0.152, 0.101, 0.100, 2.35},
               {1.340, 0, -0.030, 0.142, 0.088, 0.088, 2.3},
               {1.385, 0, -0.038, 0.110, 0.066, 0.068, 2.2},
               {1.430, 0, -0.038, 0.070, 0.050, 0.050, 2.0}},
              0.05);
}

// The loft runs across the shoulders. Its centre is (z, y), widths run in z, depths up and down.
Loft yoke() {
  const LoftFrame frame{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY()};
  return Loft(frame,
              {{-0.190, -0.036, 1.356, 0.042, 0.038, 0.040, 2},
               {-0.120, -0.042, 1.373, 0.050, 0.046, 0.060, 2},
               {-0.065, -0.043, 1.385, 0.052, 0.056, 0.070, 2},
               {0.000, -0.043, 1.390, 0.050, 0.058, 0.070, 2},
               {0.065, -0.043, 1.385, 0.052, 0.056, 0.070, 2},
               {0.120, -0.042, 1.373, 0.050, 0.046, 0.060, 2},
               {0.190, -0.036, 1.356, 0.042, 0.038, 0.040, 2}},
              0.04);
}

Loft neck() {
  return Loft({},
              {{1.380, 0, -0.042, 0.066, 0.056, 0.054, 2},
               {1.420, 0, -0.036, 0.058, 0.055, 0.054, 2},
               {1.465, 0, -0.024, 0.054, 0.058, 0.056, 2},
               {1.510, 0, -0.014, 0.054, 0.058, 0.057, 2},
               {1.580, 0, -0.006, 0.054, 0.056, 0.057, 2}},
              0.03);
}

// The loft of arm and hand runs from the shoulder down and out. Widths run up and out, depths
// forward and back.
const Vec3 shoulder(0.160, 1.357, -0.034);
const Vec3 down_the_arm = Vec3(1, -1, 0) / std::numbers::sqrt2;
const Vec3 out_of_the_arm = Vec3(1, 1, 0) / std::numbers::sqrt2;

Loft arm() {
  const LoftFrame frame{shoulder, down_the_arm, out_of_the_arm, Vec3::UnitZ()};
  return Loft(frame,
              {{-0.060, -0.020, 0.000, 0.026, 0.036, 0.036, 2},
               {0.000, -0.002, 0.000, 0.049, 0.048, 0.049, 2},
               {0.050, 0.000, 0.000, 0.053, 0.049, 0.051, 2},
               {0.150, 0.000, 0.000, 0.045, 0.044, 0.045, 2},
               {0.220, 0.000, 0.000, 0.041, 0.042, 0.042, 2},
               {0.290, 0.000, 0.000, 0.039, 0.040, 0.041, 2},
               {0.345, 0.000, 0.005, 0.038, 0.041, 0.039, 2},
               {0.430, 0.000, 0.015, 0.030, 0.034, 0.032, 2},
               {0.520, 0.000, 0.026, 0.022, 0.029, 0.029, 2},
               {0.560, 0.000, 0.031, 0.020, 0.034, 0.033, 2.1},
               {0.610, -0.002, 0.036, 0.0175, 0.041, 0.040, 2.2},
               {0.660, -0.006, 0.040, 0.015, 0.039, 0.039, 2.2},
               {0.700, -0.011, 0.043, 0.0125, 0.031, 0.033, 2.1},
               {0.725, -0.014, 0.044, 0.010, 0.022, 0.024, 2}},
              0.02);
}

Loft thumb() {
  const Vec3 along = (0.80 * down_the_arm + 0.60 * Vec3::UnitZ()).normalized();
  const Vec3 across = (0.80 * Vec3::UnitZ() - 0.60 * down_the_arm).normalized();
  const Vec3 root = shoulder + 0.555 * down_the_arm + 0.042 * Vec3::UnitZ();
  return Loft({root, along, out_of_the_arm, across},
              {{-0.010, 0, 0, 0.013, 0.012, 0.012, 2},
               {0.020, -0.002, 0, 0.0135, 0.013, 0.013, 2},
               {0.050, -0.005, 0, 0.011, 0.0115, 0.0115, 2},
               {0.072, -0.008, 0, 0.009, 0.009, 0.009, 2}},
              0.014);
}

Loft leg() {
  return Loft({},
              {{0.040, 0.088, -0.040, 0.031, 0.034, 0.038, 2},
               {0.085, 0.088, -0.040, 0.033, 0.037, 0.040, 2},
               {0.140, 0.088, -0.038, 0.036, 0.037, 0.041, 2},
               {0.210, 0.089, -0.032, 0.043, 0.042, 0.050, 2},
               {0.280, 0.090, -0.026, 0.052, 0.048, 0.062, 2},
               {0.340, 0.090, -0.021, 0.054, 0.051, 0.064, 2},
               {0.400, 0.090, -0.014, 0.053, 0.054, 0.058, 2},
               {0.460, 0.090, -0.007, 0.054, 0.058, 0.055, 2.05},
               {0.530, 0.091, -0.004, 0.061, 0.064, 0.061, 2},
               {0.620, 0.094, -0.003, 0.073, 0.078, 0.077, 2},
               {0.680, 0.094, -0.005, 0.078, 0.087, 0.086, 2},
               {0.735, 0.093, -0.007, 0.082, 0.095, 0.094, 2},
               {0.800, 0.089, -0.010, 0.079, 0.090, 0.097, 2},
               {0.870, 0.080, -0.010, 0.060, 0.070, 0.076, 2}},
              0.06);
}

// The loft runs from the heel forward. Its centre is (x, y), widths run in x, depths up and down.
Loft foot() {
  const LoftFrame frame{Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()};
  return Loft(frame,
              {{-0.096, 0.088, 0.014, 0.024, 0.024, 0.03, 2.2},
               {-0.070, 0.088, 0.014, 0.032, 0.045, 0.03, 2.2},
               {-0.035, 0.088, 0.014, 0.034, 0.060, 0.03, 2.2},
               {0.015, 0.089, 0.014, 0.036, 0.054, 0.03, 2.2},
               {0.060, 0.092, 0.012, 0.042, 0.036, 0.03, 2.2},
               {0.100, 0.095, 0.010, 0.046, 0.024, 0.03, 2.3},
               {0.135, 0.094, 0.008, 0.041, 0.017, 0.03, 2.3},
               {0.155, 0.091, 0.008, 0.030, 0.012, 0.03, 2.2}},
              0.025);
}

// Parts of the left side; those of the right side are mirror images.
const Ellipsoid breast{{0.072, 1.226, 0.056}, {0.068, 0.076, 0.073}, 0.25};
const Ellipsoid buttock{{0.072, 0.850, -0.066}, {0.080, 0.090, 0.066}, 0.0};
const Ellipsoid cranium{{0, 1.602, -0.004}, {0.075, 0.098, 0.096}, 0.0};
const Ellipsoid jaw{{0, 1.550, 0.030}, {0.056, 0.077, 0.064}, -0.25};
const Ellipsoid nose{{0, 1.572, 0.095}, {0.011, 0.022, 0.014}, -0.35};

Vec3 mirrored(const Vec3& p) { return {-p.x(), p.y(), p.z()}; }

/// The distance to a solid of the left side and its mirror image, blended.
double pair(const Ellipsoid& left, const Vec3& point, double blend) {
  return smooth_union(left.distance(point), left.distance(mirrored(point)), blend);
}

}  // namespace

const std::vector<GirthTarget>& girth_targets() {
  static const std::vector<GirthTarget> targets = {
      {"neck", MannequinPart::neck, 1.465, 0.3600},
      {"bust", MannequinPart::torso, 1.230, 0.9364},
      {"waist", MannequinPart::torso, 1.050, 0.7066},
      {"abdomen", MannequinPart::torso, 0.950, 0.8597},
      {"hip", MannequinPart::torso, 0.860, 0.9800},
      {"upper arm", MannequinPart::arm, 0.150, 0.2800},
      {"elbow", MannequinPart::arm, 0.290, 0.2500},
      {"wrist", MannequinPart::arm, 0.520, 0.1600},
      {"upper thigh", MannequinPart::leg, 0.735, 0.5577},
      {"mid-thigh", MannequinPart::leg, 0.620, 0.4791},
      {"knee", MannequinPart::leg, 0.460, 0.3531},
      {"calf", MannequinPart::leg, 0.340, 0.3500},
      {"ankle", MannequinPart::leg, 0.140, 0.2300}};
  return targets;
}

MannequinShape::MannequinShape()
    : parts_{torso(), neck(), arm(), leg()}, yoke_(yoke()), thumb_(thumb()), foot_(foot()) {}

const Loft& MannequinShape::part(MannequinPart which) const {
  return parts_[static_cast<std::size_t>(which)];
}

Loft& MannequinShape::part(MannequinPart which) { return parts_[static_cast<std::size_t>(which)]; }

double MannequinShape::trunk_distance(const Vec3& p) const {
  double trunk = smooth_union(part(MannequinPart::torso).distance(p), pair(buttock, p, 0.04), 0.07);
  trunk = smooth_union(trunk, pair(breast, p, 0.04), 0.06);
  trunk = smooth_union(trunk, yoke_.distance(p), 0.06);
  trunk = smooth_union(trunk, part(MannequinPart::neck).distance(p), 0.05);
  double head = smooth_union(cranium.distance(p), jaw.distance(p), 0.06);
  head = smooth_union(head, nose.distance(p), 0.02);
  return smooth_union(trunk, head, 0.03);
}

double MannequinShape::arm_distance(const Vec3& p) const {
  return smooth_union(part(MannequinPart::arm).distance(p), thumb_.distance(p), 0.012);
}

double MannequinShape::leg_distance(const Vec3& p) const {
  return part(MannequinPart::leg).distance(p);
}

double MannequinShape::foot_distance(const Vec3& p) const {
  return smooth_intersection(foot_.distance(p), -p.y(), 0.012);
}

double MannequinShape::distance(const Vec3& p) const {
  const Vec3 q = mirrored(p);
  const double arms = std::min(arm_distance(p), arm_distance(q));
  const double legs = std::min(smooth_union(leg_distance(p), foot_.distance(p), 0.04),
                               smooth_union(leg_distance(q), foot_.distance(q), 0.04));
  double body = smooth_union(trunk_distance(p), legs, 0.06);
  body = smooth_union(body, arms, 0.045);
  // The plane y = 0 cuts the soles flat.
  return smooth_intersection(body, -p.y(), 0.012);
}

Vec3 MannequinShape::centre(const GirthTarget& target) const {
  return part(target.part).centre(target.t);
}

Vec3 MannequinShape::normal(const GirthTarget& target) const {
  return part(target.part).frame().along;
}

double MannequinShape::girth(const GirthTarget& target) const {
  constexpr int rays = 180;
  constexpr double max_radius = 0.3;  // metres
  constexpr double step = 0.004;      // metres
  const LoftFrame& frame = part(target.part).frame();
  const Vec3 from = centre(target);
  std::vector<Vec3> outline;
  for (int i = 0; i < rays; ++i) {
    const double angle = 2 * std::numbers::pi * i / rays;
    const Vec3 direction = std::cos(angle) * frame.u + std::sin(angle) * frame.v;
    double inside = 0;
    while (inside + step < max_radius && distance(from + (inside + step) * direction) < 0) {
      inside += step;
    }
    double outside = inside + step;
    for (int k = 0; k < 20; ++k) {
      const double middle = (inside + outside) / 2;
      (distance(from + middle * direction) < 0 ? inside : outside) = middle;
    }
    outline.push_back(from + inside * direction);
  }
  return hull_length(outline, frame.along);
}

double MannequinShape::carve(double tolerance) {
  constexpr int rounds = 30;
  double worst = 0;
  for (int round = 0; round < rounds; ++round) {
    worst = 0;
    for (const GirthTarget& target : girth_targets()) {
      Loft& loft = part(target.part);
      const double measured = girth(target);
      worst = std::max(worst, std::abs(measured - target.girth));
      for (int i = 0; i < static_cast<int>(loft.rows().size()); ++i) {
        if (loft.rows()[i].t == target.t) loft.scale(i, target.girth / measured);
      }
    }
    if (worst < tolerance) return worst;
  }
  throw Error("mannequin", "its girths can't be reached", "change its section tables");
}

}  // namespace toile
