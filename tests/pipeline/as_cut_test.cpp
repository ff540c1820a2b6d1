// Ease as cut, against the pattern file: each panel's width where the report says it was measured.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "pattern/file/pattern_file.h"
#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace as_cut_test {

using Json = nlohmann::json;

/// Metres: the width of an outline at a height of its drawing, by the outline's own curves.
double width_at(const PatternPanel& panel, double height) {
  std::vector<Vec2> outline;
  for (const OutlineStep& step : panel.outline) {
    std::vector<Vec2> points = panel.edges[step.edge].curve.sample(400);
    if (!step.forward) std::reverse(points.begin(), points.end());
    outline.insert(outline.end(), points.begin(), points.end() - 1);
  }
  std::vector<double> crossings;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& a = outline[i];
    const Vec2& b = outline[(i + 1) % outline.size()];
    if ((a.y() >= height) == (b.y() >= height)) continue;
    crossings.push_back(a.x() + (height - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(crossings.begin(), crossings.end());
  double width = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    width += crossings[i + 1] - crossings[i];
  return width;
}

class AsCut : public testing::Test {
 protected:
  /// The ease map's report of a pattern on a body.
  Json ease(const fs::path& body, const fs::path& pattern, const std::string& edge_length) {
    const fs::path garment = folder / "garment.obj";
    const fs::path dressed = folder / "dressed.obj";
    EXPECT_EQ(
        run("mesh-pattern", {pattern, "-o", garment, "--edge-length", edge_length, "-q"}).exit_code,
        0);
    EXPECT_EQ(run("dress", {"--body", body, garment, "-o", dressed, "--report",
                            folder / "dressed.json", "--quality", "draft", "-q"})
                  .exit_code,
              0);
    succeed("ease-map", {"--body", body, dressed, "--report", folder / "ease.json", "-q"});
    return Json::parse(read_text(folder / "ease.json"));
  }

  /// Every panel's width at bust, waist and hip is the pattern's within 2 mm.
  void expect_widths_of(const fs::path& file, const Json& report) {
    std::vector<Remark> remarks;
    const Pattern pattern = read_pattern(file, remarks);
    std::map<std::string, const PatternPanel*> panels;
    for (const PatternPanel& panel : pattern.panels) panels[panel.name] = &panel;
    int levels = 0;
    for (const Json& girth : report["girths"]) {
      // Sleeves are drawn along x.
      const std::string level = girth.value("level", "");
      if (level != "bust" && level != "waist" && level != "hip") continue;
      if (girth.contains("no_girth")) continue;
      ++levels;
      double sum = 0;
      for (const Json& panel : girth["panels"]) {
        const double width = 100 * width_at(*panels.at(panel["name"].get<std::string>()),
                                            panel["flat_height_cm"].get<double>() / 100);
        // Of a panel that the level covers in part, the width is less.
        if (!panel["along_line"]) {
          EXPECT_LT(panel["width_cm"].get<double>(), width + 0.2) << girth["level"] << panel;
        }
        if (!panel["along_line"] && panel["on_the_line_cm"].get<double>() > width - 0.5) {
          EXPECT_NEAR(panel["width_cm"].get<double>(), width, 0.2) << girth["level"] << panel;
        }
        sum += panel["width_cm"].get<double>();
      }
      const double line = girth["on_the_line_cm"].get<double>();
      EXPECT_NEAR(girth["as_cut_cm"].get<double>(), sum - line > 1 ? line : sum, 1e-3);
    }
    EXPECT_GE(levels, 1);
  }

  /// Centimetres as cut at the bust.
  static double at_bust(const Json& report) {
    for (const Json& girth : report["girths"]) {
      if (girth.value("level", "") == "bust") return girth["as_cut_cm"].get<double>();
    }
    ADD_FAILURE() << "no bust in " << report["girths"];
    return 0;
  }

  ScratchFolder folder;
};

const fs::path samples = fs::path(TOILE_SOURCE_DIR) / "samples";

TEST_F(AsCut, EachPanelsWidthIsThePatterns) {
  const fs::path body = mannequin("14mm");
  for (const std::string name : {"tshirt", "bodice_dress", "elastic_skirt"}) {
    const fs::path pattern = samples / (name + ".json");
    expect_widths_of(pattern, ease(body, pattern, "25mm"));
  }
}

TEST_F(AsCut, ATShirtsBustIsTheSameAtAnyResolutionFromAnyStart) {
  const fs::path body = mannequin("14mm");
  // Its four panels are 26.5 cm wide at the hem and 26 at the armholes, 41.5 cm above.
  constexpr double cut = 104.15;
  for (const std::string edge_length : {"25mm", "15mm", "10mm"}) {
    const Json report = ease(body, samples / "tshirt.json", edge_length);
    EXPECT_NEAR(at_bust(report), cut, 0.2) << edge_length;
    EXPECT_EQ(report["fit"]["verdict"], "ok");
  }
  for (const double centimetres : {-1.5, 1.0, 2.0}) {
    Json disturbed = Json::parse(read_text(samples / "tshirt.json"));
    double sign = 1;
    for (auto& [name, panel] : disturbed["pattern"]["panels"].items()) {
      sign = -sign;
      for (Json& at : panel["translation"]) at = at.get<double>() + sign * centimetres;
    }
    write_text(folder / "pattern.json", disturbed.dump());
    EXPECT_NEAR(at_bust(ease(body, folder / "pattern.json", "25mm")), cut, 0.2) << centimetres;
  }
}

TEST_F(AsCut, ShirtAndPencilDress) {
  TOILE_REAL_DATA(mean_all, "bodies/mean_all.obj");
  TOILE_REAL_DATA(shirt, "patterns/garmentcode/shirt_mean.json");
  TOILE_REAL_DATA(dress, "patterns/garmentcode/dress_pencil.json");
  const fs::path body = folder / "body.ply";
  ASSERT_EQ(run("clean-body", {mean_all, "-o", body, "-q"}).exit_code, 0);
  for (const std::string edge_length : {"25mm", "15mm"}) {
    const Json report = ease(body, shirt, edge_length);
    expect_widths_of(shirt, report);
    EXPECT_NEAR(at_bust(report), 109.82, 0.2) << edge_length;
    expect_widths_of(dress, ease(body, dress, edge_length));
  }
}

}  // namespace as_cut_test
}  // namespace toile::pipeline
