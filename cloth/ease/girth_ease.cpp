#include "cloth/ease/girth_ease.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/slice.h"

namespace toile {

namespace {

/// Whether the section is closed and runs around `centre`, as seen from above.
bool goes_around(const Section& section, const Vec3& centre) {
  if (!section.closed) return false;
  bool inside = false;
  const std::size_t n = section.points.size();
  for (std::size_t i = 0, j = n - 1; i < n; j = i++) {
    const Vec3& a = section.points[i];
    const Vec3& b = section.points[j];
    if ((a.z() > centre.z()) != (b.z() > centre.z()) &&
        centre.x() < a.x() + (centre.z() - a.z()) / (b.z() - a.z()) * (b.x() - a.x())) {
      inside = !inside;
    }
  }
  return inside;
}

/// Metres: the flat length of the line in which the plane at `height` cuts the triangles.
double flat_length(const DressedGarment& garment, const std::vector<int>& triangles,
                   double height) {
  double length = 0;
  for (const int t : triangles) {
    const Triangle& nodes = garment.triangles[static_cast<std::size_t>(t)];
    const Triangle& points = garment.flat_triangles[static_cast<std::size_t>(t)];
    Vec2 ends[2] = {Vec2::Zero(), Vec2::Zero()};
    int found = 0;
    for (int i = 0; i < 3 && found < 2; ++i) {
      const int j = (i + 1) % 3;
      const double from = garment.points[nodes[i]].y() - height;
      const double to = garment.points[nodes[j]].y() - height;
      if ((from >= 0) == (to >= 0)) continue;
      const double along = from / (from - to);
      ends[found++] = (1 - along) * garment.flat[points[i]] + along * garment.flat[points[j]];
    }
    length += (ends[1] - ends[0]).norm();
  }
  return length;
}

}  // namespace

std::vector<GirthEase> measure_girth_ease(const DressedGarment& garment, const TriangleMesh& body,
                                          const Skeleton& skeleton, double step) {
  std::vector<TorsoLevel> levels = torso_levels(body, skeleton);
  const double crotch = skeleton.joint("pelvis").y();
  const double armpit = skeleton.joint("chest").y();
  for (double y = std::ceil(crotch / step) * step; y < armpit; y += step) levels.push_back({"", y});
  std::ranges::stable_sort(levels, std::ranges::greater{}, &TorsoLevel::height);

  const TriangleMesh cloth{garment.points, garment.triangles};
  std::vector<GirthEase> result;
  for (const TorsoLevel& level : levels) {
    const std::optional<Section> torso = torso_section(body, level.height);
    if (!torso) continue;
    const Section* around = nullptr;
    const std::vector<Section> sections = slice(cloth, {0, level.height, 0}, Vec3::UnitY());
    for (const Section& section : sections) {
      // Where layers lie over each other, the outermost counts. It has the largest area and comes
      // first.
      if (goes_around(section, torso->centroid)) {
        around = &section;
        break;
      }
    }
    if (around == nullptr) continue;
    result.push_back({level.name, level.height, torso->girth, around->length,
                      around->length - torso->girth,
                      flat_length(garment, around->triangles, level.height)});
  }
  return result;
}

}  // namespace toile
