// Strips of each fabric, hung up: what a tensile test measures on them is what the fabric says.
#include <gtest/gtest.h>

#include <numbers>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "cloth/scene/collider.h"
#include "geometry/distance_grid.h"
#include "tests/cloth/panels.h"
#include "tests/support/tubes.h"

namespace toile {
namespace fabric_strip_test {

constexpr double pi = std::numbers::pi;

/// Modulus, N/m, of a strip cut at `angle` to the weft and free to narrow and to skew, at small
/// strain [Jones 1999, Mechanics of Composite Materials, 2.6, without contraction across].
double modulus(const Fabric& fabric, double angle) {
  const double weft = std::pow(std::cos(angle), 2);
  const double warp = 1 - weft;
  return 1 / (weft * weft / fabric.stretch_weft + warp * warp / fabric.stretch_warp +
              weft * warp / fabric.shear);
}

/// A bar along x.
const Collider& bar(double radius) {
  static const Collider collider = [&] {
    TriangleMesh mesh = test::closed_tube(radius, radius, 0.2, 100);
    for (Vec3& p : mesh.points) p = Vec3(p.y() - 0.09, -p.x(), p.z());
    return Collider{mesh};
  }();
  return collider;
}

/// N/m: the measured modulus of a strip whose warp lies at `grain` radians to its length. The strip
/// hangs over a bar, under as much gravity as strains it by half a percent.
double measured(const Fabric& fabric, double grain) {
  constexpr double radius = 0.02, edge = 0.01;
  constexpr int columns = 2, rows = 70;
  const double length = rows * edge;
  PanelMesh garment;
  MeshedPanel& panel = test::add_panel(
      garment, "strip", test::grid(columns * edge, length, columns, rows), [&](const Vec2& p) {
        const double r = radius + 0.002;
        const double s = p.y() - length / 2;
        const double arc = std::clamp(s, -r * pi / 2, r * pi / 2);
        return Vec3(p.x(), r * std::cos(arc / r) - (std::abs(s) - std::abs(arc)),
                    r * std::sin(arc / r));
      });
  panel.grain = grain;
  Scene scene;
  scene.collider = &bar(radius);
  scene.body_contact = BodyContactTerm::nodes;
  scene.fabric = fabric;
  scene.self_contact = false;
  const double wanted = modulus(fabric, grain + pi / 2);
  scene.gravity *= 0.005 * wanted / (fabric.areal_density * 9.81 * length / 2);
  const GarmentModel model = compile(garment, scene, garment.placed);
  std::vector<Vec3> x = model.start;
  RelaxOptions options;
  options.max_iterations = 30000;
  // On the bar, very soft cloth may stick and slip without an end; it is the hanging that counts.
  options.stop_median = 1e-3;
  options.stop_rms = 10;
  EXPECT_TRUE(relax(model, options, x).converged) << fabric.name;
  // By least squares over the middle of the hanging part, along the middle of the strip.
  double load_strain = 0, strain_strain = 0;
  for (int row = 8; row < rows / 2 - 12; ++row) {
    const int a = row * (columns + 1) + 1;
    const double strain = (x[a + columns + 1] - x[a]).norm() / edge - 1;
    const double load = fabric.areal_density * scene.gravity.norm() * (row + 0.5) * edge;
    load_strain += load * strain;
    strain_strain += strain * strain;
  }
  return load_strain / strain_strain;
}

TEST(FabricStrip, EachFabricStretchesAlongWarpWeftAndBiasAsItSays) {
  double worst = 0;
  for (const std::string& name : fabric_names()) {
    const Fabric fabric = find_fabric(name);
    for (const double degrees : {0.0, 90.0, 45.0}) {
      const double grain = degrees * pi / 180;
      const double wanted = modulus(fabric, grain + pi / 2);
      const double error = measured(fabric, grain) / wanted - 1;
      std::cout << name << ", warp at " << degrees << " degrees: " << wanted << " N/m, off by "
                << 100 * error << " %\n";
      worst = std::max(worst, std::abs(error));
    }
  }
  EXPECT_LT(worst, 0.02);
}

}  // namespace fabric_strip_test
}  // namespace toile
