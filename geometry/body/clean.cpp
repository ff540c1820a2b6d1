#include "geometry/body/clean.h"

#include <Eigen/Geometry>
#include <array>
#include <cstdio>
#include <utility>

#include "geometry/error.h"

namespace toile {

namespace {

using Box = Eigen::AlignedBox3d;

Box bounds(const TriangleMesh& mesh) {
  Box box;
  for (const Vec3& point : mesh.points) box.extend(point);
  return box;
}

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

double inferred_unit(double height, const std::string& name) {
  for (const double unit : {1.0, 0.1, 0.01, 0.001, 0.0254}) {
    if (height * unit >= 1.0 && height * unit <= 2.3) return unit;
  }
  throw Error(name,
              "a body " + number(height) +
                  " units tall is between 1.00 and 2.30 m in none of m, dm, cm, mm, in",
              "give --unit");
}

// A standing body is least deep from front to back, and its arms reach hardly farther than it is
// tall. So only a body that is clearly longer along z than along y lies on its back or is z-up,
// and z-up programs let it face -y: both stand up facing +z by the same quarter turn.
std::string stand_up(TriangleMesh& mesh) {
  const Vec3 size = bounds(mesh).sizes();
  std::string turned;
  if (size.z() > 1.5 * size.y() && size.z() >= 0.8 * size.x()) {
    for (Vec3& p : mesh.points) p = Vec3(p.x(), p.z(), -p.y());
    turned = "from z up to y up";
  }
  return turned;
}

}  // namespace

CleanBody clean_body(const PolygonSoup& soup, const std::string& name,
                     const CleanOptions& options) {
  CleanBody body;
  RepairedSurface surface = repair(soup, name, options.repair);
  body.mesh = std::move(surface.mesh);
  CleanReport& report = body.report;
  report.repair = surface.report;
  report.turned = stand_up(body.mesh);

  const double units_tall = bounds(body.mesh).sizes().y();
  report.unit_inferred = !options.metres_per_unit;
  report.metres_per_unit =
      options.metres_per_unit ? *options.metres_per_unit : inferred_unit(units_tall, name);
  report.height = units_tall * report.metres_per_unit;
  if (report.height < 0.1 || report.height > 10) {
    throw Error(name, "the body would be " + number(report.height) + " m tall",
                "give the unit that the file is in with --unit");
  }
  if (report.metres_per_unit != 1) {
    for (Vec3& p : body.mesh.points) p *= report.metres_per_unit;
  }
  const double floor = bounds(body.mesh).min().y();
  if (floor != 0) {
    for (Vec3& p : body.mesh.points) p.y() -= floor;
    report.lifted = -floor;
  }
  return body;
}

}  // namespace toile
