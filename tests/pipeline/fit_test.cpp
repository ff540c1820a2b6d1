// toile fit: what it says of a garment stands in its report and on its ease map.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/mesh_file.h"
#include "tests/support/run_program.h"

namespace toile::pipeline {
namespace fit_test {

using Json = nlohmann::json;

class ToileFit : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = new ScratchFolder;
    EXPECT_EQ(run("make-mannequin", {"-o", *made_ / "mannequin.obj", "--edge-length", "14mm", "-q"})
                  .exit_code,
              0);
  }
  static void TearDownTestSuite() { delete made_; }

  ToileFit() {
    for (const char* file : {"mannequin.obj", "mannequin.body.json"}) {
      fs::copy(*made_ / file, folder / file);
    }
    pattern = Json::parse(read_text(fs::path(TOILE_SOURCE_DIR) / "samples" / "tshirt.json"));
  }
  pipeline::Run fit(const std::vector<std::string>& more = {}) {
    write_text(folder / "pattern.json", pattern.dump());
    std::vector<std::string> words = {
        "fit",          "--body",        body,  folder / "pattern.json", "-o",
        folder / "out", "--edge-length", "35mm"};
    words.insert(words.end(), more.begin(), more.end());
    return run("toile", words);
  }
  Json report(const std::string& name) { return Json::parse(read_text(folder / "out" / name)); }
  Json& panels() { return pattern["pattern"]["panels"]; }

  ScratchFolder folder;
  fs::path body = folder / "mannequin.obj";
  Json pattern;

 private:
  static ScratchFolder* made_;
};
ScratchFolder* ToileFit::made_ = nullptr;

TEST_F(ToileFit, EveryWarningIsInTheReportAndOnTheEaseMap) {
  for (auto& [name, panel] : panels().items()) {
    for (Json& vertex : panel["vertices"]) vertex[0] = 0.8 * vertex[0].get<double>();
  }
  const pipeline::Run done = fit();
  const Json said = report("dressed.json");
  EXPECT_EQ(said["quality"], "figures");
  EXPECT_EQ(said["fit"]["verdict"], "too_small") << done.err;
  ASSERT_FALSE(said["fit"]["levels"].empty());
  EXPECT_GT(said["fit"]["levels"][0]["missing_cm"], 5);
  const std::string page = read_text(folder / "out" / "ease.html");
  EXPECT_NE(page.find("verdict: " + said["verdict"].get<std::string>()), std::string::npos);
  EXPECT_NE(page.find("fit: too_small"), std::string::npos);
  // What stands on the screen as a warning of the drape stands in its report and on the page. What
  // hurts most begins with a capital letter there.
  ASSERT_FALSE(said["warnings"].empty());
  for (const Json& warning : said["warnings"]) {
    const std::string line = warning["text"].get<std::string>();
    EXPECT_FALSE(warning["code"].get<std::string>().empty()) << line;
    EXPECT_NE(done.err.find("warning: " + line), std::string::npos) << line;
    EXPECT_NE(page.find(line.substr(1, line.find('\'') - 1)), std::string::npos) << line;
  }
  std::istringstream lines(done.err);
  std::size_t warned = 0;
  for (std::string line; std::getline(lines, line);)
    warned += line.starts_with("warning: ") ? 1 : 0;
  EXPECT_EQ(warned, said["warnings"].size()) << done.err;
}

