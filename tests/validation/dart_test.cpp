// Darts: a panel sewn to itself along two edges that meet in a point.
#include <gtest/gtest.h>

#include <iostream>
#include <sstream>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "geometry/angles.h"
#include "tests/pattern/samples.h"
#include "tests/pattern/sewn.h"

namespace toile {
namespace dart_test {

/// A disc of 15 cm with a sector of `taken` degrees cut out, whose sides are sewn to each other,
/// placed as a shallow dish.
PanelMesh disc(double taken) {
  std::ostringstream vertices;
  vertices << "[[0,0]";
  for (int i = 0; i <= 3; ++i) {
    const double angle = to_radians(taken / 2 + i * (360 - taken) / 3);
    vertices << ",[" << 15 * std::cos(angle) << "," << 15 * std::sin(angle) << "]";
  }
  std::ostringstream panel;
  panel << R"("disc": {"vertices": )" << vertices.str() << R"(], "edges": [{"endpoints": [0,1]})";
  for (int i = 1; i <= 3; ++i) {
    panel << R"(, {"endpoints": [)" << i << "," << i + 1
          << R"(], "curvature": {"type": "circle", "params": [15, 0, 1]}})";
  }
  panel << R"(, {"endpoints": [4,0]}]})";
  std::vector<Remark> remarks;
  const Pattern pattern = samples::parse(samples::file(
      panel.str(), R"([{"panel": "disc", "edge": 0}, {"panel": "disc", "edge": 4}])"));
  check_pattern(pattern, remarks);
  PanelMesh mesh = mesh_panels(pattern, {.edge_length = 0.01}, remarks);
  for (const Remark& remark : remarks) ADD_FAILURE() << remark.text;
  for (Vec3& p : mesh.placed) p.z() = 0.02 - 0.1 * std::hypot(p.x(), p.y());
  return mesh;
}

// Sewn up, its rim is (360 - taken)/360 as long: a cone of half angle asin(1 - taken/360).
TEST(Dart, OfADiscMakesACone) {
  for (const double taken : {20.0, 60.0}) {
    const PanelMesh mesh = disc(taken);
    for (int coarser = 0; coarser <= mesh.subdivisions; ++coarser) {
      EXPECT_EQ(samples::sewn_fault(mesh, coarser), "") << coarser;
    }
    const MeshedSeam& dart = mesh.seams.at(0);
    int tips = 0;
    for (std::size_t i = 0; i < dart.a.size(); ++i) tips += dart.a[i] == dart.b[i];
    EXPECT_EQ(tips, 1);
    const GarmentModel model = compile(mesh, {}, mesh.placed);
    int across = 0;
    for (const BendHinge& hinge : model.bend) across += hinge.across_seam;
    EXPECT_EQ(across, static_cast<int>(dart.a.size()) - 1);
    std::vector<Vec3> x = model.start;
    RelaxOptions options;
    options.gravity = 0;
    options.friction = false;
    options.bounded = true;
    options.closing_iterations = 1000;
    options.max_iterations = 4000;
    EXPECT_TRUE(relax(model, options, x).open.empty());
    options.closing_iterations = 0;
    options.max_iterations = 12000;
    options.stop_median = options.stop_rms = 1e-3;
    relax(model, options, x);
    // The plane through the rim, its middle, and the angle there between slope and axis.
    Vec3 middle = Vec3::Zero();
    std::vector<Vec3> rim;
    Vec3 tip = Vec3::Zero();
    for (std::size_t p = 0; p < mesh.flat.size(); ++p) {
      if (mesh.flat[p].norm() > 0.1499) rim.push_back(x[model.node_of_point[p]]);
      if (mesh.flat[p].norm() < 1e-9) tip = x[model.node_of_point[p]];
    }
    for (const Vec3& p : rim) middle += p / static_cast<double>(rim.size());
    const Vec3 axis = (middle - tip).normalized();
    const double wanted = to_degrees(std::asin(1 - taken / 360));
    double sum = 0, least = 180, most = 0;
    for (const Vec3& p : rim) {
      const double angle = to_degrees(std::acos((p - tip).normalized().dot(axis)));
      sum += angle / static_cast<double>(rim.size());
      least = std::min(least, angle);
      most = std::max(most, angle);
    }
    std::cout << taken << " degrees taken: half angle " << sum << " (" << least << " to " << most
              << "), closed form " << wanted << "\n";
    EXPECT_NEAR(sum, wanted, 0.2);
    EXPECT_LT(most - least, 5);
  }
}

}  // namespace dart_test
}  // namespace toile
