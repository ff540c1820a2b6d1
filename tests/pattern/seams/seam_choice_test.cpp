#include "pattern/seams/seam_choice.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include "io/output_file.h"
#include "pattern/file/pattern_file.h"
#include "tests/support/seam_comparison.h"

namespace toile {
namespace seam_choice_test {

class SeamsOfTshirt : public testing::Test {
 protected:
  SeamsOfTshirt() {
    const std::string name = TOILE_SOURCE_DIR "/samples/tshirt.json";
    std::vector<Remark> remarks;
    const Pattern pattern = parse_drawn_pattern(read_file(name), name, remarks);
    evidence = seam_evidence(stripped(pattern, true, false), false);
  }

  SeamEvidence evidence;
};

TEST_F(SeamsOfTshirt, AreTheSameBitsForAnyNumberOfThreads) {
  const auto choose = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return SeamChooser(evidence, {}).choose();
  };
  const SeamChoice one = choose(1);
  const SeamChoice four = choose(4);
  EXPECT_EQ(one.score, four.score);
  ASSERT_EQ(one.seams.size(), four.seams.size());
  for (std::size_t i = 0; i < one.seams.size(); ++i) {
    EXPECT_EQ(one.seams[i].a, four.seams[i].a);
    EXPECT_EQ(one.seams[i].b, four.seams[i].b);
    EXPECT_EQ(one.seams[i].features, four.seams[i].features);
    EXPECT_EQ(one.seams[i].alternative, four.seams[i].alternative);
  }
}

// Drafts without their names: some seams have a rival.
TEST(SeamChoice, AlternativesAreOtherSeamsOfTheSameEdges) {
  int others = 0;
  for (const char* draft : {"aaron", "hugo", "sven"}) {
    const std::string name =
        std::string(TOILE_SOURCE_DIR "/tests/pattern/seams/drafts/") + draft + ".json";
    std::vector<Remark> remarks;
    const Pattern pattern = parse_drawn_pattern(read_file(name), name, remarks);
    const SeamEvidence evidence = seam_evidence(stripped(pattern, false, false), false);
    for (const ChosenSeam& seam : SeamChooser(evidence, {}).choose().seams) {
      if (seam.alternative[0] < 0) continue;
      ++others;
      EXPECT_NE(seam.alternative, (std::array{seam.a, seam.b}));
      const auto has = [&](int e) { return seam.alternative[0] == e || seam.alternative[1] == e; };
      EXPECT_TRUE(has(seam.a) || has(seam.b));
    }
  }
  EXPECT_GT(others, 0);
}

TEST_F(SeamsOfTshirt, NoForbiddenKindIsSewn) {
  const SeamPairs pairs(evidence);
  SeamSearch search(evidence, pairs, seam_weights, {});
  const SeamSearch::Garment best = search.search(0);
  int a = 0;
  while (best.partners[a] < 0) ++a;
  const int kind = search.kind(a, best.partners[a]);
  search.forbid(kind);
  const SeamSearch::Garment other = search.near(best.partners);
  for (int e = 0; e < static_cast<int>(other.partners.size()); ++e) {
    if (other.partners[e] < 0) continue;
    EXPECT_NE(search.kind(e, other.partners[e]), kind);
  }
}

TEST(SeamCertainty, IsHighWhereAllFeaturesSpeakForASeam) {
  SeamFeatures good{};
  for (const SeamFeature feature :
       {SeamFeature::one, SeamFeature::found, SeamFeature::settled, SeamFeature::named}) {
    good[static_cast<int>(feature)] = 1;
  }
  for (const SeamFeature feature : {SeamFeature::gap, SeamFeature::garment_gap}) {
    good[static_cast<int>(feature)] = 1.8;
  }
  good[static_cast<int>(SeamFeature::edges)] = 3;
  SeamFeatures bad{};
  bad[static_cast<int>(SeamFeature::one)] = 1;
  bad[static_cast<int>(SeamFeature::edges)] = 5;
  EXPECT_GT(certainty_of(good), decided_confidence);
  EXPECT_LT(certainty_of(bad), 0.5);
}

}  // namespace seam_choice_test
}  // namespace toile
