// Case 7: what can't be sewn, or only by force. More starts that go wrong: hard_starts_test.cpp.
#include "tests/stability/hard_case.h"

namespace toile::test {
namespace unsewable_test {

class Unsewable : public HardCase {
 protected:
  /// The band's panels as rectangles.
  static void rectangle(Json& panel, double width, double low, double high) {
    const double half = width / 2;
    panel["vertices"] = {{-half, low}, {half, low}, {half, high}, {-half, high}};
    panel["edges"] = Json::array();
    for (int i = 0; i < 4; ++i) panel["edges"].push_back({{"endpoints", {i, (i + 1) % 4}}});
  }
};

using LongUnsewable = Unsewable;

/// A tube of 50 cm for a waist of 71 and hips of 98.
TEST_F(Unsewable, ABandThreeSizesSmallLacksCentimetres) {
  const fs::path garment = band([](Json& panels, Json&) {
    for (Json& panel : panels) rectangle(panel, 25, 9, 17);
  });
  for (const std::string& method : both_methods) {
    const Ending ending = dress(mannequin(), garment, method);
    // The relaxation closes the seams at any tension.
    const bool closes = method == "relaxation";
    EXPECT_EQ(ending.outcome, closes ? "too_tight" : "unsewable") << ending.said;
    if (closes) {
      EXPECT_EQ(ending.report["intersections"]["body"], 0);
    }
    const Json seams = ending.report[closes ? "tight_seams" : "unsewable_seams"];
    double missing = 0;
    for (const Json& seam : seams) {
      missing += seam[closes ? "missing_cm" : "gap_cm"].get<double>();
      EXPECT_TRUE(ending.says(seam["name"].get<std::string>())) << ending.said;
    }
    // The waist has 21 cm more than the tube, and the hips 48 cm. Where the tube comes to lie, 20
    // to 29 cm are missing.
    EXPECT_GT(missing, 17) << seams;
    EXPECT_LT(missing, 30) << seams;
    EXPECT_EQ(ending.report["fit"]["verdict"], closes ? "too_small" : "not_checked");
    state("7 band three sizes small", method, ending.outcome,
          "lacks " + number(missing) + " cm in all");
  }
}

/// The same tube, twice as high, may roll up into a fold: what it lacks is told all the same.
TEST_F(Unsewable, AHighBandThreeSizesSmallIsToldTooSmallThoughItRollsUp) {
  const fs::path garment = band([](Json& panels, Json&) {
    for (Json& panel : panels) rectangle(panel, 25, 5, 21);
  });
  const Ending ending = dress(mannequin(), garment, "relaxation");
  EXPECT_TRUE(ending.outcome == "too_tight" || ending.outcome == "misplaced") << ending.said;
  EXPECT_EQ(ending.report["intersections"]["body"], 0);
  EXPECT_EQ(ending.report["intersections"]["self"], 0);
  EXPECT_EQ(ending.report["fit"]["verdict"], "too_small");
  double missing = 0;
  for (const Json& level : ending.report["fit"]["levels"]) {
    missing = std::max(missing, level["missing_cm"].get<double>());
  }
  EXPECT_GT(missing, 71 - 50 - 1);  // the waist's, or more
}

/// Armholes sewn to the neck's other side can meet through the neck only.
TEST_F(LongUnsewable, AStitchThroughTheBody) {
  Json tshirt = sample("tshirt");
  Json& panels = tshirt["pattern"]["panels"];
  for (const std::string half : {"_sleeve_f", "_sleeve_b"}) {
    for (const char* key : {"translation", "rotation", "placement"}) {
      std::swap(panels["left" + half][key], panels["right" + half][key]);
    }
  }
  const fs::path garment = meshed(tshirt);
  for (const std::string& method : both_methods) {
    const Ending ending = dress(mannequin(), garment, method, {}, 280);
    EXPECT_EQ(ending.outcome, "unsewable") << ending.said;
    EXPECT_TRUE(ending.says("armhole")) << ending.said;
    state("7 sleeves sewn through the torso", method, ending.outcome, ending.figures());
  }
}

/// Sides of 36 and 18 cm: gathered, as nobody said, to the shorter.
TEST_F(Unsewable, SeamsOfOneToTwoAreNamedWithBothLengths) {
  for (const bool declared : {false, true}) {
    Json pattern = sample("band");
    Json& panels = pattern["pattern"]["panels"];
    rectangle(panels["front"], 49, 0, 18);
    rectangle(panels["back"], 49, -9, 27);
    for (Json& stitch : pattern["pattern"]["stitches"]) {
      if (declared) stitch[2]["gather"] = true;
    }
    pipeline::write_text(folder / "uneven-pattern.json", pattern.dump());
    const pipeline::Run meshing =
        pipeline::run("mesh-pattern", {folder / "uneven-pattern.json", "-o", folder / "uneven.obj",
                                       "--edge-length", "25mm", "-q"});
    ASSERT_EQ(meshing.exit_code, 0) << meshing.err;
    const bool warned = meshing.err.find("warning: ") != std::string::npos;
    EXPECT_EQ(warned, !declared) << meshing.err;
    if (warned) {
      for (const char* words : {"36.00 cm", "18.00 cm", "2.00 : 1", "gather"}) {
        EXPECT_NE(meshing.err.find(words), std::string::npos) << words << ": " << meshing.err;
      }
    }
    state(std::string("7 seams of 2 : 1, ") + (declared ? "declared" : "undeclared"),
          "mesh-pattern", warned ? "warning" : "meshed", warned ? "names both lengths" : "");
  }
  for (const std::string& method : both_methods) {
    const Ending ending = dress(mannequin(), folder / "uneven.obj", method);
    EXPECT_EQ(ending.outcome, "sewn") << ending.said;
    EXPECT_EQ(ending.report["seams"]["open"], 0) << ending.said;
    state("7 seams of 2 : 1, undeclared", method, ending.outcome, ending.figures());
  }
}

}  // namespace unsewable_test
}  // namespace toile::test
