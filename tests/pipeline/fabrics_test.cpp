// A garment of other fabrics than the default, from pattern to drape.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "io/mesh_file.h"
#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace fabrics_test {

using Json = nlohmann::json;

class TshirtOf : public WornSample {
 protected:
  void prepare(const std::string& edge_length) const {
    make_body("12mm");
    Json pattern = Json::parse(read_text(sample("tshirt")));
    for (auto& [name, panel] : pattern["pattern"]["panels"].items()) {
      if (name.find("sleeve") != std::string::npos) panel["fabric"] = "sleeves";
    }
    write_text(folder / "tee.json", pattern.dump());
    mesh(folder / "tee.json", edge_length);
  }

  Json dressed_in(const std::string& fabric, const std::string& sleeves) const {
    const pipeline::Run done =
        dress("dressed", {"--fabric", fabric, "--fabric", "sleeves=" + sleeves});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return report("dressed");
  }
};

// Seams pull as they close; cloth as soft as that is drawn into strings and tangles.
TEST_F(TshirtOf, TheSoftestFabricDoesNotTangle) {
  prepare("15mm");
  const Json report = dressed_in("jersey", "jersey");
  EXPECT_EQ(report["verdict"], "sewn");
  EXPECT_EQ(report["intersections"]["body"], 0);
  EXPECT_EQ(report["intersections"]["self"], 0);
  std::cout << "strain off the seams, 99th percentile: " << report["strain_off_seams"]["p99"]
            << "\n";
  EXPECT_LT(report["strain_off_seams"]["p99"], 0.1);
}

// The softest and the stiffest known fabrics: nothing tangles, and what is softer stretches more.
TEST_F(TshirtOf, FabricsThatDifferByAHundredTimes) {
  prepare("25mm");
  const Json soft = dressed_in("jersey", "cotton-poplin");
  const Json stiff = dressed_in("cotton-poplin", "jersey");
  for (const Json& report : {soft, stiff}) {
    EXPECT_EQ(report["verdict"], "sewn");
    EXPECT_EQ(report["intersections"]["body"], 0);
    EXPECT_EQ(report["intersections"]["self"], 0);
    EXPECT_EQ(report["scene"]["fabrics"].size(), 2U);
  }
  const double soft_strain = soft["strain_off_seams"]["rms"];
  const double stiff_strain = stiff["strain_off_seams"]["rms"];
  std::cout << "strain off the seams, rms: " << soft_strain << " of jersey, " << stiff_strain
            << " of poplin\n";
  EXPECT_GT(soft_strain, 1.5 * stiff_strain);
}

using Jersey = WornSample;

/// Without friction a soft waist slides over the hips.
TEST_F(Jersey, TrousersStayUp) {
  make_body("12mm");
  mesh(sample("trousers"), "25mm");
  const auto waist = [&](const std::string& name, const std::vector<std::string>& options) {
    EXPECT_EQ(dress(name, options).exit_code, 0);
    double highest = 0;
    for (const Vec3& p : read_mesh(folder / (name + ".obj")).points) {
      highest = std::max(highest, p.y());
    }
    return highest;
  };
  const double poplin = waist("poplin", {"--quality", "draft"});
  const double jersey = waist("jersey", {"--quality", "draft", "--fabric", "jersey"});
  std::cout << "waist at " << poplin << " m, of jersey " << jersey << " m\n";
  EXPECT_GT(jersey, poplin - 0.08);
  const auto worn = report("jersey");
  for (const auto& wrap : worn["wraps"]) EXPECT_EQ(wrap["fraction"], 1);
}

}  // namespace fabrics_test
}  // namespace toile::pipeline
