#include "geometry/slice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "geometry/convex_hull.h"
#include "geometry/polygon.h"

namespace toile {

namespace {

// An edge of the mesh as its two vertices, the one below the plane first. So both triangles at the
// edge have the same Edge and the same cut point.
using Edge = std::pair<int, int>;

// The cut through one triangle.
struct Cut {
  int triangle;
  Edge enter;  // the edge on which the triangle's border comes down through the plane
  Edge leave;  // the edge on which it goes up; the next triangle enters there
};

// `above`: per point, 1 above the plane or in it, else 0.
std::vector<Cut> cut_triangles(const TriangleMesh& mesh, const std::vector<char>& above) {
  std::vector<Cut> cuts;
  // Few triangles are cut. All others are told by three bytes.
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    const int corners_above = above[triangle[0]] + above[triangle[1]] + above[triangle[2]];
    if (corners_above == 0 || corners_above == 3) continue;
    Cut cut{static_cast<int>(t), {}, {}};
    int crossings = 0;
    for (int side = 0; side < 3; ++side) {
      const int from = triangle[side];
      const int to = triangle[(side + 1) % 3];
      const bool from_above = above[from] != 0;
      if (from_above == (above[to] != 0)) continue;
      ++crossings;
      if (from_above) {
        cut.enter = {to, from};
      } else {
        cut.leave = {from, to};
      }
    }
    if (crossings == 2) cuts.push_back(cut);
  }
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const Cut& a, const Cut& b) { return a.enter < b.enter; });
  return cuts;
}

// Two unit vectors that span the plane; (u, v, normal) is right-handed.
std::pair<Vec3, Vec3> plane_axes(const Vec3& unit_normal) {
  const Vec3 u = unit_normal.unitOrthogonal();
  return {u, unit_normal.cross(u)};
}

double cross(const Vec2& o, const Vec2& a, const Vec2& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

// The perimeter of the convex hull.
double hull_length(const std::vector<Vec2>& points) {
  const std::vector<int> hull = convex_hull(points);
  double length = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    length += (points[hull[(i + 1) % hull.size()]] - points[hull[i]]).norm();
  }
  return length;
}

std::vector<Vec2> in_plane(const std::vector<Vec3>& points, const Vec3& u, const Vec3& v) {
  std::vector<Vec2> flat;
  flat.reserve(points.size());
  for (const Vec3& point : points) flat.emplace_back(u.dot(point), v.dot(point));
  return flat;
}

void measure(Section& section, const Vec3& unit_normal) {
  const auto [u, v] = plane_axes(unit_normal);
  const std::size_t n = section.points.size();
  Vec3 along = Vec3::Zero();
  for (std::size_t i = 0; i + (section.closed ? 0 : 1) < n; ++i) {
    const Vec3& a = section.points[i];
    const Vec3& b = section.points[(i + 1) % n];
    section.length += (b - a).norm();
    along += (b - a).norm() * (a + b) / 2;
  }
  const Vec3& first = section.points.front();
  section.centroid = section.length > 0 ? Vec3(along / section.length) : first;
  const std::vector<Vec2> flat = in_plane(section.points, u, v);
  section.girth = hull_length(flat);
  if (!section.closed) return;
  // The area is summed over a fan of triangles from the first point. That keeps the sums small far
  // from the origin.
  Vec3 moment = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double part = cross(flat[0], flat[i], flat[i + 1]) / 2;
    section.area += part;
    moment += part * ((section.points[i] - first) + (section.points[i + 1] - first)) / 3;
  }
  if (std::abs(section.area) > 1e-9 * section.length * section.length) {
    section.centroid = first + moment / section.area;
  }
}

}  // namespace

bool contains(const Section& section, const Vec3& point, const Vec3& normal) {
  if (!section.closed) return false;
  const Vec3 u = normal.unitOrthogonal();
  const Vec3 v = normal.normalized().cross(u);
  std::vector<Vec2> outline;
  outline.reserve(section.points.size());
  for (const Vec3& corner : section.points) outline.emplace_back(u.dot(corner), v.dot(corner));
  return inside(outline, {u.dot(point), v.dot(point)});
}

double widest_chord(const Section& section) {
  double most = 0;
  for (const Vec3& a : section.points) {
    for (const Vec3& b : section.points) most = std::max(most, (a - b).squaredNorm());
  }
  return std::sqrt(most);
}

std::vector<Section> slice(const TriangleMesh& mesh, const Vec3& origin, const Vec3& normal) {
  const Vec3 unit_normal = normal.normalized();
  const auto height = [&](std::size_t p) { return unit_normal.dot(mesh.points[p] - origin); };
  std::vector<char> is_above(mesh.points.size());
  for (std::size_t p = 0; p < is_above.size(); ++p) is_above[p] = static_cast<char>(height(p) >= 0);
  const std::vector<Cut> cuts = cut_triangles(mesh, is_above);
  const auto point_on = [&](const Edge& edge) -> Vec3 {
    const double below = height(edge.first);
    const double above = height(edge.second);
    const double t = below / (below - above);
    return mesh.points[edge.first] + t * (mesh.points[edge.second] - mesh.points[edge.first]);
  };

  // The cut after a cut enters where that one leaves. Open polylines are followed from their
  // beginnings first, so that none starts in its middle.
  std::vector<int> next(cuts.size(), -1);
  std::vector<char> has_previous(cuts.size(), 0);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    auto found =
        std::lower_bound(cuts.begin(), cuts.end(), cuts[i].leave,
                         [](const Cut& cut, const Edge& edge) { return cut.enter < edge; });
    // At an edge of more than two triangles, the first cut without a previous one comes next.
    while (found != cuts.end() && found->enter == cuts[i].leave &&
           has_previous[found - cuts.begin()]) {
      ++found;
    }
    if (found == cuts.end() || found->enter != cuts[i].leave) continue;
    next[i] = static_cast<int>(found - cuts.begin());
    has_previous[next[i]] = 1;
  }

  std::vector<Section> sections;
  std::vector<char> used(cuts.size(), 0);
  const auto follow = [&](int start) {
    Section section;
    const auto add = [&](const Vec3& point) {
      if (section.points.empty() || section.points.back() != point) {
        section.points.push_back(point);
      }
    };
    int at = start;
    int last = start;
    for (; at >= 0 && !used[at]; at = next[at]) {
      used[at] = 1;
      add(point_on(cuts[at].enter));
      section.triangles.push_back(cuts[at].triangle);
      last = at;
    }
    section.closed = at == start;
    if (!section.closed) add(point_on(cuts[last].leave));
    while (section.closed && section.points.size() > 1 &&
           section.points.front() == section.points.back()) {
      section.points.pop_back();
    }
    measure(section, unit_normal);
    sections.push_back(std::move(section));
  };
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      if (!used[i] && (pass == 1 || !has_previous[i])) follow(static_cast<int>(i));
    }
  }
  std::stable_sort(sections.begin(), sections.end(),
                   [](const Section& a, const Section& b) { return a.area > b.area; });
  return sections;
}

double hull_length(const std::vector<Vec3>& points, const Vec3& normal) {
  const auto [u, v] = plane_axes(normal.normalized());
  return hull_length(in_plane(points, u, v));
}

}  // namespace toile
