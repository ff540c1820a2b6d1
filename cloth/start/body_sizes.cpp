#include "cloth/start/body_sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cloth/start/constants.h"
#include "geometry/body/torso_section.h"

namespace toile {

BodySizes::BodySizes(const TriangleMesh& body, const Skeleton& skeleton)
    : body_(body), skeleton_(skeleton), middle_(skeleton.joint("neck").x()) {
  shoulder_ = 0.5 * (skeleton.joint("left_shoulder") - skeleton.joint("right_shoulder")).norm();
}

std::pair<double, double> BodySizes::depth(double low, double high) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::pair<double, double> range{infinity, -infinity};
  for (const Vec3& p : body_.points) {
    if (std::abs(p.x() - middle_) > shoulder_ || p.y() < low || p.y() > high) continue;
    range.first = std::min(range.first, p.z());
    range.second = std::max(range.second, p.z());
  }
  const double waist = skeleton_.joint("waist").z();
  return range.first > range.second ? std::pair(waist, waist) : range;
}

double BodySizes::shoulder_height(double aside) const {
  const double neck = skeleton_.joint("neck").y();
  double top = -std::numeric_limits<double>::infinity();
  for (const Vec3& p : body_.points) {
    const double x = std::abs(p.x() - middle_);
    if (std::abs(x - aside) < shoulder_strip && p.y() < neck) top = std::max(top, p.y());
  }
  return std::isfinite(top) ? top : neck;
}

double BodySizes::waist_girth() const {
  const std::optional<Section> section = torso_section(body_, skeleton_.joint("waist").y());
  return section ? section->girth : 0;
}

}  // namespace toile
