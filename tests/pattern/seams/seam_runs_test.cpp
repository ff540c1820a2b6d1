#include "pattern/seams/seam_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace toile {
namespace seam_runs_test {

PatternPanel panel(const std::string& name, const std::vector<Vec2>& corners) {
  PatternPanel panel;
  panel.name = name;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    panel.edges.push_back({EdgeCurve::line(corners[i], corners[(i + 1) % corners.size()]), ""});
    panel.outline.push_back({static_cast<int>(i), true});
  }
  return panel;
}

/// A skirt whose sides are sewn, and its waistband, 80 cm long.
Pattern skirt() {
  Pattern pattern;
  pattern.panels.push_back(panel("front", {{0, 0}, {0.5, 0}, {0.45, 0.6}, {0.05, 0.6}}));
  pattern.panels.push_back(panel("back", {{0, 0}, {0.5, 0}, {0.45, 0.6}, {0.05, 0.6}}));
  pattern.panels.push_back(panel("waistband", {{0, 0}, {0.8, 0}, {0.8, 0.04}, {0, 0.04}}));
  return pattern;
}

FoundSeams with_sides(const Pattern& pattern) {
  FoundSeams found;
  for (const auto& [a, b] : {std::array{1, 3}, std::array{3, 1}}) {
    FoundSeam seam;
    seam.a = {0, a};
    seam.b = {1, b};
    seam.length_a = pattern.panels[0].edges[a].curve.length();
    seam.length_b = pattern.panels[1].edges[b].curve.length();
    found.seams.push_back(seam);
  }
  return found;
}

double length_of(const Pattern& pattern, const PanelPart& part) {
  return (part.part.to - part.part.from) *
         pattern.panels[part.panel].edges[part.part.edge].curve.length();
}

TEST(SeamRuns, ABandGoesOnOverTheSideSeams) {
  const Pattern pattern = skirt();
  int found = 0;
  for (const SeamRun& run : seam_runs(with_cuts(pattern, {}), true, with_sides(pattern))) {
    std::map<std::array<int, 2>, double> sewn;  // per panel and edge: length
    for (const auto& seam : run.seams) {
      for (const PanelPart& side : seam)
        sewn[{side.panel, side.part.edge}] += length_of(pattern, side);
    }
    const bool is_waist = sewn[{0, 2}] > 0.39 && sewn[{1, 2}] > 0.39;
    if (!is_waist || sewn[{2, 2}] < 0.79 || run.seams.size() > 2) continue;
    ++found;
    ASSERT_EQ(run.cuts.size(), 1u) << "the band alone is cut";
    EXPECT_EQ(run.cuts.begin()->first[0], 2);
    EXPECT_NEAR(run.cuts.begin()->second.front().share, 0.5, 1e-9);
  }
  EXPECT_EQ(found, 2) << "front first, or back first";
}

TEST(SeamRuns, SidesOfARunGoOnWithoutGapsAndShareTheirEase) {
  const Pattern pattern = skirt();
  const std::vector<SeamRun> runs = seam_runs(with_cuts(pattern, {}), true, with_sides(pattern));
  ASSERT_FALSE(runs.empty());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i > 0) {
      EXPECT_LE(runs[i].gain, runs[i - 1].gain);
    }
    EXPECT_FALSE(runs[i].cuts.empty());
    std::vector<PanelPart> parts;
    std::vector<double> ratios;
    for (const auto& [a, b] : runs[i].seams) {
      ratios.push_back(std::log(length_of(pattern, a) / length_of(pattern, b)));
      parts.insert(parts.end(), {a, b});
    }
    for (const double ratio : ratios) EXPECT_NEAR(std::abs(ratio), std::abs(ratios.front()), 0.02);
    for (std::size_t a = 0; a < parts.size(); ++a) {
      EXPECT_LT(parts[a].part.from, parts[a].part.to);
      for (std::size_t b = 0; b < a; ++b) {
        if (parts[a].panel != parts[b].panel || parts[a].part.edge != parts[b].part.edge) continue;
        EXPECT_TRUE(parts[a].part.to <= parts[b].part.from ||
                    parts[b].part.to <= parts[a].part.from)
            << "no part is sewn twice";
      }
    }
  }
}

TEST(SeamRuns, GivenSeamsAreLeftAlone) {
  const Pattern pattern = skirt();
  FoundSeams found = with_sides(pattern);
  for (FoundSeam& seam : found.seams) seam.given = true;
  for (const SeamRun& run : seam_runs(with_cuts(pattern, {}), true, found)) {
    for (const auto& [a, b] : run.seams) {
      for (const PanelPart& side : {a, b}) {
        EXPECT_FALSE(side.panel < 2 && (side.part.edge == 1 || side.part.edge == 3));
      }
    }
  }
}

}  // namespace seam_runs_test
}  // namespace toile
