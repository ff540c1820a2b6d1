#include "cloth/springs/spring_sheet.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <iostream>
#include <numeric>

#include "cloth/model/compile.h"
#include "cloth/springs/constants.h"
#include "tests/cloth/panels.h"
#include "tests/support/spring_energy.h"

namespace toile {
namespace spring_sheet_test {

GarmentModel compiled(const PanelMesh& garment, const Fabric& fabric) {
  Scene scene;
  scene.fabric = fabric;
  return compile(garment, scene, garment.placed);
}

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Two squares of 10 cm side by side, 3 cm apart, sewn along the facing edges.
PanelMesh two_squares() {
  PanelMesh garment;
  const PlanarMesh square = test::grid(0.1, 0.1, 10, 10);
  test::add_panel(garment, "left", square, [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); });
  test::add_panel(garment, "right", square,
                  [](const Vec2& p) { return Vec3(p.x() + 0.13, p.y(), 0); });
  MeshedSeam seam;
  seam.name = "middle";
  for (int row = 0; row <= 10; ++row) {
    seam.a.push_back(row * 11 + 10);
    seam.b.push_back(121 + row * 11);
  }
  garment.seams.push_back(seam);
  return garment;
}

TEST(SpringSheet, WeighsWhatTheClothWeighs) {
  const PanelMesh garment = two_squares();
  const GarmentModel model = compiled(garment, {});
  SpringSheet sheet(garment, model);
  EXPECT_NEAR(total(sheet.mass()), 2 * 0.01 * 0.15, 1e-12);
}

// A lattice of springs of stiffness Y·A/L² has the modulus Y. A square of cloth stretched along its
// grain with free sides pulls with Y times the strain per width.
TEST(SpringSheet, StretchedAlongTheGrainItHasTheFabricsEnergy) {
  const PanelMesh garment = test::flat_panel(test::grid(0.1, 0.1, 20, 20));
  Fabric fabric;
  const GarmentModel model = compiled(garment, fabric);
  const SpringSheet sheet(garment, model);
  std::vector<Vec3> x = garment.placed;
  for (Vec3& p : x) p.y() *= 1.001;
  const double energy = spring_energy(sheet.edges(), x);
  const double wanted = 0.5 * fabric.stretch_warp * 1e-6 * 0.01;
  std::cout << "energy over the membrane's: " << energy / wanted << "\n";
  // The diagonals resist too: a lattice can't have its shear stiffness chosen on its own.
  EXPECT_GT(energy / wanted, 0.99);
  EXPECT_LT(energy / wanted, 1.35);
}

TEST(SpringSheet, IsForceFreeAtRestAndUnderRigidMotion) {
  const PanelMesh garment = test::flat_panel(test::grid(0.1, 0.1, 10, 10));
  const GarmentModel model = compiled(garment, {});
  const SpringSheet sheet(garment, model);
  Eigen::Matrix3d turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  std::vector<Vec3> x;
  for (const Vec3& p : garment.placed) x.push_back(turn * p + Vec3(4, 5, 6));
  EXPECT_LT(spring_energy(sheet.edges(), x), 1e-18);
  EXPECT_LT(spring_energy(sheet.bending(), x), 1e-18);
}

// Rolled to the matched radius, the bending springs hold the fabric's B/2R² per area. At half the
// radius they hold more, at twice the radius less: their energy goes with the fourth power of the
// curvature.
TEST(SpringSheet, BendsLikeTheFabricAtOneCurvature) {
  const PanelMesh garment = test::flat_panel(test::grid(0.1, 0.1, 16, 16));
  Fabric fabric;
  const GarmentModel model = compiled(garment, fabric);
  const SpringSheet sheet(garment, model);
  const auto share = [&](double radius) {
    std::vector<Vec3> x;
    for (const Vec3& p : garment.placed) {
      x.emplace_back(radius * std::sin(p.x() / radius), p.y(), radius * std::cos(p.x() / radius));
    }
    return spring_energy(sheet.bending(), x) /
           (0.5 * fabric.bending_weft / (radius * radius) * 0.01);
  };
  const double matched = share(matched_radius);
  std::cout << "bending energy over the fabric's: " << matched << " at R, "
            << share(0.5 * matched_radius) << " at R/2, " << share(2 * matched_radius)
            << " at 2R\n";
  EXPECT_GT(matched, 0.4);
  EXPECT_LT(matched, 1.6);
  EXPECT_NEAR(share(2 * matched_radius) / matched, 0.25, 0.02);
}

TEST(SpringSheet, MergingJoinsMassesAndSprings) {
  const PanelMesh garment = two_squares();
  const GarmentModel model = compiled(garment, {});
  SpringSheet sheet(garment, model);
  const std::size_t edges = sheet.edges().size();
  const std::size_t bends = sheet.bending().size();
  const double before = total(sheet.mass());
  const MeshedSeam& seam = garment.seams[0];
  for (std::size_t i = 0; i < seam.a.size(); ++i) sheet.merge(seam.a[i], seam.b[i]);
  sheet.refresh();
  EXPECT_NEAR(total(sheet.mass()), before, 1e-15);
  EXPECT_EQ(sheet.edges().size(), edges);
  EXPECT_EQ(sheet.bending().size(), bends + 10);  // one across each of the seam's ten edges
  for (std::size_t i = 0; i < seam.a.size(); ++i) {
    EXPECT_EQ(sheet.node(seam.a[i]), sheet.node(seam.b[i]));
    EXPECT_EQ(sheet.mass()[std::max(seam.a[i], seam.b[i])], 0);
  }
  for (const Spring& spring : sheet.edges()) {
    EXPECT_GT(sheet.mass()[spring.a], 0);
    EXPECT_GT(sheet.mass()[spring.b], 0);
  }
  // Flat, side by side, the sewn cloth is at rest.
  std::vector<Vec3> x = garment.placed;
  for (std::size_t p = 121; p < x.size(); ++p) x[p].x() -= 0.03;
  EXPECT_LT(spring_energy(sheet.edges(), x) + spring_energy(sheet.bending(), x), 1e-18);
}

// Each side of a seam contributes half of its rigidity to the springs across it.
TEST(SpringSheet, ASeamBendsAsTheMeanOfItsPanels) {
  PanelMesh garment = two_squares();
  garment.panels[1].fabric = "lining";
  const auto across_seam = [&](double left, double right) {
    Scene scene;
    scene.fabric.bending_warp = scene.fabric.bending_weft = left;
    Fabric& lining = scene.fabrics["lining"];
    lining.bending_warp = lining.bending_weft = right;
    const GarmentModel model = compile(garment, scene, garment.placed);
    SpringSheet sheet(garment, model);
    const MeshedSeam& seam = garment.seams[0];
    for (std::size_t i = 0; i < seam.a.size(); ++i) sheet.merge(seam.a[i], seam.b[i]);
    sheet.refresh();
    std::vector<double> stiffness;
    const auto is_left = [](int node) { return node < 121 && node % 11 < 10; };  // off the seam
    for (const Spring& spring : sheet.bending()) {
      const int on_left = is_left(spring.a) + is_left(spring.b);
      const int on_right = (spring.a >= 121) + (spring.b >= 121);
      if (on_left == 1 && on_right == 1) stiffness.push_back(spring.stiffness);
    }
    return stiffness;
  };
  const std::vector<double> soft = across_seam(1e-7, 1e-7);
  const std::vector<double> mixed = across_seam(1e-7, 2e-7);
  ASSERT_EQ(mixed.size(), soft.size());
  EXPECT_EQ(soft.size(), 10U);
  for (std::size_t i = 0; i < soft.size(); ++i) EXPECT_NEAR(mixed[i] / soft[i], 1.5, 1e-9);
}

TEST(SpringSheet, AGatheredSideTakesItsPartnersLength) {
  PanelMesh garment = two_squares();
  // The right panel's pattern is a fifth taller.
  for (std::size_t p = 121; p < garment.flat.size(); ++p) garment.flat[p].y() *= 1.2;
  const GarmentModel model = compiled(garment, {});
  const SpringSheet sheet(garment, model);
  const MeshedSeam& seam = garment.seams[0];
  int found = 0;
  for (const Spring& spring : sheet.edges()) {
    for (std::size_t i = 0; i + 1 < seam.b.size(); ++i) {
      if (spring.a != seam.b[i] || spring.b != seam.b[i + 1]) continue;
      EXPECT_NEAR(spring.rest, 0.01, 1e-12);
      ++found;
    }
  }
  EXPECT_EQ(found, 10);
}

}  // namespace spring_sheet_test
}  // namespace toile
