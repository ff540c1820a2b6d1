#include "geometry/body/centreline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace toile {

std::optional<Section> section_at(const std::vector<Section>& sections, const Vec3& point,
                                  const Vec3& normal, double min_area, double reach) {
  const Section* nearest = nullptr;
  double distance = reach;
  // Sections are in falling area: the last that contains the point is the smallest.
  const Section* around = nullptr;
  for (const Section& section : sections) {
    if (!section.closed || section.area < min_area) continue;
    if (contains(section, point, normal)) around = &section;
    const double to = (section.centroid - point).norm();
    if (to <= distance) {
      distance = to;
      nearest = &section;
    }
  }
  if (around != nullptr) return *around;
  if (nearest != nullptr) return *nearest;
  return std::nullopt;
}

std::vector<Station> walk_limb(const TriangleMesh& mesh, const Vec3& start, const Vec3& direction,
                               const WalkOptions& options) {
  std::vector<Station> stations;
  Vec3 at = start;
  Vec3 onward = direction.normalized();
  for (double walked = 0; walked <= options.length; walked += options.step) {
    auto found = section_at(slice(mesh, at, onward), at, onward, options.min_area, options.reach);
    if (!found) break;
    double along = 0;
    if (!stations.empty()) {
      along = stations.back().along + (found->centroid - stations.back().section.centroid).norm();
    }
    stations.push_back({along, onward, std::move(*found)});
    // The direction over the last few sections: a single odd section doesn't turn the plane.
    const std::size_t last = stations.size() - 1;
    const std::size_t back = last - std::min<std::size_t>(last, 4);
    const Vec3& here = stations[last].section.centroid;
    const Vec3 lately = here - stations[back].section.centroid;
    if (last - back >= 2 && lately.norm() > options.step) {
      onward = (onward + lately.normalized()).normalized();
    }
    at = here + options.step * onward;
  }
  return stations;
}

std::vector<Station> walk_level(const TriangleMesh& mesh, const Vec3& start, double end,
                                const WalkOptions& options) {
  std::vector<Station> stations;
  const double distance = std::abs(end - start.y());
  const double sign = end < start.y() ? -1 : 1;
  Vec3 at = start;
  for (int i = 0; i * options.step <= std::min(distance, options.length); ++i) {
    at.y() = start.y() + sign * i * options.step;
    auto found = section_at(slice(mesh, at, Vec3::UnitY()), at, Vec3::UnitY(), options.min_area,
                            options.reach);
    if (!found) break;
    at = found->centroid;
    stations.push_back({at.y(), sign * Vec3::UnitY(), std::move(*found)});
  }
  return stations;
}

Vec3 point_along(const std::vector<Station>& stations, double along) {
  const auto after = std::find_if(stations.begin(), stations.end(),
                                  [along](const Station& s) { return s.along >= along; });
  if (after == stations.begin()) return stations.front().section.centroid;
  if (after == stations.end()) return stations.back().section.centroid;
  const Station& a = *(after - 1);
  const Station& b = *after;
  const double t = b.along > a.along ? (along - a.along) / (b.along - a.along) : 0;
  return a.section.centroid + t * (b.section.centroid - a.section.centroid);
}

}  // namespace toile
