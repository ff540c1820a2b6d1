#include "geometry/body/landmarks.h"

#include <limits>
#include <utility>

namespace toile {

std::optional<Section> torso_section(const TriangleMesh& body, double height) {
  std::vector<Section> sections = slice(body, {0, height, 0}, Vec3::UnitY());
  if (sections.empty() || !sections.front().closed) return std::nullopt;
  return std::move(sections.front());
}

std::vector<TorsoLevel> torso_levels(const TriangleMesh& body, const Skeleton& skeleton) {
  const double crotch = skeleton.joint("pelvis").y();
  const double middle = skeleton.joint("waist").y();
  const double armpit = skeleton.joint("chest").y();
  constexpr double step = 0.005;  // metres
  double backmost = std::numeric_limits<double>::infinity();
  double foremost = -std::numeric_limits<double>::infinity();
  std::optional<double> bust, waist, hip;
  for (double y = crotch + step; y < armpit; y += step) {
    const std::optional<Section> section = torso_section(body, y);
    if (!section) continue;
    for (const Vec3& point : section->points) {
      if (y < middle && point.z() < backmost) {
        backmost = point.z();
        hip = y;
      }
      // The belly may stand out more than the bust, so only the upper two thirds count.
      if (y > middle + (armpit - middle) / 3 && point.z() > foremost) {
        foremost = point.z();
        bust = y;
      }
    }
  }
  if (!bust || !hip) return {};
  double least_girth = std::numeric_limits<double>::infinity();
  for (double y = *hip + step; y < *bust; y += step) {
    const std::optional<Section> section = torso_section(body, y);
    if (section && section->girth < least_girth) {
      least_girth = section->girth;
      waist = y;
    }
  }
  std::vector<TorsoLevel> levels = {{"bust", *bust}};
  if (waist) levels.push_back({"waist", *waist});
  levels.push_back({"hip", *hip});
  return levels;
}

}  // namespace toile
