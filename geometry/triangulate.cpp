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

/// Sets info() to 1 for faces that can be reached from outside without crossing the outline, and to
/// 0 for the others.
void mark_outside(Triangulation& mesh) {
  for (auto face : mesh.all_face_handles()) face->info() = 0;
  std::vector<Triangulation::Face_handle> front = {mesh.infinite_face()};
  mesh.infinite_face()->info() = 1;
  while (!front.empty()) {
    const auto face = front.back();
    front.pop_back();
    for (int i = 0; i < 3; ++i) {
      const auto next = face->neighbor(i);
      if (next->info() == 1 || face->is_constrained(i)) continue;
      next->info() = 1;
      front.push_back(next);
    }
  }
}

}  // namespace

std::vector<Triangle> triangulate(const std::vector<Vec2>& outline,
                                  const std::vector<Vec2>& interior) {
  if (outline.size() < 3) fail("an outline has fewer than three points");
  Triangulation mesh;
  std::vector<Triangulation::Vertex_handle> border;
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
  for (const Vec2& point : outline) border.push_back(insert(point));
  for (const Vec2& point : interior) insert(point);
  try {
    for (std::size_t i = 0; i < border.size(); ++i) {
      mesh.insert_constraint(border[i], border[(i + 1) % border.size()]);
    }
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    fail("the outline crosses itself");
  }
  mark_outside(mesh);

  std::vector<Triangle> triangles;
  for (auto face : mesh.finite_face_handles()) {
    if (face->info() == 1) continue;
    Triangle triangle = {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    triangles.push_back(triangle);
  }
  std::sort(triangles.begin(), triangles.end());
  // Euler's formula gives this number of triangles for a disc. Any other number means that a point
  // splits an outline segment or lies outside.
  if (triangles.size() != outline.size() + 2 * interior.size() - 2) {
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
