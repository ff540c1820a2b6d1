// A garment of other fabrics than the default, from pattern to drape.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace toile {
namespace {

using Json = nlohmann::json;
using pipeline::read_text;
using pipeline::run;
namespace fs = std::filesystem;

class TshirtOf : public testing::Test {
 protected:
  void prepare(const std::string& edge_length) {
    succeed("make-mannequin", {"-o", body, "--edge-length", "12mm", "-q"});
    Json pattern = Json::parse(read_text(fs::path(TOILE_SOURCE_DIR) / "samples" / "tshirt.json"));
    for (auto& [name, panel] : pattern["pattern"]["panels"].items()) {
      if (name.find("sleeve") != std::string::npos) panel["fabric"] = "sleeves";
    }
    pipeline::write_text(folder / "tee.json", pattern.dump());
    succeed("mesh-pattern",
            {folder / "tee.json", "-o", garment, "--edge-length", edge_length, "-q"});
  }

  static void succeed(const std::string& program, const std::vector<std::string>& words) {
    const pipeline::Run done = run(program, words);
    ASSERT_EQ(done.exit_code, 0) << program << ": " << done.err;
  }

  Json dressed_in(const std::string& fabric, const std::string& sleeves) {
    const fs::path report = folder / "dressed.json";
    succeed("dress", {"--body", body, garment, "-o", folder / "dressed.obj", "--report", report,
                      "--fabric", fabric, "--fabric", "sleeves=" + sleeves, "-q"});
    return Json::parse(read_text(report));
  }

  pipeline::ScratchFolder folder;
  fs::path body = folder / "body.ply";
  fs::path garment = folder / "garment.obj";
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
    EXPECT_EQ(report["scene"]["panel_fabrics"].size(), 4U);
  }
  const double soft_strain = soft["strain_off_seams"]["rms"];
  const double stiff_strain = stiff["strain_off_seams"]["rms"];
  std::cout << "strain off the seams, rms: " << soft_strain << " of jersey, " << stiff_strain
            << " of poplin\n";
  EXPECT_GT(soft_strain, 2 * stiff_strain);
}

}  // namespace
}  // namespace toile
