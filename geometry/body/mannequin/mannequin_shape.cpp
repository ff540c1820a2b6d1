#include "geometry/body/mannequin/mannequin_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/error.h"
#include "geometry/slice.h"

namespace toile {

namespace {

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
    : MannequinShape(mannequin_tables(), sample_bones(), girth_targets()) {}

MannequinShape::MannequinShape(MannequinSolids solids, MannequinBones bones,
                               std::vector<GirthTarget> girths)
    : solids_(std::move(solids)), bones_(std::move(bones)), girths_(std::move(girths)) {}

double MannequinShape::trunk_distance(const Vec3& p) const {
  double trunk = smooth_union(solids_.part(MannequinPart::torso).distance(p),
                              pair(solids_.buttock, p, 0.04 * solids_.size), 0.07 * solids_.size);
  trunk = smooth_union(trunk, pair(solids_.breast, p, 0.04 * solids_.size), 0.06 * solids_.size);
  trunk = smooth_union(trunk, solids_.yoke.distance(p), 0.06 * solids_.size);
  trunk = smooth_union(trunk, solids_.part(MannequinPart::neck).distance(p), 0.05 * solids_.size);
  double head =
      smooth_union(solids_.cranium.distance(p), solids_.jaw.distance(p), 0.06 * solids_.size);
  head = smooth_union(head, solids_.nose.distance(p), 0.02 * solids_.size);
  return smooth_union(trunk, head, 0.03 * solids_.size);
}

double MannequinShape::arm_distance(const Vec3& p) const {
  return smooth_union(solids_.part(MannequinPart::arm).distance(p), solids_.thumb.distance(p),
                      0.012 * solids_.size);
}

double MannequinShape::leg_distance(const Vec3& p) const {
  return solids_.part(MannequinPart::leg).distance(p);
}

double MannequinShape::foot_distance(const Vec3& p) const {
  return smooth_intersection(solids_.foot.distance(p), -p.y(), 0.012 * solids_.size);
}

double MannequinShape::distance(const Vec3& p) const {
  const Vec3 q = mirrored(p);
  const double arms = std::min(arm_distance(p), arm_distance(q));
  const double legs =
      std::min(smooth_union(leg_distance(p), solids_.foot.distance(p), 0.04 * solids_.size),
               smooth_union(leg_distance(q), solids_.foot.distance(q), 0.04 * solids_.size));
  double body = smooth_union(trunk_distance(p), legs, 0.06 * solids_.size);
  body = smooth_union(body, arms, 0.045 * solids_.size);
  // The plane y = 0 cuts the soles flat.
  return smooth_intersection(body, -p.y(), 0.012 * solids_.size);
}

Vec3 MannequinShape::centre(const GirthTarget& target) const {
  return solids_.part(target.part).centre(target.t);
}

Vec3 MannequinShape::normal(const GirthTarget& target) const {
  return solids_.part(target.part).frame().along;
}

double MannequinShape::girth(const GirthTarget& target) const {
  constexpr int rays = 180;
  constexpr double max_radius = 0.3;  // metres
  constexpr double step = 0.004;      // metres
  const LoftFrame& frame = solids_.part(target.part).frame();
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
    for (const GirthTarget& target : girths_) {
      Loft& loft = solids_.part(target.part);
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

const MannequinShape& sample_shape() {
  static const MannequinShape sample = [] {
    MannequinShape made;
    constexpr double tolerance = 2e-4;  // metres
    made.carve(tolerance);
    return made;
  }();
  return sample;
}

}  // namespace toile
