#include "pattern/seams/seam_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "io/output_file.h"
#include "pattern/file/pattern_file.h"
#include "pattern/seams/sewn_file.h"
#include "tests/pattern/samples.h"
#include "tests/support/seam_comparison.h"

namespace toile {
namespace seam_pairs_test {

SeamEvidence evidence_of(const std::string& panels, bool heed_sides = true) {
  std::vector<Remark> remarks;
  return seam_evidence(parse_drawn_pattern(samples::file(panels), "test", remarks), false, {},
                       heed_sides);
}

double likely(const SeamPairs& pairs, int a, int b) {
  return pairs.measures(a, b)[static_cast<int>(SeamMeasure::likely)];
}

// Edges of the mirrored drawing follow each other the other way round.
TEST(SeamPairs, AMirroredDrawingHasTheSameLikelySeams) {
  const std::string front = samples::polygon("front", "[0,0],[20,2],[24,50],[8,55],[-2,30]");
  const std::string sleeve = samples::polygon("sleeve", "[0,0],[30,0],[34,20],[15,31],[-4,20]");
  const std::string front_mirrored =
      samples::polygon("front", "[0,0],[2,30],[-8,55],[-24,50],[-20,2]");
  const std::string sleeve_mirrored =
      samples::polygon("sleeve", "[0,0],[4,20],[-15,31],[-34,20],[-30,0]");
  const SeamEvidence drawn = evidence_of(front + "," + sleeve);
  const SeamEvidence mirrored = evidence_of(front_mirrored + "," + sleeve_mirrored);
  const SeamPairs pairs(drawn);
  const SeamPairs mirrored_pairs(mirrored);
  const auto image = [](int e) { return e < 5 ? 4 - e : 14 - e; };
  for (int a = 0; a < 5; ++a) {
    for (int b = 5; b < 10; ++b) {
      EXPECT_NEAR(drawn.edges[a].length, mirrored.edges[image(a)].length, 1e-12);
      // What is hopeless is looked at from one side.
      const double logit = likely(pairs, a, b);
      const double mirrored_logit = likely(mirrored_pairs, image(a), image(b));
      if (std::max(logit, mirrored_logit) < -4) continue;
      EXPECT_NEAR(logit, mirrored_logit, 1e-4);
      EXPECT_EQ(likely(pairs, a, b), likely(pairs, b, a));
    }
  }
}

TEST(SeamPairs, OrderInTheFileSaysNothing) {
  const std::string front = samples::polygon("front", "[0,0],[20,2],[24,50],[8,55],[-2,30]");
  const std::string back = samples::polygon("back", "[0,0],[22,0],[24,52],[8,58],[0,30]");
  const std::string cuff = samples::polygon("cuff", "[0,0],[20,0],[20,6],[0,6]");
  const SeamEvidence one = evidence_of(front + "," + back + "," + cuff);
  const SeamEvidence other = evidence_of(back + "," + front + "," + cuff);
  for (int a = 0; a < 5; ++a) {
    for (int b = 5; b < 10; ++b) {
      const double logit = likely(SeamPairs(one), a, b);
      const double exchanged = likely(SeamPairs(other), a + 5, b - 5);
      if (std::max(logit, exchanged) < -4) continue;
      EXPECT_NEAR(logit, exchanged, 1e-9);
    }
  }
}

TEST(SeamPairs, LeftAndRightCountOnlyWhereTheyAreHeeded) {
  const std::string same = "[0,0],[20,0],[22,50],[0,50]";
  const auto logit = [&](const std::string& other, bool heed_sides) {
    const SeamEvidence evidence = evidence_of(
        samples::polygon("left_front", same) + "," + samples::polygon(other, same), heed_sides);
    return likely(SeamPairs(evidence), 1, 7);
  };
  EXPECT_NE(logit("left_back", true), logit("right_back", true));
  EXPECT_EQ(logit("left_back", false), logit("right_back", false));
}

TEST(SeamPairs, NeighboursAreSewnAsDartsAlone) {
  const SeamEvidence evidence =
      evidence_of(samples::polygon("skirt", "[0,0],[40,0],[40,60],[21,60],[20,48],[19,60],[0,60]"));
  const SeamPairs pairs(evidence);
  int darts = 0;
  for (int e = 0; e < 7; ++e) darts += pairs.possible(e, evidence.edges[e].next) ? 1 : 0;
  EXPECT_EQ(darts, 1);
  EXPECT_FALSE(pairs.possible(0, 0));
}

TEST(SeamPairs, NoEdgeIsGatheredToAQuarter) {
  const SeamEvidence evidence =
      evidence_of(samples::polygon("skirt", "[0,0],[82,0],[82,60],[0,60]") + "," +
                  samples::polygon("flounce", "[0,0],[20,0],[20,6],[0,6]"));
  EXPECT_FALSE(SeamPairs(evidence).possible(2, 4));
  EXPECT_TRUE(SeamPairs(evidence).possible(1, 4));
}

// Without names, places and seams.
TEST(SeamPairs, MostSeamsOfTheSamplesAreTheLikeliestOfTheirEdges) {
  int edges = 0;
  int best = 0;
  for (const char* sample : {"tshirt", "fitted_tshirt", "trousers"}) {
    const std::string name = std::string(TOILE_SOURCE_DIR "/samples/") + sample + ".json";
    std::vector<Remark> remarks;
    const std::string text = read_file(name);
    const Pattern pattern = parse_drawn_pattern(text, name, remarks);
    const SeamEvidence evidence =
        seam_evidence(stripped(pattern, false, false), has_drawn_walk(text, name));
    const SeamPairs pairs(evidence);
    std::map<std::array<int, 2>, int> number;
    const int count = static_cast<int>(evidence.edges.size());
    for (int e = 0; e < count; ++e) {
      number[{evidence.edges[e].ref.panel, evidence.edges[e].ref.edge}] = e;
    }
    for (const SeamPair& seam : stated_seams(pattern)) {
      const int a = number.at(seam.a);
      const double right = likely(pairs, a, number.at(seam.b));
      bool is_best = true;
      for (int b = 0; b < count; ++b) {
        if (pairs.possible(a, b)) is_best = is_best && likely(pairs, a, b) <= right + 1e-9;
      }
      ++edges;
      best += is_best ? 1 : 0;
    }
  }
  EXPECT_GE(best, 0.75 * edges) << best << " of " << edges;
}

}  // namespace seam_pairs_test
}  // namespace toile
