#include "geometry/triangulate.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/error.h"

namespace toile {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

[[noreturn]] void fail(const std::string& problem) {
  throw Error("triangulation", problem, "check the outline");
}

/// Sets info() of each face to the number of polygons that part it from outside.
void count_polygons(Triangulation& mesh) {
  for (auto face : mesh.all_face_handles()) face->info() = -1;
  std::vector<Triangulation::Face_handle> front = {mesh.infinite_face()};
  mesh.infinite_face()->info() = 0;
  for (int polygons = 0; !front.empty(); ++polygons) {
    std::vector<Triangulation::Face_handle> beyond;
    while (!front.empty()) {
      const auto face = front.back();
      front.pop_back();
      for (int i = 0; i < 3; ++i) {
        const auto next = face->neighbor(i);
        if (next->info() >= 0) continue;
        if (face->is_constrained(i)) {
          beyond.push_back(next);
          continue;
        }
        next->info() = polygons;
        front.push_back(next);
      }
    }
    std::erase_if(beyond, [](const auto& face) { return face->info() >= 0; });
    for (const auto& face : beyond) face->info() = polygons + 1;
    front = std::move(beyond);
  }
}

}  // namespace

std::vector<Triangle> triangulate(const std::vector<Vec2>& outline,
                                  const std::vector<Vec2>& interior,
                                  const std::vector<std::vector<Vec2>>& holes) {
  std::vector<const std::vector<Vec2>*> polygons = {&outline};
  for (const std::vector<Vec2>& hole : holes) polygons.push_back(&hole);
  Triangulation mesh;
  std::vector<std::vector<Triangulation::Vertex_handle>> border;
  int index = 0;
  // Neighbours in the list are mostly close together, so each search starts at the last point.
  Triangulation::Face_handle near;
  const auto insert = [&](const Vec2& point) {
    const auto vertex = mesh.insert(Kernel::Point_2(point.x(), point.y()), near);
    near = vertex->face();
    vertex->info() = index++;
    if (mesh.number_of_vertices() != static_cast<std::size_t>(index)) fail("two points coincide");
    return vertex;
  };
  std::size_t border_points = 0;
  for (const std::vector<Vec2>* polygon : polygons) {
    if (polygon->size() < 3) fail("an outline has fewer than three points");
    border.emplace_back();
    for (const Vec2& point : *polygon) border.back().push_back(insert(point));
    border_points += polygon->size();
  }
  for (const Vec2& point : interior) insert(point);
  try {
    for (const auto& polygon : border) {
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        mesh.insert_constraint(polygon[i], polygon[(i + 1) % polygon.size()]);
      }
    }
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    fail("the outline crosses itself");
  }
  count_polygons(mesh);

  std::vector<Triangle> triangles;
  for (auto face : mesh.finite_face_handles()) {
    if (face->info() != 1) continue;
    Triangle triangle = {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    triangles.push_back(triangle);
  }
  std::sort(triangles.begin(), triangles.end());
  // Euler's formula gives this number of triangles for a disc with holes. Any other number means
  // that a point splits an outline segment or lies outside.
  if (triangles.size() != border_points + 2 * (interior.size() + holes.size()) - 2) {
    fail("a point lies on or outside the outline");
  }
  return triangles;
}

double smallest_angle(const Vec2& a, const Vec2& b, const Vec2& c) {
  const std::array corners = {a, b, c};
  double smallest = std::numbers::pi;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 u = corners[(i + 1) % 3] - corners[i];
    const Vec2 v = corners[(i + 2) % 3] - corners[i];
    const double cross = u.x() * v.y() - u.y() * v.x();
    smallest = std::min(smallest, std::atan2(std::abs(cross), u.dot(v)));
  }
  const Vec2 u = b - a;
  const Vec2 v = c - a;
  return u.x() * v.y() - u.y() * v.x() > 0 ? smallest : -smallest;
}

double smallest_angle(const std::vector<Vec2>& points, const std::vector<Triangle>& triangles) {
  double smallest = std::numbers::pi;
  for (const Triangle& t : triangles) {
    smallest = std::min(smallest, smallest_angle(points[static_cast<std::size_t>(t[0])],
                                                 points[static_cast<std::size_t>(t[1])],
                                                 points[static_cast<std::size_t>(t[2])]));
  }
  return smallest;
}

}  // namespace toile
