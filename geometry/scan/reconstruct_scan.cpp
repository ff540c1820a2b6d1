#include "geometry/scan/reconstruct_scan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/body/body_unit.h"
#include "geometry/body/sheet.h"
#include "geometry/disjoint_sets.h"
#include "geometry/error.h"
#include "geometry/implicit_mesh.h"
#include "geometry/parallel.h"
#include "geometry/scan/find_clefts.h"
#include "geometry/scan/floor_slope.h"
#include "geometry/scan/scan_cells.h"
#include "geometry/scan/scan_samples.h"
#include "geometry/scan/smooth_distance.h"
#include "geometry/scan/unseen.h"
#include "geometry/statistics.h"
#include "geometry/surface_distance.h"

namespace toile {

namespace {

constexpr int fewest_points = 1000;
constexpr double widest_spacing = 0.02;  // of the height: 35 mm of an adult
constexpr double least_seen = 0.7;       // share of the surface

Vec3 area_vector(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3& a = mesh.points[t[0]];
  return (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a) / 2;
}

Vec3 middle(const TriangleMesh& mesh, const Triangle& t) {
  return (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
}

/// The piece of largest volume.
TriangleMesh largest_piece(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.points.size());
  for (const Triangle& t : mesh.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  std::vector<double> volume(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    volume[sets.of(t[0])] += middle(mesh, t).dot(area_vector(mesh, t)) / 3;
  }
  const int best =
      static_cast<int>(std::max_element(volume.begin(), volume.end()) - volume.begin());
  TriangleMesh piece;
  std::vector<int> number(mesh.points.size(), -1);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (sets.of(static_cast<int>(i)) != best) continue;
    number[i] = static_cast<int>(piece.points.size());
    piece.points.push_back(mesh.points[i]);
  }
  for (const Triangle& t : mesh.triangles) {
    if (number[t[0]] >= 0) piece.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  return piece;
}

/// The body's points in metres, with the samples' normals.
PointCloud body_points(const PointCloud& scan, const ScanParts& parts, double unit) {
  PointCloud body;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (parts.part[i] != ScanPart::body) continue;
    body.points.push_back(unit * scan.points[i]);
    if (!scan.normals.empty()) body.normals.push_back(scan.normals[i]);
  }
  return body;
}

PointCloud turned(const PointCloud& scan, const Eigen::Matrix3d& turn) {
  PointCloud other = scan;
  for (Vec3& p : other.points) p = turn * p;
  for (Vec3& n : other.normals) n = turn * n;
  return other;
}

/// Throws Error where the points fill a space instead of lying on its surface. `height` and
/// `spacing` are in their unit.
void refuse_filled(const std::vector<Vec3>& points, double height, double spacing,
                   const std::string& name) {
  // Share of the cells with points whose 26 neighbours all have points. The mannequin's scans have
  // 0.000, with 5 mm of noise 0.004; a filled block has 0.64, a cube 0.72. Half and double part
  // them, too.
  constexpr double most_inner = 0.2;
  // Three spacings, so that hardly a cell within a filled space is empty.
  const ScanCells cells(points, std::max(height / 60, 3 * spacing));
  std::size_t inner = 0;
  for (const Vec3& mean : cells.means()) {
    int near = 0;
    cells.near(mean, 1, [&near](int) { ++near; });
    if (near == 27) ++inner;
  }
  const double share = static_cast<double>(inner) / static_cast<double>(cells.cells());
  if (share <= most_inner) return;
  throw Error(name,
              "its points fill a space: " + number_text(100 * share, 2) +
                  " % of it lie within other points",
              "give points of the body's surface only");
}

void count_parts(const ScanParts& parts, ScanReport& report) {
  for (const ScanPart part : parts.part) {
    report.kept += part == ScanPart::body;
    report.outliers += part == ScanPart::outlier;
    report.stray += part == ScanPart::stray;
    report.floor += part == ScanPart::floor;
  }
  report.stray_parts = parts.stray_parts;
  report.up = parts.up;
  report.floor_found = parts.floor_found;
  report.lies = parts.lies;
}

/// Finds the parts of the surface that are far from all samples.
void find_holes(const TriangleMesh& mesh, const Unseen& unseen_at, ScanReport& report) {
  std::vector<char> seen(mesh.points.size(), 0);
  parallel_for_chunks(mesh.points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) seen[i] = unseen_at.is_far(mesh.points[i]) ? 0 : 1;
  });
  DisjointSets sets(mesh.points.size());
  const auto is_seen = [&](const Triangle& t) {
    return seen[t[0]] != 0 && seen[t[1]] != 0 && seen[t[2]] != 0;
  };
  for (const Triangle& t : mesh.triangles) {
    if (is_seen(t)) continue;
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  std::vector<ScanHole> holes(mesh.points.size());
  double area = 0;
  double unseen = 0;
  for (const Triangle& t : mesh.triangles) {
    const double size = area_vector(mesh, t).norm();
    area += size;
    if (is_seen(t)) continue;
    unseen += size;
    ScanHole& hole = holes[sets.of(t[0])];
    hole.area += size;
    hole.centre += size * middle(mesh, t);
  }
  report.seen = 1 - unseen / area;
  for (ScanHole& hole : holes) {
    if (hole.area < listed_hole) continue;
    hole.centre /= hole.area;
    report.holes.push_back(hole);
  }
  std::stable_sort(report.holes.begin(), report.holes.end(),
                   [](const ScanHole& a, const ScanHole& b) { return a.area > b.area; });
}

void measure_error(const TriangleMesh& mesh, const std::vector<Vec3>& points, ScanReport& report) {
  // 100,000 points tell the percentile to 0.1 of its percents.
  const std::size_t stride = points.size() / 100000 + 1;
  const SurfaceDistance surface(mesh);
  std::vector<double> off((points.size() + stride - 1) / stride);
  parallel_for_chunks(off.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      off[i] = std::abs(surface.closest_point(points[i * stride]).distance);
    }
  });
  report.error_rms = root_mean_square(off);
  report.error_95 = percentile(off, 0.95);
  const auto far = std::count_if(off.begin(), off.end(), [](double d) { return d > far_off; });
  report.off_surface = static_cast<double>(far) / static_cast<double>(off.size());
}

