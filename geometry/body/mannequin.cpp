#include "geometry/body/mannequin.h"

#include <algorithm>

#include "geometry/body/mannequin_shape.h"
#include "geometry/error.h"
#include "geometry/implicit_mesh.h"
#include "geometry/slice.h"

namespace toile {

double girth_around(const TriangleMesh& surface, const Vec3& centre, const Vec3& normal) {
  const std::vector<Section> sections = slice(surface, centre, normal);
  const auto nearest =
      std::min_element(sections.begin(), sections.end(), [&](const Section& a, const Section& b) {
        return (a.centroid - centre).squaredNorm() < (b.centroid - centre).squaredNorm();
      });
  if (nearest == sections.end()) throw Error("girth", "its plane does not meet the body", "");
  return nearest->girth;
}

Mannequin make_mannequin(const MannequinOptions& options) {
  if (!(options.edge_length >= 0.004 && options.edge_length <= 0.015)) {
    throw Error("edge length", "is not between 4 mm and 15 mm", "9 mm is usual");
  }
  MannequinShape shape;
  constexpr double tolerance = 2e-4;
  shape.carve(tolerance);

  ImplicitMeshOptions meshing;
  meshing.low = Vec3(-0.75, -0.01, -0.25);
  meshing.high = Vec3(0.75, 1.72, 0.25);
  meshing.spacing = options.edge_length / 0.9;
  Mannequin mannequin;
  mannequin.surface =
      mesh_implicit([&shape](const Vec3& point) { return shape.distance(point); }, meshing);

  // The soles are flat at y = 0 but for rounding.
  double floor = 1;
  for (const Vec3& point : mannequin.surface.points) floor = std::min(floor, point.y());
  for (Vec3& point : mannequin.surface.points) point.y() -= floor;

  for (const GirthTarget& target : girth_targets()) {
    MannequinGirth girth;
    girth.name = target.name;
    girth.centre = shape.centre(target);
    girth.normal = shape.normal(target);
    girth.target = target.girth;
    girth.measured = girth_around(mannequin.surface, girth.centre, girth.normal);
    mannequin.girths.push_back(girth);
  }
  return mannequin;
}

}  // namespace toile
