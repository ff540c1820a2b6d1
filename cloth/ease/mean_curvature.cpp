#include "cloth/ease/mean_curvature.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace toile {

std::vector<double> mean_curvatures(const TriangleMesh& mesh) {
  const std::size_t count = mesh.points.size();
  std::vector<Vec3> bends(count, Vec3::Zero());
  std::vector<Vec3> normals(count, Vec3::Zero());
  std::vector<double> areas(count, 0);
  std::vector<std::pair<int, int>> sides;  // of the triangles, the smaller end first
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3 corners[] = {mesh.points[triangle[0]], mesh.points[triangle[1]],
                            mesh.points[triangle[2]]};
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double doubled = normal.norm();
    for (int k = 0; k < 3; ++k) {
      const int a = triangle[(k + 1) % 3];
      const int b = triangle[(k + 2) % 3];
      sides.emplace_back(std::min(a, b), std::max(a, b));
      normals[triangle[k]] += normal;
      areas[triangle[k]] += doubled / 6;
      if (doubled <= 0) continue;
      const Vec3 to_a = corners[(k + 1) % 3] - corners[k];
      const Vec3 to_b = corners[(k + 2) % 3] - corners[k];
      const Vec3 pull = to_a.dot(to_b) / doubled * (to_a - to_b);
      bends[a] += pull;
      bends[b] -= pull;
    }
  }
  std::ranges::sort(sides);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t next = i;
    while (next < sides.size() && sides[next] == sides[i]) ++next;
    if (next - i == 1) areas[sides[i].first] = areas[sides[i].second] = 0;  // of the border
    i = next;
  }
  std::vector<double> curvatures(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (areas[i] <= 0 || normals[i].norm() <= 0) continue;
    curvatures[i] = bends[i].dot(normals[i].normalized()) / (4 * areas[i]);
  }
  return curvatures;
}

}  // namespace toile
