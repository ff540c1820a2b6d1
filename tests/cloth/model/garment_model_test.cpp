#include "cloth/model/garment_model.h"

#include <gtest/gtest.h>

#include <map>

#include "cloth/model/compile.h"
#include "tests/cloth/panels.h"

namespace toile {
namespace garment_model_test {

std::map<std::string, int> terms(const GarmentModel& model) {
  const auto counts = term_counts(model);
  return {counts.begin(), counts.end()};
}

TEST(GarmentModel, PointsStandWhereTheyWerePlacedUntilTheSeamsClose) {
  const PanelMesh garment = test::sewn_pair();
  const GarmentModel model = compile(garment, {}, garment.placed);
  const std::vector<double> open(model.nodes, 1);
  const std::vector<Vec3> apart = point_positions(model, model.start, open);
  const std::vector<Vec3> closed = point_positions(model, model.start);
  for (std::size_t p = 0; p < garment.placed.size(); ++p) {
    EXPECT_LT((apart[p] - garment.placed[p]).norm(), 1e-15);
    EXPECT_EQ(closed[p], model.start[model.node_of_point[p]]);
  }
}

TEST(GarmentModel, WhatTheSceneDoesNotUseIsEmpty) {
  const PanelMesh garment = test::flat_panel(test::grid(0.1, 0.1, 5, 5));
  Scene scene;
  scene.fabric.bending_warp = scene.fabric.bending_weft = 0;
  scene.self_contact = false;
  const GarmentModel model = compile(garment, scene, garment.placed);
  EXPECT_TRUE(model.bend.empty());
  EXPECT_TRUE(model.offsets.empty());
  EXPECT_EQ(terms(model), (std::map<std::string, int>{{"stretch", 50},
                                                      {"bend", 0},
                                                      {"elastic", 0},
                                                      {"attachment", 0},
                                                      {"seam", 0},
                                                      {"body_contact", 0},
                                                      {"friction", 0},
                                                      {"self_contact", 0},
                                                      {"cloth_friction", 0},
                                                      {"layer_contact", 0},
                                                      {"strain_limit", 0},
                                                      {"shear_limit", 0}}));
}

TEST(GarmentModel, WhatTheSceneUsesIsCounted) {
  const PanelMesh garment = test::sewn_pair();
  Scene scene;
  scene.strain_limit = 0.01;
  auto counts = terms(compile(garment, scene, garment.placed));
  EXPECT_EQ(counts["stretch"], 100);
  EXPECT_EQ(counts["self_contact"], 100);
  EXPECT_EQ(counts["cloth_friction"], 66);
  EXPECT_EQ(counts["strain_limit"], 100);
  EXPECT_EQ(counts["seam"], 6);
  // Inner edges: in each panel 3·25 - 10 of its 85, and 5 across the seam.
  EXPECT_EQ(counts["bend"], 2 * 65 + 5);
}

TEST(GarmentModel, SeamsAreCountedByTheirPairsOfPoints) {
  const PanelMesh garment = test::three_panels_in_a_chain();
  EXPECT_EQ(terms(compile(garment, {}, garment.placed))["seam"], 5);
  PanelMesh dart = test::flat_panel(test::grid(0.1, 0.1, 4, 4));
  dart.seams = {test::seam("dart", {12, 16, 20}, {12, 18, 24})};
  EXPECT_EQ(terms(compile(dart, {}, dart.placed))["seam"], 2);
}

}  // namespace garment_model_test
}  // namespace toile
