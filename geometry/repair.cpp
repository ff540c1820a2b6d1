#define CGAL_EIGEN3_ENABLED
// The repair gives no tolerance, so it never uses an envelope. This halves the time to compile it.
#define CGAL_PMP_REMOVE_SELF_INTERSECTION_NO_POLYHEDRAL_ENVELOPE_CHECK
#include "geometry/repair.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <vector>

#include "geometry/disjoint_sets.h"
#include "geometry/error.h"
#include "geometry/intersections.h"
#include "geometry/surface_distance.h"

namespace toile {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Halfedge = Mesh::Halfedge_index;
using Polygons = std::vector<std::vector<std::size_t>>;

struct Soup {
  std::vector<Point> points;
  Polygons polygons;
};

/// File's unit. A coordinate nearer to 0 is 0: powers of it would underflow, and CGAL divides by
/// them.
constexpr double min_coordinate = 1e-30;

Soup checked_soup(const PolygonSoup& soup, const std::string& name) {
  if (soup.polygons.empty()) {
    throw Error(name, "holds no polygons", "give a surface, not only points");
  }
  Soup copy;
  copy.points.reserve(soup.points.size());
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    const Vec3& point = soup.points[i];
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > 1e9) {
      throw Error(name, "point " + std::to_string(i + 1) + " is not finite or is beyond 1e9",
                  "export the body again");
    }
    const auto kept = [](double x) { return std::abs(x) < min_coordinate ? 0 : x; };
    copy.points.emplace_back(kept(point.x()), kept(point.y()), kept(point.z()));
  }
  copy.polygons.reserve(soup.polygons.size());
  for (const std::vector<int>& polygon : soup.polygons) {
    copy.polygons.emplace_back(polygon.begin(), polygon.end());
  }
  return copy;
}

/// Whether the polygons can be turned so that neighbours agree. Only edges of exactly two polygons
/// bind. Item p of the sets stands for polygon p as it is, item p + count for polygon p turned. An
/// edge joins the items that agree with one another. A polygon joined to itself turned is a
/// contradiction.
bool is_orientable(const Polygons& polygons) {
  struct PolygonSide {
    std::size_t low, high, polygon;
    bool forward;
  };
  std::vector<PolygonSide> sides;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    const auto& polygon = polygons[p];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t a = polygon[i];
      const std::size_t b = polygon[(i + 1) % polygon.size()];
      sides.push_back({std::min(a, b), std::max(a, b), p, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const PolygonSide& a, const PolygonSide& b) {
    return std::tie(a.low, a.high, a.polygon) < std::tie(b.low, b.high, b.polygon);
  });
  const int count = static_cast<int>(polygons.size());
  DisjointSets agreeing(2 * polygons.size());
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low &&
           sides[end].high == sides[i].high) {
      ++end;
    }
    if (end - i == 2) {
      const int a = static_cast<int>(sides[i].polygon);
      const int b = static_cast<int>(sides[i + 1].polygon);
      const bool must_turn = sides[i].forward == sides[i + 1].forward;
      agreeing.join(a, must_turn ? b + count : b);
      agreeing.join(a + count, must_turn ? b : b + count);
      if (agreeing.of(a) == agreeing.of(a + count)) return false;
    }
    i = end;
  }
  return true;
}

double longest_side(const Mesh& mesh) {
  CGAL::Bbox_3 box;
  for (const auto v : mesh.vertices()) box += mesh.point(v).bbox();
  return std::max({box.x_span(), box.y_span(), box.z_span()});
}

CGAL::Bbox_3 hole_box(const Mesh& mesh, Halfedge border) {
  CGAL::Bbox_3 box;
  Halfedge h = border;
  do {
    box += mesh.point(mesh.target(h)).bbox();
    h = mesh.next(h);
  } while (h != border);
  return box;
}

