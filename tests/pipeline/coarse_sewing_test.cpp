// Sewing on a mesh that is coarser than seams need, and on the next finer one where that tangles.
#include <gtest/gtest.h>

#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace coarse_sewing_test {

class CoarseSewing : public WornSample {
 protected:
  void SetUp() override { make_body(); }

  /// Nodes of the mesh and number of the attempt, of each run that closed the trousers' seams.
  std::vector<std::pair<int, int>> closings(const std::string& subdivisions) const {
    succeed("mesh-pattern", {sample("trousers"), "-o", garment, "--edge-length", "25mm",
                             "--subdivisions", subdivisions, "-q"});
    const pipeline::Run done = dress("trousers", {"--quality", "draft"});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    const nlohmann::json said = report("trousers");
    EXPECT_EQ(said["intersections"]["body"], 0);
    EXPECT_EQ(said["intersections"]["self"], 0);
    std::vector<std::pair<int, int>> found;
    for (const nlohmann::json& stage : said["stages"]) {
      if (stage["name"] == "close_seams") found.emplace_back(stage["nodes"], stage["attempt"]);
    }
    return found;
  }
};

TEST_F(CoarseSewing, TakesTheCoarsestMeshWhereItComesOutClear) {
  const auto on_50_mm = closings("1");
  const auto on_100_mm = closings("2");
  ASSERT_EQ(on_50_mm.size(), 1U);
  ASSERT_EQ(on_100_mm.size(), 1U);
  EXPECT_LT(2 * on_100_mm[0].first, on_50_mm[0].first);
  EXPECT_EQ(on_100_mm[0].second, 1);
}

TEST_F(CoarseSewing, GoesOnToTheNextFinerMeshWhereItTangles) {
  // Three points around a leg do not close around it.
  const auto on_200_mm = closings("3");
  ASSERT_EQ(on_200_mm.size(), 2U);
  EXPECT_GT(on_200_mm[1].first, 2 * on_200_mm[0].first);
  EXPECT_EQ(on_200_mm[0].second, 1);
  EXPECT_EQ(on_200_mm[1].second, 2);
}

}  // namespace coarse_sewing_test
}  // namespace toile::pipeline