SmoothDistanceOptions resolution(const ScanSamples& samples) {
  SmoothDistanceOptions options;
  options.spacing = std::clamp(0.8 * samples.spacing, 0.004, 0.012);
  // Tried on 20,000 points with 3 mm of noise. Half and twice as much smoothing put 2 to 3 % less
  // of the surface within 2 mm.
  const double by_noise = 0.28 * samples.spacing * samples.noise / 0.001;
  options.smoothing = std::max(0.35 * samples.spacing, by_noise);
  return options;
}

/// Meshes the body within the box of its points, which it leaves by no more than a missing crown,
/// and above the floor.
TriangleMesh mesh_of(const ImplicitFunction& distance, const SmoothDistance& box_of,
                     const ScanParts& parts, double unit, const std::vector<Vec3>& points,
                     const ScanOptions& options, const std::string& name) {
  const Vec3 up = parts.up.vector();
  const double floor = parts.floor * unit;
  constexpr double beyond = 0.04;  // metres
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  const Vec3 centre = box.center();
  const Vec3 half = box.sizes() / 2 + Vec3::Constant(beyond);
  const auto shape = [&](const Vec3& p) {
    const double outside = ((p - centre).cwiseAbs() - half).maxCoeff();
    return std::max({distance(p), outside, floor - up.dot(p)});
  };
  ImplicitMeshOptions net;
  net.low = box_of.low();
  net.high = box_of.high();
  net.spacing = options.edge_length / 0.9;
  net.keeps_clefts = true;
  // Where a coarse net can't part two sheets, a finer one does.
  for (int round = 0;; ++round) {
    try {
      return mesh_implicit(shape, net);
    } catch (const Error&) {
      if (round == 3) {
        throw Error(name, "its points bound no body whose surface can be meshed",
                    "scan the whole body, from all sides");
      }
      net.spacing *= 0.85;
    }
  }
}

