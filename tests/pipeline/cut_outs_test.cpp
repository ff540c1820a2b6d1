// A cut-out through the whole chain: a hole in the drape, and no fault of the garment.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/types.h"
#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace cut_outs_test {

using Json = nlohmann::json;

class WornCutOut : public WornSample {};

TEST_F(WornCutOut, IsAnOpeningThatTheReportTells) {
  Json pattern = Json::parse(read_text(sample("tshirt")));
  Json& panel = pattern["pattern"]["panels"]["left_front"];
  Vec2 middle = Vec2::Zero();
  for (const Json& vertex : panel["vertices"]) {
    middle += Vec2(vertex[0], vertex[1]) / static_cast<double>(panel["vertices"].size());
  }
  Json hole = Json::array();
  for (int i = 0; i < 40; ++i) {
    const double angle = i * std::numbers::pi / 20;
    hole.push_back({middle.x() + 5 * std::cos(angle), middle.y() + 5 * std::sin(angle)});
  }
  panel["cut_outs"] = Json::array({hole});
  write_text(folder / "pattern.json", pattern.dump());
  make_body();
  mesh(folder / "pattern.json", "15mm");
  const pipeline::Run done = dress("dressed");
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const Json report = this->report("dressed");
  EXPECT_EQ(report["verdict"], "sewn");
  EXPECT_EQ(report["intersections"]["self"], 0);
  EXPECT_TRUE(report["warnings"].empty()) << report["warnings"];
  int cut = 0;
  for (const Json& opening : report["openings"]) {
    if (!opening["is_cut_out"]) continue;
    ++cut;
    EXPECT_EQ(opening["around"], "nothing");
    EXPECT_NEAR(opening["length_cm"], 2 * std::numbers::pi * 5, 0.5);
  }
  EXPECT_EQ(cut, 1);
  EXPECT_EQ(report["openings"].size(), 5U) << "neck, two arms, hem and the hole";
}

}  // namespace cut_outs_test
}  // namespace toile::pipeline
