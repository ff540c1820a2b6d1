// The program export-pattern, from the pattern file to a drawing, and back by import-pattern.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geometry/polygon.h"
#include "pattern/file/pattern_file.h"
#include "tests/pattern/samples.h"
#include "tests/support/run_program.h"

namespace toile {
namespace export_pattern_test {

using pipeline::read_text;
using pipeline::run;
using pipeline::ScratchFolder;
using pipeline::write_text;
using Json = nlohmann::json;

std::string sample_file(const std::string& name) {
  return (std::filesystem::path(TOILE_SOURCE_DIR) / "samples" / (name + ".json")).string();
}

/// Square metres of the panels by their names, each edge cut into 400 chords.
std::map<std::string, double> areas(const std::string& file) {
  std::vector<Remark> remarks;
  std::map<std::string, double> all;
  for (const PatternPanel& panel : read_pattern(file, remarks).panels) {
    std::vector<Vec2> points;
    for (const OutlineStep& step : panel.outline) {
      const EdgeCurve& curve = panel.edges[static_cast<std::size_t>(step.edge)].curve;
      for (int i = 0; i < 400; ++i) {
        points.push_back(curve.at(step.forward ? i / 400.0 : 1 - i / 400.0));
      }
    }
    all[panel.name] = std::abs(signed_area(points));
  }
  return all;
}

TEST(ExportPattern, WhatIsExportedImportsAgain) {
  for (const std::string name : {"tshirt", "trousers", "jacket"}) {
    for (const std::string extension : {"svg", "dxf"}) {
      const ScratchFolder folder;
      const std::string drawing = folder / ("out." + extension);
      const auto out = run("export-pattern", {sample_file(name), "-o", drawing, "--seam-allowance",
                                              "10mm", "--report", folder / "report.json"});
      ASSERT_EQ(out.exit_code, 0) << out.err;
      EXPECT_EQ(out.out, "");
      EXPECT_HOLDS(out.err, "scale 1:1");
      const Json report = Json::parse(read_text(folder / "report.json"));
      EXPECT_EQ(report["format"], extension);
      EXPECT_EQ(report["seam_allowance_mm"], 10);
      const auto back = run("import-pattern", {drawing, "-o", folder / "back.json"});
      ASSERT_EQ(back.exit_code, 0) << back.err;
      const auto before = areas(sample_file(name));
      const auto after = areas(folder / "back.json");
      ASSERT_EQ(after.size(), before.size()) << name << " " << extension;
      for (const auto& [panel, area] : before) {
        ASSERT_TRUE(after.count(panel)) << panel;
        EXPECT_NEAR(after.at(panel), area, 1e-3 * area) << panel << " by " << extension;
      }
    }
  }
}

TEST(ExportPattern, AnotherReaderFindsNoFaultInTheDxf) {
  for (const std::string name : {"tshirt", "bodice_dress"}) {
    const ScratchFolder folder;
    const std::string drawing = folder / "out.dxf";
    ASSERT_EQ(run("export-pattern", {sample_file(name), "-o", drawing, "-q"}).exit_code, 0);
    const auto audit =
        run(std::filesystem::path(TOILE_SOURCE_DIR) / "tests" / "support" / "read_dxf", {drawing});
    EXPECT_EQ(audit.exit_code, 0) << audit.err;
    EXPECT_HOLDS(audit.out, "AC1009");
    const auto expected = areas(sample_file(name));
    std::istringstream lines(audit.out);
    std::string block;
    std::size_t points = 0, found = 0;
    double area = 0;
    while (lines >> block >> points >> area) {
      const auto panel = std::find_if(expected.begin(), expected.end(), [&](const auto& one) {
        std::string capitals = one.first;
        for (char& c : capitals) c = static_cast<char>(std::toupper(c));
        return capitals == block;
      });
      ASSERT_NE(panel, expected.end()) << block;
      EXPECT_NEAR(area * 1e-6, panel->second, 1e-4 * panel->second) << block;
      ++found;
    }
    EXPECT_EQ(found, expected.size());
  }
}

TEST(ExportPattern, RunsThatEndInAnError) {
  const ScratchFolder folder;
  const std::string sound = sample_file("band");
  for (const auto& [arguments, code, words] :
       std::vector<std::tuple<std::vector<std::string>, int, std::string>>{
           {{sound, "-o", folder / "out.ps"}, 1, ".svg"},
           {{folder / "none.json", "-o", folder / "out.svg"}, 1, "none.json"},
           {{sound, "-o", folder / "out.svg", "--seam-allowance", "20cm"}, 2, "--seam-allowance"},
           {{sound, "-o", folder / "out.svg", "--seam-allowance", "10"}, 2, "--seam-allowance"},
           {{"-o", folder / "out.svg"}, 2, "pattern"}}) {
    const auto done = run("export-pattern", arguments);
    EXPECT_EQ(done.exit_code, code) << done.err;
    EXPECT_HOLDS(done.err, words);
    EXPECT_TRUE(folder.names().empty());
  }
}

}  // namespace export_pattern_test
}  // namespace toile
