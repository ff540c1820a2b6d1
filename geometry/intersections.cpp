#include "geometry/intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace toile {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

Point to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

std::vector<Box> boxes_of(const TriangleMesh& mesh) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    CGAL::Bbox_3 box;
    for (const int corner : mesh.triangles[t]) box += to_cgal(mesh.points[corner]).bbox();
    boxes.emplace_back(box, static_cast<int>(t));
  }
  return boxes;
}

Kernel::Triangle_3 triangle_of(const TriangleMesh& mesh, const Triangle& corners) {
  return {to_cgal(mesh.points[corners[0]]), to_cgal(mesh.points[corners[1]]),
          to_cgal(mesh.points[corners[2]])};
}

/// Whether two triangles of one mesh meet beyond what they share.
bool meet(const TriangleMesh& mesh, const Triangle& s, const Triangle& t) {
  // Rotate both so that shared corners come first, in places i and j.
  int shared = 0;
  int in_s[3] = {};
  int in_t[3] = {};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (s[i] == t[j] && shared < 3) {
        in_s[shared] = i;
        in_t[shared] = j;
        ++shared;
      }
    }
  }
  if (shared == 0) return CGAL::do_intersect(triangle_of(mesh, s), triangle_of(mesh, t));
  const auto point = [&](int index) { return to_cgal(mesh.points[index]); };
  if (shared == 1) {
    // Two triangles hinged at a vertex meet again only if one's far edge meets the other.
    const int i = in_s[0];
    const int j = in_t[0];
    const Kernel::Segment_3 far_s(point(s[(i + 1) % 3]), point(s[(i + 2) % 3]));
    const Kernel::Segment_3 far_t(point(t[(j + 1) % 3]), point(t[(j + 2) % 3]));
    return CGAL::do_intersect(triangle_of(mesh, s), far_t) ||
           CGAL::do_intersect(triangle_of(mesh, t), far_s);
  }
  if (shared == 2) {
    // Hinged at an edge: they overlap only when folded flat onto each other.
    const Point a = point(s[in_s[0]]);
    const Point b = point(s[in_s[1]]);
    const Point c = point(s[3 - in_s[0] - in_s[1]]);
    const Point d = point(t[3 - in_t[0] - in_t[1]]);
    return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
  }
  return true;
}

}  // namespace

std::vector<TrianglePair> self_intersections(const TriangleMesh& mesh) {
  std::vector<Box> boxes = boxes_of(mesh);
  std::vector<TrianglePair> pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const int first = std::min(a.info(), b.info());
    const int second = std::max(a.info(), b.info());
    if (meet(mesh, mesh.triangles[first], mesh.triangles[second])) pairs.push_back({first, second});
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<TrianglePair> intersections(const TriangleMesh& first, const TriangleMesh& second) {
  std::vector<Box> first_boxes = boxes_of(first);
  std::vector<Box> second_boxes = boxes_of(second);
  std::vector<TrianglePair> pairs;
  CGAL::box_intersection_d(
      first_boxes.begin(), first_boxes.end(), second_boxes.begin(), second_boxes.end(),
      [&](const Box& a, const Box& b) {
        if (CGAL::do_intersect(triangle_of(first, first.triangles[a.info()]),
                               triangle_of(second, second.triangles[b.info()]))) {
          pairs.push_back({a.info(), b.info()});
        }
      });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace toile
