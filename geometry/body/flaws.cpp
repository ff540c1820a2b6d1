#include "geometry/body/flaws.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <vector>

#include "geometry/body/bones.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

double area_of(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3& a = mesh.points[t[0]];
  return (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).norm() / 2;
}

}  // namespace

BodyPart part_near(const Skeleton& skeleton, const Vec3& point) {
  BodyPart nearest = BodyPart::none;
  double least = std::numeric_limits<double>::max();
  for (const std::string_view name : body_parts) {
    const Bones bones(skeleton, body_part(name));
    if (bones.joints.empty()) continue;
    const double distance = bones.distance(point);
    if (distance >= least) continue;
    least = distance;
    nearest = body_part(name);
  }
  return nearest;
}

std::optional<Crossings> crossings_of(const TriangleMesh& mesh,
                                      const std::optional<Skeleton>& skeleton) {
  const std::vector<TrianglePair> pairs = self_intersections(mesh);
  if (pairs.empty()) return std::nullopt;
  std::vector<int> crossing;
  for (const TrianglePair& pair : pairs) crossing.insert(crossing.end(), pair.begin(), pair.end());
  std::sort(crossing.begin(), crossing.end());
  crossing.erase(std::unique(crossing.begin(), crossing.end()), crossing.end());

  Crossings found;
  found.pairs = static_cast<int>(pairs.size());
  double whole = 0;
  for (const Triangle& t : mesh.triangles) whole += area_of(mesh, t);
  std::vector<double> heights;
  std::map<BodyPart, int> parts;
  for (const int index : crossing) {
    const Triangle& t = mesh.triangles[index];
    const Vec3 middle = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    found.area_share += area_of(mesh, t) / whole;
    heights.push_back(middle.y());
    if (skeleton) ++parts[part_near(*skeleton, middle)];
  }
  std::sort(heights.begin(), heights.end());
  found.low = heights[heights.size() / 20];
  found.high = heights[heights.size() - 1 - heights.size() / 20];
  const auto most = std::max_element(
      parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most != parts.end()) found.part = most->first;
  return found;
}

}  // namespace toile
