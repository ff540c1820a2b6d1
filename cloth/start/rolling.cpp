#include "cloth/start/rolling.h"

#include <cmath>
#include <numbers>

namespace toile {

double rolling_radius(double width, double around, double zeta) {
  return width / (2 * std::numbers::pi * around) + zeta;
}

double seam_gap(double width, double around, double radius) {
  return 2 * std::numbers::pi * around * radius - width;
}

Vec3 roll(const Vec2& flat, double middle, double radius) {
  const double angle = (flat.x() - middle) / radius;
  return {radius * std::sin(angle), flat.y(), radius * std::cos(angle)};
}

}  // namespace toile
