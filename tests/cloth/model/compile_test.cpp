#include "cloth/model/compile.h"

#include <gtest/gtest.h>

#include <numeric>

#include "cloth/model/constants.h"
#include "cloth/model/gathers.h"
#include "tests/cloth/bend_energy.h"
#include "tests/cloth/panels.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace compile_test {

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(Compile, TheWholeClothIsWeighed) {
  const PanelMesh garment = test::sewn_pair();
  Scene scene;
  scene.fabric.areal_density = 0.3;
  const GarmentModel model = compile(garment, scene, garment.placed);
  EXPECT_NEAR(total(model.mass), 0.3 * 0.02, 1e-15);
  EXPECT_NEAR(model.mean_weight, 0.3 * 0.02 * 9.81 / model.nodes, 1e-12);
}

TEST(Compile, EachPanelHasItsOwnFabric) {
  PanelMesh garment = test::sewn_pair();
  garment.panels[1].fabric = "lining";
  garment.panels[1].grain = 0.5;
  Scene scene;
  scene.fabric.areal_density = 0.3;
  scene.fabric.friction_skin = 0.6;
  scene.fabric.thickness = 0.001;
  Fabric& lining = scene.fabrics["lining"];
  lining.areal_density = 0.1;
  lining.stretch_warp = 500;
  lining.shear = 20;
  lining.friction_skin = 0.2;
  lining.friction_cloth = 0.1;
  lining.bending_warp = lining.bending_weft = 1e-6;
  const GarmentModel model = compile(garment, scene, garment.placed);
  EXPECT_NEAR(total(model.mass), (0.3 + 0.1) * 0.01, 1e-15);
  const int half = garment.panels[1].first_triangle;
  for (int t = 0; t < 2 * half; ++t) {
    const Fabric& fabric = t < half ? scene.fabric : lining;
    const StretchTriangle& s = model.stretch[t];
    EXPECT_NEAR(s.warp_stiffness, fabric.stretch_warp * s.area, 1e-12);
    EXPECT_NEAR(s.weft_stiffness, fabric.stretch_weft * s.area, 1e-12);
    EXPECT_NEAR(s.shear_stiffness, fabric.shear * s.area, 1e-12);
  }
  const auto node = [&](int panel, int point) {
    return model.node_of_point[garment.panels[panel].first_point + point];
  };
  EXPECT_NEAR(model.friction_skin[node(0, 0)], 0.6, 1e-12);
  EXPECT_NEAR(model.friction_skin[node(1, 5)], 0.2, 1e-12);
  EXPECT_NEAR(model.friction_cloth[node(1, 5)], 0.1, 1e-12);
  // In the middle of the seam, three triangles of either panel: by mass.
  EXPECT_NEAR(model.friction_skin[node(0, 17)], (0.3 * 0.6 + 0.1 * 0.2) / 0.4, 1e-12);
  double across = 0;
  for (const BendHinge& hinge : model.bend) {
    across += hinge.across_seam;
  }
  EXPECT_EQ(across, 5);
  scene.fabrics.clear();
  EXPECT_HOLDS(samples::error_of([&] { compile(garment, scene, garment.placed); }), "'lining'");
}

TEST(Compile, ThickClothKeepsFartherOff) {
  PanelMesh garment = test::sewn_pair();
  Scene scene;
  EXPECT_EQ(self_gap_of(scene, garment), 0.002);
  EXPECT_EQ(body_offset_of(scene, garment), 0.002);
  scene.fabrics["fleece"].thickness = 0.004;
  EXPECT_EQ(self_gap_of(scene, garment), 0.002);
  garment.panels[1].fabric = "fleece";
  EXPECT_EQ(self_gap_of(scene, garment), 0.004);
  EXPECT_NEAR(body_offset_of(scene, garment), 0.003, 1e-15);
  EXPECT_EQ(compile(garment, scene, garment.placed).self_gap, 0.004);
}

