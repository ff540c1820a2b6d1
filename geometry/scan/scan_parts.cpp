#include "geometry/scan/scan_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/disjoint_sets.h"
#include "geometry/scan/scan_cells.h"
#include "geometry/statistics.h"

namespace toile {

namespace {

/// The points of that part, and their numbers.
struct Chosen {
  std::vector<Vec3> points;
  std::vector<int> numbers;
};

Chosen choose(const std::vector<Vec3>& points, const std::vector<ScanPart>& part) {
  Chosen chosen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (part[i] != ScanPart::body) continue;
    chosen.points.push_back(points[i]);
    chosen.numbers.push_back(static_cast<int>(i));
  }
  return chosen;
}

Eigen::AlignedBox3d bounds(const std::vector<Vec3>& points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  return box;
}

void mark_outliers(const Chosen& body, ScanParts& parts) {
  const std::vector<Vec3>& points = body.points;
  // Blocks of three cells are twelve spacings wide. Smaller ones would lose fingertips, larger ones
  // keep points farther off the skin.
  const ScanCells cells(points, 4 * parts.spacing);
  std::vector<double> near(cells.cells(), 0);
  for (std::size_t i = 0; i < cells.cells(); ++i) {
    cells.near(cells.means()[i], 1, [&](int cell) { near[i] += cells.counts()[cell]; });
  }
  const double least = std::max(3.0, 0.06 * median(near));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (near[cells.cell_of()[i]] < least) parts.part[body.numbers[i]] = ScanPart::outlier;
  }
}

/// A slab of points at the lower end of a scan.
struct Slab {
  AxisDirection up;
  double level = 0;
  double area = 0;      // of the floor that its points cover; 0: there is no floor
  bool is_bed = false;  // what is above lies on it
};

/// The floor that the points would stand on if `up` were up.
Slab floor_below(const std::vector<Vec3>& points, const AxisDirection& up) {
  Slab slab{up, 0, 0, false};
  const Eigen::AlignedBox3d box = bounds(points);
  const double longest = box.sizes().maxCoeff();
  const double tall = box.sizes()[up.axis];
  if (!(tall > 0 && tall >= 0.1 * longest)) return slab;  // the scan of a plane lies on nothing
  const double bin = longest / 300;
  const Vec3 direction = up.vector();
  const double low = up.sign > 0 ? box.min()[up.axis] : -box.max()[up.axis];
  // Only the lowest tenth: nobody stands on a floor that is higher.
  std::vector<int> bins(static_cast<std::size_t>(tall / 10 / bin) + 1, 0);
  for (const Vec3& p : points) {
    const auto at = static_cast<std::size_t>((direction.dot(p) - low) / bin);
    if (at < bins.size()) ++bins[at];
  }
  const auto fullest = std::max_element(bins.begin(), bins.end()) - bins.begin();
  const double middle = low + (static_cast<double>(fullest) + 0.5) * bin;
  std::vector<double> levels;
  std::vector<Vec3> flat;
  Eigen::AlignedBox3d around;
  Eigen::AlignedBox3d rest;
  for (const Vec3& p : points) {
    const double level = direction.dot(p);
    if (std::abs(level - middle) <= 1.5 * bin) {
      levels.push_back(level);
      Vec3 foot = p;
      foot[up.axis] = 0;
      flat.push_back(foot);
      around.extend(p);
    } else if (level > middle) {
      rest.extend(p);
    }
  }
  if (flat.empty() || rest.isEmpty()) return slab;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != up.axis && around.sizes()[axis] < 0.7 * rest.sizes()[axis]) return slab;
  }
  // What lies tells nothing of up. A flat side of it is no floor: that reaches farther on all
  // sides.
  double longest_level = 0;
  double least_beyond = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == up.axis) continue;
    longest_level = std::max(longest_level, rest.sizes()[axis]);
    least_beyond = std::min(least_beyond, around.sizes()[axis] / rest.sizes()[axis]);
  }
  slab.is_bed = rest.sizes()[up.axis] < 0.5 * longest_level;
  if (slab.is_bed && least_beyond < 1.1) return slab;
  // Two soles cover 1.5 % of the square of a body's height, a floor more than twice that.
  const ScanCells tiles(flat, longest / 90);
  const double area = static_cast<double>(tiles.cells()) * tiles.size() * tiles.size();
  if (area < 0.03 * longest * longest) return slab;
  slab.level = median(levels);
  slab.area = area;
  return slab;
}

