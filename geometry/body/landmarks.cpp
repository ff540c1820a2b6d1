#include "geometry/body/landmarks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace toile {

std::optional<Section> torso_section(const TriangleMesh& body, double height) {
  std::vector<Section> sections = slice(body, {0, height, 0}, Vec3::UnitY());
  if (sections.empty() || !sections.front().closed) return std::nullopt;
  return std::move(sections.front());
}

namespace {

/// Metres from the level that stands out the most within which the foremost one is looked for.
constexpr double near_bust = 0.03;

/// The height at which the front of the trunk stands out the most from the straight line between
/// its ends. A belly may stand out farther than the bust, so the line is needed, and only the upper
/// two thirds count. A chest that is nowhere rounded has its level at its upper end. `front` has
/// heights and foremost z from the waist to the armpits, at least three.
std::optional<double> bust_level(const std::vector<Vec2>& front) {
  if (front.size() < 3) return std::nullopt;
  const Vec2& low = front.front();
  const Vec2& high = front.back();
  double most = 0;
  std::size_t level = front.size() - 1;
  for (std::size_t i = 0; i < front.size(); ++i) {
    const Vec2& at = front[i];
    const double along = (at.x() - low.x()) / (high.x() - low.x());
    const double out = at.y() - (low.y() + along * (high.y() - low.y()));
    if (along < 1.0 / 3 || out <= most) continue;
    most = out;
    level = i;
  }
  // The foremost level, where there is one next to it.
  std::size_t foremost = level;
  const auto is_higher = [&](std::size_t i) {
    return std::abs(front[i].x() - front[level].x()) < near_bust &&
           front[i].y() > front[foremost].y();
  };
  while (foremost + 1 < front.size() && is_higher(foremost + 1)) ++foremost;
  while (foremost > 0 && is_higher(foremost - 1)) --foremost;
  const bool is_summit = foremost > 0 && foremost + 1 < front.size() &&
                         front[foremost - 1].y() < front[foremost].y() &&
                         front[foremost + 1].y() < front[foremost].y();
  return front[is_summit ? foremost : level].x();
}

}  // namespace

std::vector<TorsoLevel> torso_levels(const TriangleMesh& body, const Skeleton& skeleton) {
  const double crotch = skeleton.joint("pelvis").y();
  const double middle = skeleton.joint("waist").y();
  const double armpit = skeleton.joint("chest").y();
  constexpr double step = 0.005;  // metres
  double backmost = std::numeric_limits<double>::infinity();
  std::optional<double> waist, hip;
  std::vector<Vec2> front;  // height and foremost z, from the waist up
  for (double y = crotch + step; y < armpit; y += step) {
    const std::optional<Section> section = torso_section(body, y);
    if (!section) continue;
    double foremost = -std::numeric_limits<double>::infinity();
    for (const Vec3& point : section->points) {
      foremost = std::max(foremost, point.z());
      if (y < middle && point.z() < backmost) {
        backmost = point.z();
        hip = y;
      }
    }
    if (y > middle) front.emplace_back(y, foremost);
  }
  const std::optional<double> bust = bust_level(front);
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
