// Strain, pressure and contact of cloth on cylinders, as ease-map tells them of a drape that is
// held off the skin [reference case 8].
#include "cloth/loads/loads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "cloth/loads/inner_face.h"
#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "cloth/scene/collider.h"
#include "tests/cloth/panels.h"
#include "tests/support/tubes.h"
#include "tests/validation/report.h"

namespace toile {
namespace loads_test {

constexpr double pi = std::numbers::pi;
constexpr double height = 0.09;

/// A tube of cloth at rest around a cylinder. As in dress, the offset holds it off the body, and so
/// are the middles of its edges.
struct WornTube {
  PanelMesh garment;
  GarmentModel model;
  std::vector<Vec3> nodes;
  Loads loads;
};

/// `strain`: of the tube's girth at rest against the cylinder's.
WornTube worn_on(double radius, double strain, double edge, double offset, const Fabric& fabric) {
  const Collider body(test::closed_tube(radius, radius, 0.3, 720));
  WornTube tube;
  const double girth = 2 * pi * radius / (1 + strain);
  const int sides = static_cast<int>(std::lround(girth / edge));
  const int rows = static_cast<int>(std::lround(height / edge));
  const double start = (radius + 1.5 * offset) / (1 - edge * edge / (8 * radius * radius));
  test::add_panel(tube.garment, "tube", test::grid(girth, height, sides, rows), [&](const Vec2& p) {
    const double angle = 2 * pi * p.x() / girth;
    return Vec3(start * std::sin(angle), 0.1 + p.y(), start * std::cos(angle));
  });
  tube.garment.edge_length = edge;
  tube.garment.seams = {test::seam("", test::side(tube.garment.panels[0], sides, rows, false),
                                   test::side(tube.garment.panels[0], sides, rows, true))};
  Scene scene;
  scene.collider = &body;
  scene.self_contact = false;
  scene.fabric = fabric;
  tube.model = compile(tube.garment, scene, tube.garment.placed, offset);
  RelaxOptions options;
  options.max_iterations = 40000;
  options.friction = true;
  options.bounded_by_body = true;
  options.stop_median = options.stop_rms = 1e-2;
  tube.nodes = tube.model.start;
  EXPECT_TRUE(relax(tube.model, options, tube.nodes).converged) << radius << ' ' << edge;
  tube.loads = measure_loads(tube.model, tube.nodes, body.skin(), offset + contact_margin);
  return tube;
}

struct Means {
  double strain = 0;
  double pressure = 0;
};

/// Over the whole tube, by area.
Means means_of(const WornTube& tube) {
  Means means;
  double area = 0;
  for (const TriangleLoad& load : tube.loads.triangles) {
    area += load.area;
    means.strain += load.area * load.strain_weft;
  }
  means.strain /= area;
  double force = 0;
  double pressed = 0;
  for (const NodeLoad& load : tube.loads.nodes) {
    EXPECT_TRUE(load.touches);
    force += load.area * load.pressure;
    pressed += load.area;
  }
  means.pressure = force / pressed;
  return means;
}

TEST(Loads, OfTubesOnCylindersAreLaplaces) {
  Fabric fabric;
  fabric.stretch_weft = 500;
  for (const auto& [edge, offset, bound] :
       {std::tuple(0.015, 0.002, 0.02), {0.005, 0.002, 0.005}, {0.025, 0.0036, 0.05}}) {
    for (const double radius : {0.025, 0.05, 0.1, 0.2}) {
      for (const double strain : {0.005, 0.05}) {
        const Means means = means_of(worn_on(radius, strain, edge, offset, fabric));
        const std::string tube = "tube " + test::number(100 * strain, 2) +
                                 " % too small on a cylinder of " + test::number(100 * radius) +
                                 " cm, held off by " + test::number(1000 * offset) + " mm: ";
        const std::string mesh = test::number(1000 * edge, 2) + " mm";
        const double tension = fabric.stretch_weft * strain;
        test::Figure of_strain{tube + "hoop strain of the inner face", "loads", mesh, "%"};
        test::expect_near(of_strain, 100 * means.strain, 100 * strain, 0.005);
        test::Figure of_pressure{tube + "pressure", "loads", mesh, "Pa"};
        if (strain > 0.01) {
          test::expect_relative(of_pressure, means.pressure, tension / radius, bound);
        } else {
          test::state(of_pressure, means.pressure, test::number(tension / radius) + " Pa");
        }
      }
    }
  }
}

}  // namespace loads_test
}  // namespace toile