AxisDirection likely_up(const Eigen::AlignedBox3d& box) {
  const Vec3 size = box.sizes();
  return {size.z() > 1.5 * size.y() && size.z() >= 0.8 * size.x() ? 2 : 1, 1};
}

void find_floor(const Chosen& body, const std::optional<AxisDirection>& up, ScanParts& parts) {
  if (body.points.empty()) return;
  Slab best;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int sign : {1, -1}) {
      if (up && (up->axis != axis || up->sign != sign)) continue;
      const Slab slab = floor_below(body.points, {axis, sign});
      if (slab.area > best.area) best = slab;
    }
  }
  parts.floor_found = best.area > 0;
  if (!parts.floor_found) {
    parts.up = up ? *up : likely_up(bounds(body.points));
    return;
  }
  parts.up = best.up;
  parts.floor = best.level;
  // What noise lifts off the floor goes with it: up to four standard deviations.
  const Vec3 direction = parts.up.vector();
  const double longest = bounds(body.points).sizes().maxCoeff();
  std::vector<double> off;
  for (const Vec3& p : body.points) {
    const double level = std::abs(direction.dot(p) - parts.floor);
    if (level < longest / 100) off.push_back(level);
  }
  const double margin = std::clamp(6 * median(off), longest / 400, longest / 120);
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    if (direction.dot(body.points[i]) < parts.floor + margin) {
      parts.part[body.numbers[i]] = ScanPart::floor;
    }
  }
  parts.lies = best.is_bed;
  if (best.is_bed && !up) {
    parts.floor_found = false;
    Eigen::AlignedBox3d rest;
    for (std::size_t i = 0; i < body.points.size(); ++i) {
      if (parts.part[body.numbers[i]] == ScanPart::body) rest.extend(body.points[i]);
    }
    parts.up = likely_up(rest);
  }
}

void mark_strays(const Chosen& body, ScanParts& parts) {
  if (body.points.empty()) return;
  const double reach = bounds(body.points).sizes().maxCoeff() / 60;
  const ScanCells cells(body.points, std::max(reach, 4 * parts.spacing));
  DisjointSets sets(cells.cells());
  for (std::size_t i = 0; i < cells.cells(); ++i) {
    cells.near(cells.means()[i], 1, [&](int cell) { sets.join(static_cast<int>(i), cell); });
  }
  std::vector<int> size(cells.cells(), 0);
  for (std::size_t i = 0; i < cells.cells(); ++i) {
    size[sets.of(static_cast<int>(i))] += cells.counts()[i];
  }
  const int largest = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  for (std::size_t i = 0; i < size.size(); ++i) {
    parts.stray_parts += static_cast<int>(i) != largest && size[i] > 0;
  }
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    if (sets.of(cells.cell_of()[i]) != largest) parts.part[body.numbers[i]] = ScanPart::stray;
  }
}

}  // namespace

ScanParts sort_scan(const std::vector<Vec3>& points, const std::optional<AxisDirection>& up) {
  ScanParts parts;
  parts.part.assign(points.size(), ScanPart::body);
  if (up) parts.up = *up;
  parts.spacing = point_spacing(points);
  if (!(parts.spacing > 0)) return parts;
  mark_outliers(choose(points, parts.part), parts);
  find_floor(choose(points, parts.part), up, parts);
  // What noise has lifted off the floor stands alone now.
  if (parts.floor_found) {
    const Chosen body = choose(points, parts.part);
    parts.spacing = point_spacing(body.points);
    if (parts.spacing > 0) mark_outliers(body, parts);
  }
  mark_strays(choose(points, parts.part), parts);
  const std::vector<Vec3> body = choose(points, parts.part).points;
  parts.spacing = point_spacing(body);
  std::vector<double> levels;
  levels.reserve(body.size());
  for (const Vec3& p : body) levels.push_back(parts.up.vector().dot(p));
  if (!parts.floor_found) parts.floor = percentile(levels, 0.0005);
  const auto highest = std::max_element(levels.begin(), levels.end());
  if (highest != levels.end()) {
    parts.height = *highest - parts.floor;
    const Vec3 size = bounds(body).sizes();
    parts.depth = std::min(size[(parts.up.axis + 1) % 3], size[(parts.up.axis + 2) % 3]);
  }
  return parts;
}

}  // namespace toile