TEST(Compile, SewnPointsAreOneNode) {
  const PanelMesh garment = test::sewn_pair();
  const GarmentModel model = compile(garment, {}, garment.placed);
  EXPECT_EQ(model.nodes, 2 * 36 - 6);
  const MeshedSeam& seam = garment.seams[0];
  for (std::size_t i = 0; i < seam.a.size(); ++i) {
    const int node = model.node_of_point[seam.a[i]];
    EXPECT_EQ(node, model.node_of_point[seam.b[i]]);
    EXPECT_LT((model.start[node] - Vec3(0.105, 0.02 * static_cast<double>(i), 0)).norm(), 1e-15);
  }
  // The panels stand where they were placed as long as the seam is fully open.
  for (std::size_t p = 0; p < garment.placed.size(); ++p) {
    const Vec3 at = model.start[model.node_of_point[p]] + model.offsets[p];
    EXPECT_LT((at - garment.placed[p]).norm(), 1e-15);
  }
  // Each node but those of the seam belongs to one point.
  std::vector<int> points(model.nodes, 0);
  for (const int node : model.node_of_point) ++points.at(node);
  EXPECT_EQ(std::count(points.begin(), points.end(), 1), 60);
  EXPECT_EQ(std::count(points.begin(), points.end(), 2), 6);
}

TEST(Compile, ThreePanelsMeetInOnePoint) {
  const PanelMesh garment = test::three_panels_in_a_chain();
  const auto right_of = [&](int i) { return test::side(garment.panels[i], 4, 4, true); };
  const GarmentModel model = compile(garment, {}, garment.placed);
  EXPECT_EQ(model.nodes, 75 - 10);
  for (int row = 0; row < 5; ++row) {
    const int node = model.node_of_point[right_of(0)[row]];
    EXPECT_EQ(model.node_of_point[right_of(1)[row]], node);
    EXPECT_EQ(model.node_of_point[right_of(2)[row]], node);
    EXPECT_NEAR(model.start[node].z(), 0.1, 1e-15);
  }
  // Along the seam of three there is no hinge.
  for (const BendHinge& hinge : model.bend) EXPECT_FALSE(hinge.across_seam);
}

TEST(Compile, ADartsTipStaysOnePoint) {
  PanelMesh garment = test::flat_panel(test::grid(0.1, 0.1, 4, 4));
  // From the top inward, over a slit of points that only have to be different: tip is point 12.
  garment.seams = {test::seam("dart", {12, 16, 20}, {12, 18, 24})};
  const GarmentModel model = compile(garment, {}, garment.placed);
  EXPECT_EQ(model.nodes, 23);
  EXPECT_EQ(model.offsets[12], Vec3::Zero());
}

TEST(Compile, WhatLiesFlatHasNoCurvature) {
  // Sewn side to side, the two squares lie flat as one: the hinges across the seam too.
  const PanelMesh garment = test::sewn_pair();
  const GarmentModel model = compile(garment, {}, garment.placed);
  std::vector<Vec3> together = garment.placed;
  for (int p = 36; p < 72; ++p) together[p].x() -= 0.01;
  int across = 0;
  for (const BendHinge& hinge : model.bend) {
    across += hinge.across_seam;
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 4; ++i) sum += hinge.weights[i] * together[hinge.points[i]];
    EXPECT_LT(sum.norm(), 1e-13);
  }
  EXPECT_EQ(across, 5);
  // Folded along the seam only, only they resist.
  std::vector<Vec3> folded = together;
  for (Vec3& p : folded) {
    if (p.x() > 0.1) p = Vec3(0.1, p.y(), p.x() - 0.1);
  }
  for (const BendHinge& hinge : model.bend) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 4; ++i) sum += hinge.weights[i] * folded[hinge.points[i]];
    // By a right angle, each side's slope is along its own panel.
    EXPECT_NEAR(sum.norm(), hinge.across_seam ? std::sqrt(2.0) : 0, 1e-13);
  }
  EXPECT_GT(test::bend_energy(model, folded), 0);
}

