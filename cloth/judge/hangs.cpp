#include "cloth/judge/hangs.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "cloth/judge/constants.h"
#include "geometry/body/bones.h"
#include "geometry/body/flaws.h"

namespace toile {

namespace {

/// Per metre of a flat triangle in x and y, how much its height rises.
Vec2 slope_of(const Vec2 (&flat)[3], const Vec3& heights) {
  Eigen::Matrix2d edges;
  edges.row(0) = (flat[1] - flat[0]).transpose();
  edges.row(1) = (flat[2] - flat[0]).transpose();
  return edges.inverse() * Vec2(heights[1] - heights[0], heights[2] - heights[0]);
}

}  // namespace

bool PanelHang::is_turned() const {
  const double lengths = worn.norm() * placed.norm();
  return std::min(worn.norm(), placed.norm()) > min_hang && worn.dot(placed) < -min_hang * lengths;
}

std::vector<PanelHang> measure_hangs(const PanelMesh& garment, const DressedGarment& dressed,
                                     const Skeleton& skeleton) {
  struct Piece {
    double area;
    Vec2 slope;
    double outward;  // cosine between its outside and the direction away from the bones
  };
  std::map<BodyPart, Bones> bones;
  for (const std::string_view part : body_parts) {
    bones.emplace(body_part(part), Bones(skeleton, body_part(part)));
  }
  std::vector<PanelHang> hangs(garment.panels.size());
  std::vector<Piece> pieces;
  pieces.reserve(dressed.triangles.size());
  double outward = 0;
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    Vec2 flat[3];
    Vec3 at[3];
    Vec3 worn;
    Vec3 placed;
    for (int i = 0; i < 3; ++i) {
      const int point = garment.triangles[t][i];
      flat[i] = garment.flat[point];
      at[i] = dressed.points[dressed.triangles[t][i]];
      worn[i] = at[i].y();
      placed[i] = garment.placed[point].y();
    }
    const Vec2 along = flat[1] - flat[0];
    const Vec2 across = flat[2] - flat[0];
    const double area = (along.x() * across.y() - along.y() * across.x()) / 2;
    const Vec3 middle = (at[0] + at[1] + at[2]) / 3;
    const Bones& bone = bones.at(part_near(skeleton, middle));
    const Vec3 away = middle - bone.at(bone.foot(middle)).first;
    const Vec3 outside = (at[1] - at[0]).cross(at[2] - at[0]);
    PanelHang& hang = hangs[dressed.panel_of_triangle[t]];
    pieces.push_back({area, slope_of(flat, worn), outside.normalized().dot(away.normalized())});
    hang.area += area;
    hang.worn += area * pieces.back().slope;
    hang.placed += area * slope_of(flat, placed);
    outward += area * pieces.back().outward;
  }
  for (PanelHang& hang : hangs) {
    if (hang.area == 0) continue;
    hang.worn /= hang.area;
    hang.placed /= hang.area;
  }
  const double side = outward < 0 ? -1 : 1;
  for (std::size_t t = 0; t < pieces.size(); ++t) {
    PanelHang& hang = hangs[dressed.panel_of_triangle[t]];
    const bool is_down = pieces[t].slope.dot(hang.worn.normalized()) < -min_hang;
    if (is_down && side * pieces[t].outward < 0) hang.folded += pieces[t].area;
  }
  return hangs;
}

}  // namespace toile