double diagonal(const CGAL::Bbox_3& box) {
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

TriangleMesh to_plain(const Mesh& mesh) {
  TriangleMesh plain;
  std::vector<int> index(mesh.num_vertices() + mesh.number_of_removed_vertices(), -1);
  for (const auto v : mesh.vertices()) {
    index[v.idx()] = static_cast<int>(plain.points.size());
    const Point& p = mesh.point(v);
    plain.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    plain.triangles.push_back({index[mesh.source(h).idx()], index[mesh.target(h).idx()],
                               index[mesh.target(mesh.next(h)).idx()]});
  }
  return plain;
}

/// Cuts a quad along the diagonal at which it folds least. Of two equal diagonals it takes the
/// shorter.
void cut_quad(const std::vector<Point>& points, const std::vector<std::size_t>& quad,
              Polygons& triangles) {
  const auto fold = [&](int first) {
    const Point& a = points[quad[first]];
    const Point& b = points[quad[first + 1]];
    const Point& c = points[quad[first + 2]];
    const Point& d = points[quad[(first + 3) % 4]];
    const auto one = CGAL::cross_product(b - a, c - a);
    const auto two = CGAL::cross_product(c - a, d - a);
    const double lengths = std::sqrt(one.squared_length() * two.squared_length());
    return lengths > 0 ? one * two / lengths : -1.0;
  };
  const auto length = [&](int first) {
    return CGAL::squared_distance(points[quad[first]], points[quad[first + 2]]);
  };
  const double gain = fold(0) - fold(1);
  const bool cut_first = std::abs(gain) > 1e-6 ? gain > 0 : length(0) <= length(1);
  if (cut_first) {
    triangles.push_back({quad[0], quad[1], quad[2]});
    triangles.push_back({quad[0], quad[2], quad[3]});
  } else {
    triangles.push_back({quad[1], quad[2], quad[3]});
    triangles.push_back({quad[1], quad[3], quad[0]});
  }
}

void cut_polygon(const std::vector<Point>& points, const std::vector<std::size_t>& polygon,
                 Polygons& triangles) {
  std::vector<Point> outline;
  for (const std::size_t corner : polygon) outline.push_back(points[corner]);
  std::vector<CGAL::Triple<int, int, int>> cut;
  PMP::triangulate_hole_polyline(outline, std::back_inserter(cut));
  if (cut.size() + 2 == polygon.size()) {
    for (const auto& t : cut) {
      triangles.push_back({polygon[t.first], polygon[t.second], polygon[t.third]});
    }
    return;
  }
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
  }
}

/// Cuts all polygons into triangles. This comes before the half-edge mesh, because a diagonal may
/// be an edge elsewhere. In a soup it is then an edge of too many triangles, which the orientation
/// splits. A half-edge mesh could not hold it.
void triangulate(Soup& soup, RepairReport& report) {
  Polygons triangles;
  triangles.reserve(soup.polygons.size());
  for (const auto& polygon : soup.polygons) {
    if (polygon.size() == 3) {
      triangles.push_back(polygon);
      continue;
    }
    ++report.polygons_triangulated;
    polygon.size() == 4 ? cut_quad(soup.points, polygon, triangles)
                        : cut_polygon(soup.points, polygon, triangles);
  }
  soup.polygons = std::move(triangles);
}

Mesh build_mesh(Soup& soup, RepairReport& report, const std::string& name) {
  PMP::repair_polygon_soup(soup.points, soup.polygons);
  report.points_merged = report.points_read - static_cast<int>(soup.points.size());
  report.polygons_removed = report.polygons_read - static_cast<int>(soup.polygons.size());
  triangulate(soup, report);
  if (report.polygons_triangulated > 0) PMP::repair_polygon_soup(soup.points, soup.polygons);
  if (soup.polygons.empty()) {
    throw Error(name, "all its polygons are without area", "export the body again");
  }
  const std::size_t points_before = soup.points.size();
  PMP::orient_polygon_soup(soup.points, soup.polygons);
  report.points_split = static_cast<int>(soup.points.size() - points_before);
  if (!PMP::is_polygon_soup_a_polygon_mesh(soup.polygons)) {
    throw Error(name, "its polygons can't be joined to a surface", "export the body again");
  }

  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  report.borders_stitched = static_cast<int>(PMP::stitch_borders(mesh));
  const std::size_t faces_before = mesh.number_of_faces();
  PMP::remove_degenerate_faces(mesh);
  report.polygons_removed += static_cast<int>(faces_before - mesh.number_of_faces());
  report.points_split += static_cast<int>(PMP::duplicate_non_manifold_vertices(mesh));
  return mesh;
}

void keep_largest_component(Mesh& mesh, RepairReport& report) {
  auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  const std::size_t count = PMP::connected_components(mesh, component);
  if (count > 1) {
    std::vector<double> area(count, 0);
    double whole = 0;
    for (const auto f : mesh.faces()) {
      const double part = PMP::face_area(f, mesh);
      area[component[f]] += part;
      whole += part;
    }
    const std::size_t largest = std::max_element(area.begin(), area.end()) - area.begin();
    report.components_dropped = static_cast<int>(count - 1);
    report.dropped_area = whole > 0 ? 1 - area[largest] / whole : 0;
    PMP::keep_connected_components(mesh, std::vector<std::size_t>{largest}, component);
    mesh.collect_garbage();
  }
  mesh.remove_property_map(component);
}

