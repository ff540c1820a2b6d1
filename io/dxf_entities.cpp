#include "io/dxf_entities.h"

#include <cmath>
#include <numbers>

#include "geometry/angles.h"
#include "geometry/error.h"

namespace toile {

namespace {

double dxf_bulge(const DxfGroups& file, const DxfGroup& group) {
  const double value = file.number(group);
  if (std::abs(value) > 1e4) file.fail_at(group.line, "a bulge is " + number_text(value));
  return value;
}

}  // namespace

DxfVertex dxf_vertex(const DxfGroups& file, const DxfRecord& record) {
  DxfVertex vertex;
  for (const DxfGroup& group : record.groups) {
    if (group.code == 10) vertex.at.x() = file.coordinate(group);
    if (group.code == 20) vertex.at.y() = file.coordinate(group);
    if (group.code == 42) vertex.bulge = dxf_bulge(file, group);
    if (group.code == 70) vertex.flags = file.integer(group);
  }
  return vertex;
}

void append_dxf_sides(std::vector<DxfCurve>& curves, const std::vector<DxfVertex>& vertices,
                      bool closed) {
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    append_dxf_bulge(curves, vertices[i].at, vertices[i + 1].at, vertices[i].bulge);
  }
  if (closed && vertices.size() > 1 && vertices.back().at != vertices.front().at) {
    append_dxf_bulge(curves, vertices.back().at, vertices.front().at, vertices.back().bulge);
  }
}

std::vector<DxfCurve> dxf_lightweight_polyline(const DxfGroups& file, const DxfRecord& record) {
  std::vector<DxfVertex> vertices;
  bool closed = false;
  for (const DxfGroup& group : record.groups) {
    if (group.code == 70) closed = (file.integer(group) & 1) != 0;
    if (group.code == 10) {
      vertices.emplace_back();
      vertices.back().at.x() = file.coordinate(group);
    }
    if (vertices.empty()) continue;
    if (group.code == 20) vertices.back().at.y() = file.coordinate(group);
    if (group.code == 42) vertices.back().bulge = dxf_bulge(file, group);
  }
  std::vector<DxfCurve> curves;
  append_dxf_sides(curves, vertices, closed);
  return curves;
}

DxfCurve dxf_line(const DxfGroups& file, const DxfRecord& record) {
  Vec2 start = Vec2::Zero();
  Vec2 end = Vec2::Zero();
  for (const DxfGroup& group : record.groups) {
    if (group.code == 10) start.x() = file.coordinate(group);
    if (group.code == 20) start.y() = file.coordinate(group);
    if (group.code == 11) end.x() = file.coordinate(group);
    if (group.code == 21) end.y() = file.coordinate(group);
  }
  return dxf_line(start, end);
}

void read_dxf_arc(const DxfGroups& file, const DxfRecord& record, DxfEntity& entity) {
  double radius = 0;
  double from = 0;
  double to = 360;
  for (const DxfGroup& group : record.groups) {
    if (group.code == 10) entity.at.x() = file.coordinate(group);
    if (group.code == 20) entity.at.y() = file.coordinate(group);
    if (group.code == 40) radius = file.coordinate(group);
    if (group.code == 50) from = file.number(group);
    if (group.code == 51) to = file.number(group);
  }
  if (!(radius > 0)) file.fail_at(record.line, "an arc's radius is " + number_text(radius));
  from = std::remainder(from, 360);
  to = from + std::fmod(std::fmod(to - from, 360) + 360, 360);
  if (record.type == "CIRCLE" || to == from) to = from + 360;
  append_dxf_arc(entity.curves, entity.at, Vec2(radius, 0), Vec2(0, radius),
                 from * radians_per_degree, to * radians_per_degree);
  if (record.type == "CIRCLE") entity.curves.back().points[3] = entity.curves.front().points[0];
}

void read_dxf_ellipse(const DxfGroups& file, const DxfRecord& record, bool behind,
                      DxfEntity& entity) {
  Vec2 major = Vec2::Zero();
  double ratio = 1;
  double from = 0;
  double to = 2 * std::numbers::pi;
  for (const DxfGroup& group : record.groups) {
    if (group.code == 10) entity.at.x() = file.coordinate(group);
    if (group.code == 20) entity.at.y() = file.coordinate(group);
    if (group.code == 11) major.x() = file.coordinate(group);
    if (group.code == 21) major.y() = file.coordinate(group);
    if (group.code == 40) ratio = file.number(group);
    if (group.code == 41) from = file.number(group);
    if (group.code == 42) to = file.number(group);
  }
  if (major.squaredNorm() == 0 || !(std::abs(ratio) <= 1))
    file.fail_at(record.line, "is no ellipse");
  constexpr double turn = 2 * std::numbers::pi;
  from = std::remainder(from, turn);
  to = from + std::fmod(std::fmod(to - from, turn) + turn, turn);
  if (to - from < 1e-9) to = from + turn;
  const Vec2 minor = (behind ? -ratio : ratio) * Vec2(-major.y(), major.x());
  append_dxf_arc(entity.curves, entity.at, major, minor, from, to);
}

DxfSpline dxf_spline(const DxfGroups& file, const DxfRecord& record) {
  DxfSpline spline;
  for (const DxfGroup& group : record.groups) {
    const auto last = [&](std::vector<Vec2>& points) -> Vec2& {
      if (points.empty()) points.emplace_back(Vec2::Zero());
      return points.back();
    };
    switch (group.code) {
      case 71:
        spline.degree = file.integer(group);
        break;
      case 40:
        spline.knots.push_back(file.number(group));
        break;
      case 41:
        spline.weights.push_back(file.number(group));
        break;
      case 10:
        spline.control_points.emplace_back(file.coordinate(group), 0);
        break;
      case 20:
        last(spline.control_points).y() = file.coordinate(group);
        break;
      case 11:
        spline.fit_points.emplace_back(file.coordinate(group), 0);
        break;
      case 21:
        last(spline.fit_points).y() = file.coordinate(group);
        break;
      default:
        break;
    }
  }
  const std::string problem = spline_problem(spline);
  if (!problem.empty()) file.fail_at(record.line, "a spline " + problem);
  return spline;
}

}  // namespace toile
