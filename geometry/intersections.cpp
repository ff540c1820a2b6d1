#include "geometry/intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <variant>

#include "geometry/parallel.h"
#include "geometry/triangle_tree.h"

namespace toile {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

Point to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

struct Box {
  Vec3 low;
  Vec3 high;
};

Box box_of(const TriangleMesh& mesh, int triangle) {
  const Triangle& corners = mesh.triangles[triangle];
  const Vec3& a = mesh.points[corners[0]];
  const Vec3& b = mesh.points[corners[1]];
  const Vec3& c = mesh.points[corners[2]];
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

Box box_of(const TriangleMesh& mesh) {
  Box box{mesh.points.front(), mesh.points.front()};
  for (const Vec3& p : mesh.points) box = {box.low.cwiseMin(p), box.high.cwiseMax(p)};
  return box;
}

bool overlap(const Box& a, const Box& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

/// Triangles that a task queries.
constexpr std::size_t triangle_grain = 256;

/// The pairs (triangle of `querying`, triangle of `tree_mesh`) whose boxes meet and that pass
/// `test`.
template <class Test>
std::vector<TrianglePair> pairs_that(const TriangleMesh& querying, const TriangleMesh& tree_mesh,
                                     const Test& test) {
  std::vector<TrianglePair> pairs;
  if (querying.triangles.empty() || tree_mesh.triangles.empty()) return pairs;
  const TriangleTree tree(tree_mesh);
  const Box all = box_of(tree_mesh);
  const std::size_t count = querying.triangles.size();
  std::vector<std::vector<TrianglePair>> found(chunks_of(count, triangle_grain));
  parallel_for_ranges(count, triangle_grain, [&](std::size_t begin, std::size_t end) {
    std::vector<int> near;
    for (int a = static_cast<int>(begin); a < static_cast<int>(end); ++a) {
      const Box box = box_of(querying, a);
      // Of a body, head and legs are far from most garments.
      if (!overlap(box, all)) continue;
      near.clear();
      tree.meeting(box.low, box.high, near);
      for (const int b : near) {
        if (overlap(box, box_of(tree_mesh, b)) && test(a, b)) {
          found[begin / triangle_grain].push_back({a, b});
        }
      }
    }
  });
  for (const auto& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  return pairs;
}

/// The set of a triangle's points. Without area it is a segment or one point, which CGAL's test for
/// triangles does not handle.
using Primitive = std::variant<Kernel::Triangle_3, Kernel::Segment_3, Point>;

Primitive segment_or_point(const Point& a, const Point& b) {
  if (a == b) return a;
  return Kernel::Segment_3(a, b);
}

Primitive primitive_of(const TriangleMesh& mesh, const Triangle& corners) {
  const Point a = to_cgal(mesh.points[corners[0]]);
  const Point b = to_cgal(mesh.points[corners[1]]);
  const Point c = to_cgal(mesh.points[corners[2]]);
  if (!CGAL::collinear(a, b, c)) return Kernel::Triangle_3(a, b, c);
  const auto [first, last] = std::minmax({a, b, c});
  return segment_or_point(first, last);
}

bool meet(const Primitive& s, const Primitive& t) {
  return std::visit([](const auto& a, const auto& b) { return CGAL::do_intersect(a, b); }, s, t);
}

/// Whether two triangles of one mesh meet beyond what they share.
bool meet(const TriangleMesh& mesh, const Triangle& s, const Triangle& t) {
  // Finds the corners that both share: in_s[k] of s is in_t[k] of t.
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
  if (shared == 0) return meet(primitive_of(mesh, s), primitive_of(mesh, t));
  const auto point = [&](int index) { return to_cgal(mesh.points[index]); };
  if (shared == 1) {
    // Two triangles that share a vertex meet elsewhere only if one's far edge meets the other.
    const int i = in_s[0];
    const int j = in_t[0];
    const Primitive far_s = segment_or_point(point(s[(i + 1) % 3]), point(s[(i + 2) % 3]));
    const Primitive far_t = segment_or_point(point(t[(j + 1) % 3]), point(t[(j + 2) % 3]));
    return meet(primitive_of(mesh, s), far_t) || meet(primitive_of(mesh, t), far_s);
  }
  if (shared == 2) {
    // Two triangles that share an edge overlap only when they are folded flat onto each other.
    const Point a = point(s[in_s[0]]);
    const Point b = point(s[in_s[1]]);
    const Point c = point(s[3 - in_s[0] - in_s[1]]);
    const Point d = point(t[3 - in_t[0] - in_t[1]]);
    // A triangle without area lies on the shared edge or on its extension, and does not count.
    return CGAL::coplanar(a, b, c, d) && !CGAL::collinear(a, b, c) && !CGAL::collinear(a, b, d) &&
           CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
  }
  return true;
}

}  // namespace

std::vector<TrianglePair> self_intersections(const TriangleMesh& mesh) {
  std::vector<TrianglePair> pairs = pairs_that(mesh, mesh, [&](int a, int b) {
    return a < b && meet(mesh, mesh.triangles[a], mesh.triangles[b]);
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<TrianglePair> intersections(const TriangleMesh& first, const TriangleMesh& second) {
  const auto meets = [&](int a, int b) {
    return meet(primitive_of(first, first.triangles[a]), primitive_of(second, second.triangles[b]));
  };
  std::vector<TrianglePair> pairs;
  // A tree of the smaller mesh is cheaper to build. Most triangles of the larger mesh are far from
  // it, so their queries end at once.
  if (second.triangles.size() <= first.triangles.size()) {
    pairs = pairs_that(first, second, meets);
  } else {
    pairs = pairs_that(second, first, [&](int b, int a) { return meets(a, b); });
    for (TrianglePair& pair : pairs) std::swap(pair[0], pair[1]);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace toile
