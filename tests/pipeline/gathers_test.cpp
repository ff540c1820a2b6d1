// Gathers through the whole chain: fullness becomes folds beside the seam.
#include <gtest/gtest.h>

#include <iostream>
#include <numbers>

#include "pattern/file/garment_file.h"
#include "tests/support/level_line.h"
#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace gathers_test {

using Json = nlohmann::json;

class Gathers : public WornSample {
 protected:
  DressedGarment wear(const std::string& name, const std::vector<std::string>& options = {},
                      const std::string& edge_length = "20mm") {
    make_body();
    mesh(sample(name), edge_length);
    const pipeline::Run done = dress("dressed", options);
    EXPECT_TRUE(done.exit_code == 0 || (weightless_ && done.exit_code == 3)) << done.err;
    EXPECT_EQ(done.err.find("warning"), std::string::npos) << done.err;
    report_ = report("dressed");
    return read_dressed(folder / "dressed.obj");
  }

  Json report_;
  bool weightless_ = false;  ///< then forces never fall below node weights: verdict unconverged
};

// Gathered 2 : 1 at -4 cm. Nearer to the seam than an edge of the mesh, the folds are finer than
// it.
TEST_F(Gathers, OfASkirtBecomeFoldsBesideTheSeam) {
  const DressedGarment skirt = wear("gathered_skirt");
  EXPECT_EQ(report_["verdict"], "sewn");
  EXPECT_LT(report_["strain_off_seams"]["p99"], 0.05);
  for (const double below : {0.02, 0.04, 0.08}) {
    int all_folds = 0;
    for (const std::string panel : {"skirt_front", "skirt_back"}) {
      const test::LevelLine line = test::level_line(skirt, panel, -0.04 - below);
      const int folds = test::folds(line, 0.003);
      std::cout << panel << ", " << 100 * below << " cm below: " << 100 * line.now << " of "
                << 100 * line.flat << " cm, " << folds << " folds\n";
      EXPECT_NEAR(line.flat, 0.74, 1e-9);
      EXPECT_GT(line.now / line.flat, below < 0.03 ? 0.93 : 0.99);
      EXPECT_LT(line.now / line.flat, 1.01);
      all_folds += folds;
    }
    EXPECT_GE(all_folds, 8);
  }
}

// On this mesh, which is not symmetric, the gathers turned it by a quarter, and its seams jammed.
TEST_F(Gathers, DoNotTurnTheSkirtAboutTheBody) {
  const DressedGarment skirt = wear("gathered_skirt", {}, "25mm");
  EXPECT_EQ(report_["verdict"], "sewn");
  EXPECT_EQ(report_["stages"].back()["attempt"], 1);
  for (std::size_t panel = 0; panel < skirt.panels.size(); ++panel) {
    Vec3 middle = Vec3::Zero();
    for (std::size_t t = 0; t < skirt.triangles.size(); ++t) {
      if (skirt.panel_of_triangle[t] != static_cast<int>(panel)) continue;
      for (const int n : skirt.triangles[t]) middle += skirt.points[n];
    }
    if (skirt.panels[panel].ends_with("back")) middle = -middle;
    const double turned = 180 / std::numbers::pi * std::atan2(middle.x(), middle.z());
    std::cout << skirt.panels[panel] << " turned by " << turned << " degrees\n";
    EXPECT_NEAR(turned, 0, 10);
  }
}

TEST_F(Gathers, DoNotStretchTheShorterSide) {
  weightless_ = true;
  // Hardly any weight hangs on the waistband, so that the gather alone pulls.
  write_text(folder / "light.json", R"({"areal_density_kg_per_m2": 0.001})");
  const DressedGarment skirt = wear("gathered_skirt", {"--fabric", folder / "light.json"});
  for (const std::string panel : {"band_front", "band_back"}) {
    const test::LevelLine line = test::level_line(skirt, panel, -0.0395);
    std::cout << panel << " at the seam: " << 100 * (line.now / line.flat - 1) << " % longer\n";
    EXPECT_LT(line.now / line.flat, 1.02);
  }
}

// 120 cm of cloth on 66 cm of elastic, at a waist of 70.7 cm that the cloth keeps 2 mm from.
TEST_F(Gathers, OfAnElasticHoldTheSkirtAtTheWaist) {
  const DressedGarment skirt = wear("elastic_skirt");
  EXPECT_EQ(report_["verdict"], "sewn");
  EXPECT_GT(report_["scene"]["terms"]["elastic"], 0);
  EXPECT_LT(report_["strain_off_seams"]["p99"], 0.05);
  double worn = 0;
  for (const Json& elastic : report_["elastics"]) {
    std::cout << elastic << "\n";
    EXPECT_NEAR(elastic["flat_cm"], 60, 1e-6);
    EXPECT_NEAR(elastic["rest_cm"], 33, 1e-6);
    const double now = elastic["worn_cm"];
    EXPECT_NEAR(elastic["tension_N"], 20 * (now / 33 - 1), 0.02);
    worn += now;
  }
  // Coarse edges keep farther from the skin.
  EXPECT_NEAR(worn, 70.66 + 200 * std::numbers::pi * 0.004, 1.5);
  for (const std::string panel : {"skirt_front", "skirt_back"}) {
    const test::LevelLine line = test::level_line(skirt, panel, -0.04);
    EXPECT_NEAR(line.now / line.flat, 1, 0.02);
    for (const Vec3& p : test::level_line(skirt, panel, -1e-4).points) {
      EXPECT_NEAR(p.y(), 1.05, 0.02);
    }
  }
}

}  // namespace gathers_test
}  // namespace toile::pipeline