/// The distance, with clefts between the thighs and under the arms. Where no rough mesh shows the
/// limbs, it is left as it is.
ImplicitFunction with_clefts(const SmoothDistance& distance, const Unseen& unseen,
                             const ScanSamples& samples, const ScanParts& parts, double unit,
                             const std::vector<Vec3>& points, ScanOptions options,
                             const std::string& name) {
  // A grid of the mesh's spacing has a node in such a gap.
  const double least_gap = std::min(1.25 / 0.9 * options.edge_length, 0.014);
  options.edge_length = std::max(options.edge_length, 0.012);
  std::vector<Cleft> clefts;
  const auto shape = [&distance, &unseen](const std::vector<Cleft>& some) {
    return [&distance, &unseen, some](const Vec3& p) {
      double at = distance(p);
      for (const Cleft& cleft : some) {
        if (cleft.changes(p)) at = cleft(p, at, unseen(p));
      }
      return at;
    };
  };
  RoughBody body;
  body.up = parts.up;
  body.floor = parts.floor * unit;
  body.height = parts.height * unit;
  const auto mesh = [&] {
    body.mesh = largest_piece(mesh_of(shape(clefts), distance, parts, unit, points, options, name));
  };
  try {
    mesh();
    if (auto legs = leg_cleft(body, samples, least_gap)) {
      clefts.push_back(std::move(*legs));
      mesh();
    }
    for (Cleft& cleft : arm_clefts(body, samples, least_gap)) clefts.push_back(std::move(cleft));
  } catch (const Error&) {
    // The mesh of the result is finer, and says what is wrong.
    return shape(clefts);
  }
  return shape(clefts);
}

}  // namespace

ReconstructedScan reconstruct_scan(const PointCloud& given, const std::string& name,
                                   const ScanOptions& options) {
  ReconstructedScan result;
  ScanReport& report = result.report;
  // A copy of what may be many points is made only where the floor slopes.
  PointCloud level;
  ScanParts parts;
  if (const auto slope = floor_slope(given.points, options.up)) {
    level = turned(given, slope->turn);
    parts = sort_scan(level.points, options.up);
    if (parts.floor_found || parts.lies) {
      report.level = slope->turn;
      report.floor_slope = slope->degrees;
    }
  }
  const bool is_level = report.floor_slope == 0;
  if (is_level) parts = sort_scan(given.points, options.up);
  const PointCloud& scan = is_level ? given : level;
  report.points_read = static_cast<int>(scan.points.size());
  count_parts(parts, report);
  report.up_given = options.up.has_value();
  if (report.kept < fewest_points) {
    throw Error(name,
                "holds " + std::to_string(report.points_read) + " points, of which " +
                    std::to_string(report.kept) + " can be a body; " +
                    std::to_string(fewest_points) + " are the least",
                "scan more densely");
  }
  report.unit_inferred = !options.metres_per_unit && !options.height;
  report.metres_per_unit = body_unit(options, parts.height, parts.depth, name);
  const double unit = report.metres_per_unit;
  report.spacing = parts.spacing * unit;
  const double height = parts.height * unit;
  if (!(height >= 0.1 && height <= 10)) {
    throw Error(name, "the body would be " + number_text(height) + " m tall",
                "give the unit that the file is in with --unit");
  }
  if (report.spacing > widest_spacing * height) {
    throw Error(name,
                "its " + std::to_string(report.kept) + " points are about " +
                    number_text(1000 * report.spacing, 2) + " mm apart; " +
                    number_text(1000 * widest_spacing * height, 2) + " mm are the most",
                "scan more densely");
  }
  const PointCloud body = body_points(scan, parts, unit);
  refuse_sheet(body.points, name);
  refuse_filled(body.points, height, report.spacing, name);
  const ScanSamples samples = sample_scan(body, parts.up, report.spacing);
  report.normals_given = samples.normals_given;
  report.noise = samples.noise;
  const SmoothDistance distance(samples, resolution(samples));
  // What is more than two and a half spacings from a point was not seen.
  const Unseen unseen(samples.points, std::max(0.008, 2.5 * samples.spacing));
  const ImplicitFunction shape =
      with_clefts(distance, unseen, samples, parts, unit, body.points, options, name);
  result.mesh = largest_piece(mesh_of(shape, distance, parts, unit, body.points, options, name));
  find_holes(result.mesh, unseen, report);
  if (report.seen < least_seen) {
    throw Error(name,
                "its points are near to " + number_text(100 * report.seen, 2) +
                    " % of the surface that they bound; " + number_text(100 * least_seen, 2) +
                    " % are the least",
                "scan the body from all sides");
  }
  measure_error(result.mesh, body.points, report);
  return result;
}

}  // namespace toile
