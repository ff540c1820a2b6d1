#include "pattern/seams/seam_search.h"

#include <gtest/gtest.h>

#include <utility>

#include "pattern/file/pattern_file.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace seam_search_test {

SeamEvidence evidence_of(const std::string& panels) {
  std::vector<Remark> remarks;
  return seam_evidence(parse_drawn_pattern(samples::file(panels), "test", remarks), false);
}

double measured(const SeamEvidence& evidence, const Partners& partners, SeamMeasure measure) {
  const SeamPairs pairs(evidence);
  SeamSearch search(evidence, pairs, seam_weights, {});
  return search.measures(partners)[static_cast<int>(measure)];
}

Partners sewn(const SeamEvidence& evidence, const std::vector<std::array<int, 2>>& seams) {
  Partners partners(evidence.edges.size(), -1);
  for (const auto& [a, b] : seams) {
    partners[a] = b;
    partners[b] = a;
  }
  return partners;
}

// Front and back of a skirt whose sides are cut 20 cm above the hem. Edges: hem, the right side in
// two parts, top, the left side in two parts.
const std::string sides = "[0,0],[60,0],[60,20],[60,60],[0,60],[0,20]";
const std::string skirt =
    samples::polygon("skirt_front", sides) + "," + samples::polygon("skirt_back", sides);

TEST(Slits, AreTheLowerPartsOfSidesThatAreCutForNothingElse) {
  const SeamEvidence evidence = evidence_of(skirt);
  const Partners slits = sewn(evidence, {{2, 10}, {4, 8}});
  const Partners all = sewn(evidence, {{2, 10}, {4, 8}, {1, 11}, {5, 7}});
  const Partners above = sewn(evidence, {{1, 11}, {5, 7}});
  EXPECT_EQ(measured(evidence, slits, SeamMeasure::needless_cut), 0);
  EXPECT_EQ(measured(evidence, all, SeamMeasure::needless_cut), 2);
  EXPECT_EQ(measured(evidence, slits, SeamMeasure::slit_above), 0);
  EXPECT_NEAR(measured(evidence, above, SeamMeasure::slit_above), 2, 1e-9);
}

TEST(Slits, AreNoneWhereNotchesOrAKinkTellWhyAnEdgeIsCut) {
  const std::string kinked = "[0,0],[60,0],[61,20],[60,60],[0,60],[-1,20]";
  const SeamEvidence kink = evidence_of(samples::polygon("skirt_front", kinked) + "," +
                                        samples::polygon("skirt_back", kinked));
  const std::vector<std::array<int, 2>> all = {{2, 10}, {4, 8}, {1, 11}, {5, 7}};
  EXPECT_EQ(measured(kink, sewn(kink, all), SeamMeasure::needless_cut), 0);
  SeamEvidence notched = evidence_of(skirt);
  for (const int e : {2, 5, 8, 11}) notched.edges[e].notch = true;
  EXPECT_EQ(measured(notched, sewn(notched, all), SeamMeasure::needless_cut), 0);
}

TEST(Borders, AreCountedAgainstThoseThatThePiecesNeed) {
  const std::string tube = "[0,0],[30,0],[30,50],[0,50]";
  const SeamEvidence evidence = evidence_of(samples::polygon("left_sleeve", tube) + "," +
                                            samples::polygon("right_sleeve", tube));
  // A neck or waist and two wrists; two flat panels have two borders.
  EXPECT_EQ(measured(evidence, sewn(evidence, {}), SeamMeasure::borders_missing), 1);
  const Partners tubes = sewn(evidence, {{1, 3}, {5, 7}});
  EXPECT_EQ(measured(evidence, tubes, SeamMeasure::borders_missing), 0);
  const SeamEvidence pieces =
      evidence_of(samples::polygon("piece1", tube) + "," + samples::polygon("piece2", tube));
  EXPECT_EQ(measured(pieces, sewn(pieces, {{0, 4}}), SeamMeasure::borders_missing), 0)
      << "names that say nothing ask for none";
}

TEST(Climbing, EndsWhereNoSingleMoveGains) {
  SeamEvidence evidence = evidence_of(skirt);
  evidence.mirror.assign(evidence.edges.size(), -1);  // mirror partners would move together
  const SeamPairs pairs(evidence);
  SeamSearch search(evidence, pairs, seam_weights, {});
  const auto scored = [&](const Partners& partners) {
    return SeamSearch::Garment{partners, score_of(search.measures(partners), seam_weights)};
  };
  const SeamSearch::Garment from = scored(sewn(evidence, {{2, 10}}));
  const SeamSearch::Garment top = search.climbed(from);
  EXPECT_GT(top.score, from.score);
  EXPECT_NEAR(top.score, scored(top.partners).score, 1e-6);
  EXPECT_EQ(search.climbed(top).partners, top.partners);
  for (int a = 0; a < 12; ++a) {
    for (int b = a; b < 12; ++b) {
      Partners other = top.partners;
      if (a == b && other[a] >= 0) {
        other[std::exchange(other[a], -1)] = -1;
      } else if (a != b && other[a] < 0 && other[b] < 0 && pairs.possible(a, b)) {
        other[a] = b;
        other[b] = a;
      }
      EXPECT_LE(scored(other).score, top.score + 1e-6) << a << " and " << b;
    }
  }
}

}  // namespace seam_search_test
}  // namespace toile