TEST(Compile, AGatheredSeamTakesTheShorterSidesLength) {
  // Sides of 13 and 10 cm with the same number of points. The wide panel's triangles on the seam
  // are at rest when their sides there are as long as the narrow one's.
  PanelMesh garment;
  test::add_panel(garment, "skirt", test::grid(0.1, 0.13, 5, 10),
                  [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); });
  test::add_panel(garment, "bodice", test::grid(0.1, 0.10, 5, 10),
                  [](const Vec2& p) { return Vec3(p.x() + 0.2, p.y(), 0); });
  garment.seams = {test::seam("waist", test::side(garment.panels[0], 5, 10, true),
                              test::side(garment.panels[1], 5, 10, false))};
  const GarmentModel model = compile(garment, {}, garment.placed);
  const auto length = [&](int t, const std::array<double, 3> StretchTriangle::*direction) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
      sum += (model.stretch[t].*direction)[i] * garment.placed[garment.triangles[t][i]];
    }
    return sum.norm();
  };
  // Beside the seam, weft and warp stand for along it and across it.
  int drawn = 0, row = 0;
  for (int t = 0; t < 200; ++t) {
    int on_seam = 0;
    for (const int p : garment.triangles[t]) {
      on_seam += std::count(garment.seams[0].a.begin(), garment.seams[0].a.end(), p);
    }
    const bool wide = t < 100 && on_seam == 2;
    const StretchTriangle& s = model.stretch[t];
    const double area = t < 100 ? 0.00013 : 0.0001;
    const bool gives = s.shear_stiffness < 0.5 * area * 200;
    drawn += wide;
    row += gives;
    EXPECT_TRUE(gives || !wide) << t;
    EXPECT_NEAR(length(t, &StretchTriangle::weft), wide ? 1.3 : 1.0, 1e-12) << t;
    EXPECT_NEAR(length(t, &StretchTriangle::warp), 1.0, 1e-12) << t;
    EXPECT_NEAR(s.shear_stiffness, area * 200 * (gives ? gathered_stiffness : 1), 1e-12) << t;
    EXPECT_NEAR(s.warp_stiffness, area * 1000, 1e-12) << t;
    EXPECT_NEAR(s.weft_stiffness, area * 1000 * (gives && !wide ? gathered_stiffness : 1), 1e-12)
        << t;
  }
  EXPECT_EQ(drawn, 10);
  // Those with a corner on it too, apart from those that only touch its end.
  EXPECT_EQ(row, 19);
  // What gathering does to the rest shape it does not do to the cloth's weight.
  EXPECT_NEAR(total(model.mass), 0.15 * (0.013 + 0.010), 1e-15);
}

TEST(Compile, SidesOfNearlyOneLengthAreNotGathered) {
  PanelMesh garment;
  for (const double height : {0.101, 0.100}) {
    test::add_panel(garment, "panel", test::grid(0.1, height, 5, 5),
                    [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); });
  }
  garment.seams = {test::seam("", test::side(garment.panels[0], 5, 5, true),
                              test::side(garment.panels[1], 5, 5, false))};
  const GarmentModel model = compile(garment, {}, garment.placed);
  double area = 0;
  for (const StretchTriangle& s : model.stretch) area += s.area;
  EXPECT_NEAR(area, 0.0201, 1e-15);
}

TEST(Compile, ATriangleSewnToItselfIsRefused) {
  PanelMesh garment = test::flat_panel(test::grid(0.01, 0.1, 1, 5));
  garment.panels[0].name = "cuff";
  garment.seams = {test::seam("", test::side(garment.panels[0], 1, 5, false),
                              test::side(garment.panels[0], 1, 5, true))};
  const std::string message = samples::error_of([&] { compile(garment, {}, garment.placed); });
  EXPECT_HOLDS(message, "'cuff'");
  EXPECT_HOLDS(message, "--edge-length");
}

TEST(Compile, ATriangleWithoutAreaIsRefused) {
  PanelMesh garment = test::flat_panel({{{0, 0}, {0.1, 0}, {0.2, 0}}, {{0, 1, 2}}});
  EXPECT_HOLDS(samples::error_of([&] { compile(garment, {}, garment.placed); }), "'panel'");
}

TEST(Compile, RunsTheSameTwice) {
  const PanelMesh garment = test::sewn_pair();
  const GarmentModel one = compile(garment, {}, garment.placed);
  const GarmentModel two = compile(garment, {}, garment.placed);
  ASSERT_EQ(one.bend.size(), two.bend.size());
  for (std::size_t h = 0; h < one.bend.size(); ++h) {
    EXPECT_EQ(one.bend[h].points, two.bend[h].points);
    EXPECT_EQ(one.bend[h].weights, two.bend[h].weights);
  }
}

}  // namespace compile_test
}  // namespace toile