void fill_holes(Mesh& mesh, RepairReport& report, bool orientable, const RepairOptions& options,
                const std::string& name) {
  std::vector<Halfedge> borders;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  if (borders.empty()) return;
  const double size = longest_side(mesh);
  int too_large = 0;
  double largest = 0;
  for (const Halfedge border : borders) {
    const double across = diagonal(hole_box(mesh, border));
    largest = std::max(largest, across);
    too_large += across > options.largest_hole * size;
  }
  if (too_large > 0) {
    if (!orientable) {
      throw Error(name, "the surface is one-sided, as a Moebius strip is, so it has no inside",
                  "give a body that is closed");
    }
    throw Error(name,
                "the surface is open: " + std::to_string(too_large) +
                    (too_large == 1 ? " hole is" : " holes are") + " too large to be filled, " +
                    (too_large == 1 ? "" : "the largest ") + number_text(largest, 3) +
                    " units across, " + number_text(100 * largest / size, 3) +
                    " % of the body's longest side (limit " +
                    number_text(100 * options.largest_hole, 3) + " %)",
                "close the body in a mesh editor");
  }
  for (const Halfedge border : borders) {
    const CGAL::Bbox_3 box = hole_box(mesh, border);
    std::vector<Mesh::Face_index> patch;
    std::vector<Mesh::Vertex_index> inner;
    PMP::triangulate_and_refine_hole(mesh, border, std::back_inserter(patch),
                                     std::back_inserter(inner));
    if (patch.empty()) {
      // The refinement's Delaunay search can miss a filling that the plain search finds.
      PMP::triangulate_hole(mesh, border, std::back_inserter(patch),
                            PMP::parameters::use_delaunay_triangulation(false));
    }
    if (patch.empty()) continue;
    const Vec3 middle(box.xmin() + box.xmax(), box.ymin() + box.ymax(), box.zmin() + box.zmax());
    report.holes_filled.push_back({middle / 2, diagonal(box)});
  }
}

double farthest_from(const TriangleMesh& of, const TriangleMesh& surface) {
  const SurfaceDistance distance(surface);
  double farthest = 0;
  for (const Vec3& point : of.points) {
    farthest = std::max(farthest, (point - distance.closest_point(point).point).norm());
  }
  return farthest;
}

/// Pairs of intersecting triangles for each triangle of the mesh. More are not repaired: CGAL may
/// search for minutes, and what it would leave is no longer the surface that was given.
constexpr double max_repaired_pairs = 0.05;

/// CGAL cuts out the facets around an intersection and fills the hole. It may fail or remove too
/// much. So it works on a copy, which is kept only when it is closed, better and near the surface.
TriangleMesh without_self_intersections(const Mesh& mesh, RepairReport& report,
                                        const RepairOptions& options) {
  TriangleMesh plain = to_plain(mesh);
  report.self_intersections_found = static_cast<int>(self_intersections(plain).size());
  report.self_intersections_left = report.self_intersections_found;
  if (report.self_intersections_found == 0) return plain;
  const double triangles = static_cast<double>(plain.triangles.size());
  if (report.self_intersections_found > max_repaired_pairs * triangles) return plain;
  Mesh copy = mesh;
  try {
    PMP::experimental::remove_self_intersections(copy);
  } catch (const CGAL::Failure_exception&) {
    return plain;
  }
  copy.collect_garbage();
  if (copy.is_empty() || !copy.is_valid() || !CGAL::is_closed(copy) ||
      !CGAL::is_triangle_mesh(copy) || !(PMP::volume(copy) > 0)) {
    return plain;
  }
  const TriangleMesh repaired = to_plain(copy);
  const int left = static_cast<int>(self_intersections(repaired).size());
  if (left >= report.self_intersections_found) return plain;
  const double moved = std::max(farthest_from(plain, repaired), farthest_from(repaired, plain));
  if (moved > options.largest_move * longest_side(mesh)) return plain;
  report.self_intersections_left = left;
  report.largest_move = moved;
  return repaired;
}

}  // namespace

RepairedSurface repair(const PolygonSoup& given, const std::string& name,
                       const RepairOptions& options) {
  RepairedSurface result;
  RepairReport& report = result.report;
  report.points_read = static_cast<int>(given.points.size());
  report.polygons_read = static_cast<int>(given.polygons.size());
  Soup soup = checked_soup(given, name);
  try {
    const bool orientable = is_orientable(soup.polygons);
    Mesh mesh = build_mesh(soup, report, name);
    keep_largest_component(mesh, report);
    fill_holes(mesh, report, orientable, options, name);
    mesh.collect_garbage();
    if (mesh.is_empty() || !CGAL::is_closed(mesh) || !CGAL::is_triangle_mesh(mesh)) {
      throw Error(name, "the surface can't be closed", "close the body in a mesh editor");
    }
    const double volume = PMP::volume(mesh);
    if (!(std::abs(volume) > 1e-6 * std::pow(longest_side(mesh), 3))) {
      throw Error(name, "the surface encloses no volume", "give a closed body");
    }
    // The volume's sign decides: intersections at an extreme point would mislead a test there.
    if (volume < 0) {
      PMP::reverse_face_orientations(mesh);
      report.turned_inside_out = true;
    }
    result.mesh = without_self_intersections(mesh, report, options);
  } catch (const CGAL::Failure_exception&) {
    throw Error(name, "the surface can't be repaired: its polygons contradict one another",
                "export the body again, or repair it in a mesh editor");
  }
  return result;
}

}  // namespace toile
