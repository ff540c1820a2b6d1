#include "pattern/seams/number_panels.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/pattern/samples.h"

namespace toile {
namespace number_panels_test {

using namespace samples;

/// A gore: edge 1 is its right side, edge 2 its top, edge 3 its left side.
const char* const gore = "[0,0],[30,0],[20,40],[10,40]";

std::vector<EdgeSeam> numbered(const Pattern& pattern, std::vector<EdgeSeam> seams) {
  const std::vector<WalkedEdge> edges = walked_edges(pattern, false);
  std::vector<PanelWords> words;
  for (const PatternPanel& panel : pattern.panels) words.push_back(words_of(panel));
  number_panels(pattern, edges, panel_fits(edges), words, seams);
  return seams;
}

std::set<std::array<int, 2>> pairs(const std::vector<EdgeSeam>& seams) {
  std::set<std::array<int, 2>> all;
  for (const EdgeSeam& seam : seams)
    all.insert({std::min(seam.a, seam.b), std::max(seam.a, seam.b)});
  return all;
}

TEST(NumberPanels, NumbersRunAroundARingToTheRight) {
  const Pattern pattern =
      parse(file(polygon("skirt_0", gore) + "," + polygon("skirt_1", gore) + "," +
                 polygon("skirt_2", gore) + "," + polygon("skirt_3", gore)));
  // Around the ring: 0, 2, 1, 3. Edges of a panel are in a row.
  const auto right = [](int panel) { return 4 * panel + 1; };
  const auto left = [](int panel) { return 4 * panel + 3; };
  const std::vector<EdgeSeam> mixed = {
      {right(0), left(2)}, {right(2), left(1)}, {right(1), left(3)}, {right(3), left(0)}};
  const std::set<std::array<int, 2>> expected = {
      {right(0), left(1)}, {right(1), left(2)}, {right(2), left(3)}, {left(0), right(3)}};
  EXPECT_EQ(pairs(numbered(pattern, mixed)), expected);
}

TEST(NumberPanels, PanelsOfOneSeamEachFollowTheDrawing) {
  // The tops of two gores are sewn to the lower edge of a front, the second one to its left part.
  const Pattern pattern =
      parse(file(polygon("skirt_0", gore) + "," + polygon("skirt_1", gore) + "," +
                 polygon("bodice_front", "[0,0],[10,0],[20,0],[20,30],[0,30]")));
  const std::vector<EdgeSeam> swapped = {{2, 9}, {6, 8}};
  EXPECT_EQ(pairs(numbered(pattern, swapped)), (std::set<std::array<int, 2>>{{2, 8}, {6, 9}}));
}

TEST(NumberPanels, OtherShapesStayWhereTheyAre) {
  const Pattern pattern = parse(
      file(polygon("skirt_0", gore) + "," + polygon("skirt_1", "[0,0],[30,0],[22,40],[10,40]") +
           "," + polygon("bodice_front", "[0,0],[10,0],[20,0],[20,30],[0,30]")));
  const std::vector<EdgeSeam> seams = {{2, 9}, {6, 8}};
  EXPECT_EQ(pairs(numbered(pattern, seams)), pairs(seams));
}

}  // namespace number_panels_test
}  // namespace toile
