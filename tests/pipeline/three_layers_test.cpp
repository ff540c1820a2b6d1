// Three layers along one seam line: a skirt with half a lining, from the pattern to the verdict.
#include <gtest/gtest.h>

#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace three_layers_test {

using Json = nlohmann::json;

/// The sample skirt whose front has a lining of its own shape, sewn into both side seams.
Json lined_skirt() {
  Json pattern = Json::parse(read_text(sample("elastic_skirt")));
  Json& panels = pattern["pattern"]["panels"];
  Json lining = panels["skirt_front"];
  lining["edges"][2].erase("elastic");
  lining["placement"]["offset"] = 0.5;
  panels["skirt_front"]["placement"]["offset"] = 2.5;
  panels["skirt_back"]["placement"]["offset"] = 2.5;
  panels["lining_front"] = lining;
  for (const int edge : {1, 3}) {
    pattern["pattern"]["stitches"].push_back({{{"panel", "skirt_front"}, {"edge", edge}},
                                              {{"panel", "lining_front"}, {"edge", edge}},
                                              {{"layer", true}}});
  }
  return pattern;
}

class ThreeLayers : public WornSample {
 protected:
  void wear(const Json& pattern) {
    make_body();
    write_text(folder / "pattern.json", pattern.dump());
    mesh(folder / "pattern.json", "20mm");
    const pipeline::Run done = dress("dressed");
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const Json report = this->report("dressed");
    EXPECT_EQ(report["verdict"], "sewn");
    EXPECT_EQ(report["seams"]["sewn"], 4);
    EXPECT_EQ(report["intersections"]["self"], 0);
    EXPECT_EQ(report["intersections"]["body"], 0);
    // Waist and hem: the gap between the layers is no opening.
    EXPECT_EQ(report["openings"].size(), 2U);
    succeed("ease-map", {"--body", body, folder / "dressed.obj", "-o", folder / "ease.html",
                         "--report", folder / "ease.json", "-q"});
    ease_ = Json::parse(read_text(folder / "ease.json"));
  }

  double mean_gap(const std::string& name) const {
    for (const Json& panel : ease_["panels"]) {
      if (panel["name"] == name) return panel["mean_mm"];
    }
    ADD_FAILURE() << name;
    return 0;
  }

  Json ease_;
};

TEST_F(ThreeLayers, ALiningHangsInsideAnElasticSkirt) {
  wear(lined_skirt());
  EXPECT_LT(mean_gap("lining_front"), mean_gap("skirt_front"));
}

TEST_F(ThreeLayers, AreSewnWithoutPlacesToo) {
  Json pattern = lined_skirt();
  for (Json& panel : pattern["pattern"]["panels"]) panel.erase("placement");
  wear(pattern);
}

}  // namespace three_layers_test
}  // namespace toile::pipeline