TEST_F(ToileFit, WhatIsLetGoIsAtRestAsAWhole) {
  const pipeline::Run done = fit({"--release", "0.05s"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(report("dressed.json")["quality"], "standard");
}

TEST_F(ToileFit, RepeatedDrapesGiveTheErrors) {
  write_text(folder / "pattern.json", pattern.dump());
  const auto fit_times = [&](const std::string& count) {
    return run("toile", {"fit", "--body", body, folder / "pattern.json", "-o", folder / "out",
                         "--edge-length", "35mm", "--quality", "draft", "--repeat", count, "-q"});
  };
  EXPECT_EQ(fit_times("2").exit_code, 2);
  ASSERT_EQ(fit_times("4").exit_code, 0);
  EXPECT_EQ(report("ease.json")["repeats"].size(), 3U);
  ASSERT_EQ(fit_times("3").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "out" / "repeat-4-dressed.obj"));
  const Json ease = report("ease.json");
  ASSERT_EQ(ease["repeats"].size(), 2U);
  EXPECT_EQ(ease["repeats"][0]["verdict"], "sewn");
  // The half width of three values is 2.92 sqrt(4/3) of their standard deviation.
  std::map<std::string, std::vector<double>> heights;
  for (const char* drape : {"dressed.json", "repeat-2-dressed.json", "repeat-3-dressed.json"}) {
    const Json said = report(drape);
    for (const Json& level : said["levels"]) {
      heights[level["name"]].push_back(level["height_cm"]);
    }
  }
  const std::vector<double>& hem = heights.at("hem");
  ASSERT_EQ(hem.size(), 3U);
  const double mean = (hem[0] + hem[1] + hem[2]) / 3;
  double variance = 0;
  for (const double height : hem) variance += (height - mean) * (height - mean) / 2;
  for (const Json& level : ease["garment_levels"]) {
    if (level["name"] != "hem") continue;
    EXPECT_NEAR(level["plus_minus_height_cm"], 2.92 * std::sqrt(4 / 3.0 * variance), 0.01);
  }
}

/// What clean-body and mesh-pattern warn of is said of the drape, too.
TEST_F(ToileFit, WarningsOfBodyAndPatternAreInTheReport) {
  PolygonSoup open = read_mesh(body);
  const auto is_low_back = [&](const std::vector<int>& polygon) {
    const Vec3& p = open.points[polygon[0]];
    return p.z() < 0 && std::abs(p.x()) < 0.06 && std::abs(p.y() - 1.1) < 0.06;
  };
  std::erase_if(open.polygons, is_low_back);
  TriangleMesh torn = fan_triangles(open);
  write_mesh(body, torn);
  const pipeline::Run done = fit();
  const Json said = report("dressed.json");
  EXPECT_EQ(report("body.report.json")["warnings"].size(), 1U) << done.err;
  EXPECT_NE(said["warnings"].dump().find("a hole "), std::string::npos) << said["warnings"];
  EXPECT_NE(read_text(folder / "out" / "ease.html").find("<li>a hole "), std::string::npos);
}

TEST_F(ToileFit, ABrokenPatternIsRefusedBeforeAnythingIsRemoved) {
  fs::create_directory(folder / "out");
  write_text(folder / "out" / "ease.html", "of an earlier run");
  pattern.erase("pattern");
  const pipeline::Run done = fit();
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("pattern.json"), std::string::npos) << done.err;
  EXPECT_EQ(read_text(folder / "out" / "ease.html"), "of an earlier run");
}

TEST_F(ToileFit, ALayoutThatStandsLowerIsMovedAndThatIsSaid) {
  for (auto& [name, panel] : panels().items()) {
    panel["translation"][1] = panel["translation"][1].get<double>() - 60;
  }
  const pipeline::Run done = fit();
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(done.err.find("all panels were raised by"), std::string::npos) << done.err;
  const Json said = report("dressed.json");
  EXPECT_NEAR(said["scene"]["layout_moved"]["translation_mm"][1].get<double>(), 600, 100);
  EXPECT_FALSE(said["scene"]["layout_moved"]["as_body"].get<bool>());
}

/// Its waist is half as wide again as the body's hips.
TEST_F(ToileFit, AMisplacedGarmentSaysWhereItBelongs) {
  pattern = Json::parse(read_text(fs::path(TOILE_SOURCE_DIR) / "samples" / "gathered_skirt.json"));
  pattern["properties"]["units_in_meter"] = 60;
  const pipeline::Run done = fit();
  EXPECT_EQ(done.exit_code, 3) << done.err;
  EXPECT_EQ(report("dressed.json")["verdict"], "misplaced");
  const std::string page = read_text(folder / "out" / "ease.html");
  EXPECT_NE(page.find("misplaced"), std::string::npos);
  EXPECT_NE(page.find("is not worn where it belongs"), std::string::npos);
}

/// Fronts and backs on one side of the body, which the sleeves go around.
TEST_F(ToileFit, ANegativeVerdictStillGetsItsEaseMap) {
  for (const std::string side : {"left", "right"}) {
    panels()[side + "_back"]["translation"] = panels()[side + "_front"]["translation"];
    panels()[side + "_back"]["rotation"] = panels()[side + "_front"]["rotation"];
  }
  const pipeline::Run done = fit();
  EXPECT_EQ(done.exit_code, 3) << done.err;
  const std::string verdict = report("dressed.json")["verdict"];
  EXPECT_NE(verdict, "sewn");
  EXPECT_NE(read_text(folder / "out" / "ease.html").find(verdict), std::string::npos);
}

TEST_F(ToileFit, WithoutReleaseStabilityIsNotAskedFor) {
  EXPECT_EQ(fit().exit_code, 0);
  const Json said = report("dressed.json");
  EXPECT_EQ(said["verdict"], "sewn");
  EXPECT_FALSE(said.contains("release"));
  EXPECT_EQ(said["worn"], "checked");
}

}  // namespace fit_test
}  // namespace toile::pipeline
