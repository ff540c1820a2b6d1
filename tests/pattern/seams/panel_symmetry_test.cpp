#include "pattern/seams/panel_symmetry.h"

#include "tests/pattern/samples.h"

namespace toile {
namespace panel_symmetry_test {

std::vector<WalkedEdge> edges_of(const std::string& panels) {
  std::vector<Remark> remarks;
  return walked_edges(parse_drawn_pattern(samples::file(panels), "test", remarks), false);
}

TEST(PanelSymmetry, ARectangleLiesOnItselfInFourWays) {
  const auto edges = edges_of(samples::polygon("a", "[0,0],[30,0],[30,10],[0,10]"));
  const auto fits = panel_fits(edges);
  EXPECT_EQ(fits.size(), 4u);
  const auto shapes = edge_shapes(edges, fits);
  EXPECT_EQ(shapes.shape, (std::vector<int>{0, 1, 0, 1}));
}

TEST(PanelSymmetry, FindsTheMirrorImageOfAPanel) {
  const auto edges = edges_of(samples::polygon("a", "[0,0],[30,0],[20,10],[0,10]") + "," +
                              samples::polygon("b", "[0,0],[0,10],[-20,10],[-30,0]"));
  const auto fits = panel_fits(edges);
  ASSERT_EQ(fits.size(), 4u);  // each on itself and on the other
  const auto shapes = edge_shapes(edges, fits);
  for (int e = 4; e < 8; ++e) {
    EXPECT_LT(shapes.shape[e], 4);
    EXPECT_EQ(shapes.hand[e], -1);
    EXPECT_NEAR(edges[e].length, edges[shapes.shape[e]].length, 1e-9);
  }
}

TEST(PanelSymmetry, OutlinesCoincideWhereverTheyAreSplit) {
  const auto edges = edges_of(samples::polygon("a", "[0,0],[30,0],[20,10],[0,10]") + "," +
                              samples::polygon("b", "[0,0],[7,0],[30,0],[20,10],[0,10]"));
  int across = 0;
  for (const PanelFit& fit : panel_fits(edges)) {
    if (fit.from != 0 || fit.to != 1) continue;
    ++across;
    EXPECT_EQ(fit.image, (std::vector<int>{-1, 6, 7, 8}));
  }
  EXPECT_EQ(across, 1);
}

}  // namespace panel_symmetry_test
}  // namespace toile
