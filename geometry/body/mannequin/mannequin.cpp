#include "geometry/body/mannequin/mannequin.h"

#include <algorithm>
#include <tuple>

#include "geometry/body/mannequin/mannequin_shape.h"
#include "geometry/body/mannequin/posed_mannequin.h"
#include "geometry/error.h"
#include "geometry/implicit_mesh.h"
#include "geometry/slice.h"

namespace toile {

bool is_one_sphere(const TriangleMesh& mesh) {
  return mesh.points.size() - mesh.triangles.size() / 2 == 2;
}

double girth_around(const TriangleMesh& surface, const Vec3& centre, const Vec3& normal) {
  const std::vector<Section> sections = slice(surface, centre, normal);
  const auto nearest =
      std::min_element(sections.begin(), sections.end(), [&](const Section& a, const Section& b) {
        return (a.centroid - centre).squaredNorm() < (b.centroid - centre).squaredNorm();
      });
  if (nearest == sections.end())
    throw Error("girth", "its plane does not meet the body", "is the skeleton that of this body?");
  return nearest->girth;
}

Mannequin make_mannequin(const MannequinOptions& options) {
  return mesh_mannequin(sample_shape(), options);
}

Mannequin mesh_mannequin(const MannequinShape& shape, const MannequinOptions& options) {
  if (!(options.edge_length >= 0.004 && options.edge_length <= 0.015)) {
    throw Error("edge length", "is not between 4 mm and 15 mm", "9 mm is usual");
  }
  check_pose(options.pose, "pose");
  ImplicitMeshOptions meshing;
  meshing.spacing = options.edge_length / 0.9;
  Mannequin mannequin;
  const PosedMannequin posed(shape, options.pose);
  if (options.pose == standing_pose()) {
    meshing.low = shape.bones().low;
    meshing.high = shape.bones().high;
    mannequin.surface =
        mesh_implicit([&shape](const Vec3& point) { return shape.distance(point); }, meshing);
  } else {
    std::tie(meshing.low, meshing.high) = posed.box();
    mannequin.surface =
        mesh_implicit([&posed](const Vec3& point) { return posed.distance(point); }, meshing);
    if (!is_one_sphere(mannequin.surface)) {
      throw Error(options.pose_name, "parts of the body touch one another", "move them apart");
    }
  }

  // The soles are flat at y = 0 up to rounding.
  double floor = 1;
  for (const Vec3& point : mannequin.surface.points) floor = std::min(floor, point.y());
  for (Vec3& point : mannequin.surface.points) point.y() -= floor;
  mannequin.skeleton = posed.skeleton();
  for (auto& [name, joint] : mannequin.skeleton.joints) joint.y() -= floor;

  for (const GirthTarget& target : shape.girths()) {
    MannequinGirth girth;
    girth.name = target.name;
    girth.centre = posed.centre(target) - floor * Vec3::UnitY();
    girth.normal = posed.normal(target);
    girth.target = target.girth;
    girth.measured = girth_around(mannequin.surface, girth.centre, girth.normal);
    mannequin.girths.push_back(girth);
  }
  return mannequin;
}

}  // namespace toile
