#include "pattern/seams/seam_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "io/output_file.h"
#include "pattern/file/pattern_file.h"
#include "pattern/seams/sewn_file.h"
#include "tests/pattern/samples.h"
#include "tests/support/seam_comparison.h"

namespace toile {
namespace seam_pairs_test {

SeamEvidence evidence_of(const std::string& panels) {
  std::vector<Remark> remarks;
  return seam_evidence(parse_drawn_pattern(samples::file(panels), "test", remarks), false);
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
  const auto drawn = [&](const std::string& other) {
    return evidence_of(samples::polygon("left_front", same) + "," + samples::polygon(other, same));
  };
  const auto logit = [](const SeamEvidence& evidence) { return likely(SeamPairs(evidence), 1, 7); };
  const SeamEvidence left = drawn("left_back");
  const SeamEvidence right = drawn("right_back");
  EXPECT_NE(logit(left), logit(right));
  EXPECT_EQ(logit(heeding(SideNames::ignored, left)), logit(heeding(SideNames::ignored, right)));
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

// Drafts that nothing was learned from, without names, places and seams. Of edges of one length the
// first would be taken by chance: such a pair counts as the share of those edges.
TEST(SeamPairs, LikeliestPairsOfDraftsAreRightMoreOftenThanThoseOfTheLikestLengths) {
  double likeliest = 0;
  double likest = 0;
  for (const char* draft : {"brian", "lily", "teagan"}) {
    const std::string name =
        std::string(TOILE_SOURCE_DIR "/tests/pattern/seams/drafts/") + draft + ".json";
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
      const int b = number.at(seam.b);
      const auto share_of_best = [&](const auto& score) {
        int as_good = 0;
        for (int e = 0; e < count; ++e) {
          if (!pairs.possible(a, e)) continue;
          if (score(e) > score(b) + 1e-9) return 0.0;
          as_good += score(e) > score(b) - 1e-9 ? 1 : 0;
        }
        return 1.0 / as_good;
      };
      likeliest += share_of_best([&](int e) { return likely(pairs, a, e); });
      likest += share_of_best([&](int e) {
        const double length = evidence.edges[a].length;
        return std::round(-1e4 * std::abs(evidence.edges[e].length - length));  // 0.1 mm
      });
    }
  }
  EXPECT_GT(likeliest, 1.5 * likest);
}

}  // namespace seam_pairs_test
}  // namespace toile
