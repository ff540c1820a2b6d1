// dress --from: a garment is put on a standing body, and goes with it into its pose.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace posed_drape_test {

using Json = nlohmann::json;

class PosedDrape : public WornSample {
 protected:
  void SetUp() override {
    make_body("12mm");
    standing = folder / "standing.ply";
    fs::rename(body, standing);
    fs::rename(folder / "body.body.json", folder / "standing.body.json");
  }

  void pose(const std::string& name) const {
    succeed("pose-body", {standing, "--pose", name, "-o", body, "-q"});
  }

  pipeline::Run follow(const std::string& name, std::vector<std::string> options = {}) const {
    options.insert(options.end(), {"--from", standing});
    return dress(name, options);
  }

  fs::path standing;
};

TEST_F(PosedDrape, ATShirtSitsDown) {
  pose("sitting");
  mesh(sample("tshirt"), "25mm");
  const auto done = follow("sits");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  const Json said = report("sits");
  EXPECT_EQ(said["verdict"], "sewn");
  EXPECT_EQ(said["intersections"]["body"], 0);
  EXPECT_EQ(said["intersections"]["self"], 0);
  EXPECT_EQ(said["inputs"]["from"], standing.string());
  const auto follows = std::ranges::count_if(
      said["stages"], [](const Json& stage) { return stage["name"] == "follow"; });
  EXPECT_EQ(follows, 1);
}

TEST_F(PosedDrape, AnArmIsRaisedWithItsSleeve) {
  pose("reaching");
  mesh(sample("tshirt"), "25mm");
  const auto done = follow("reaching");
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const Json said = report("reaching");
  const auto arm = std::ranges::find_if(
      said["wraps"], [](const Json& wrap) { return wrap["part"] == "right_arm"; });
  ASSERT_NE(arm, said["wraps"].end());
  EXPECT_GT((*arm)["fraction"], 0.95);
  // The same bits once more, on another number of threads.
  ASSERT_EQ(follow("again", {"--threads", "1"}).exit_code, 0);
  EXPECT_EQ(read_text(folder / "again.obj"), read_text(folder / "reaching.obj"));
}

TEST_F(PosedDrape, FitTakesAPosedBodyAsItIs) {
  pose("walking");
  const auto done = run("toile", {"fit", "--body", body, "--from", standing, sample("tshirt"), "-o",
                                  folder / "fit", "--edge-length", "25mm", "-q"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_TRUE(fs::exists(folder / "fit" / "ease.html"));
  EXPECT_FALSE(fs::exists(folder / "fit" / "body.ply"));
  const auto turned = run("toile", {"fit", "--body", body, "--from", standing, sample("tshirt"),
                                    "-o", folder / "fit", "--up", "y"});
  EXPECT_EQ(turned.exit_code, 2) << turned.err;
}

TEST_F(PosedDrape, KeptDistancesGiveTheSameBits) {
  pose("walking");
  mesh(sample("tube_top"), "25mm");
  ASSERT_EQ(follow("first", {"--cache"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "body.distances"));
  EXPECT_TRUE(fs::exists(folder / "standing.distances"));
  ASSERT_EQ(follow("second", {"--cache"}).exit_code, 0);
  EXPECT_EQ(read_text(folder / "second.obj"), read_text(folder / "first.obj"));
}

TEST_F(PosedDrape, AnotherBodyIsRefused) {
  pose("walking");
  mesh(sample("tube_top"), "25mm");
  make_body("15mm");
  const auto other = follow("other");
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.err.find("standing.ply: has other triangles"), std::string::npos) << other.err;
  EXPECT_FALSE(fs::exists(folder / "other.obj"));
  pose("walking");
  fs::remove(folder / "standing.body.json");
  const auto bare = follow("bare");
  EXPECT_EQ(bare.exit_code, 1);
  EXPECT_NE(bare.err.find("standing.body.json"), std::string::npos) << bare.err;
  EXPECT_EQ(follow("certified", {"--certify-frames"}).exit_code, 2);
  EXPECT_EQ(follow("paper", {"--method", "paper"}).exit_code, 2);
  EXPECT_EQ(follow("both", {"--continue", folder / "first.obj"}).exit_code, 2);
}

}  // namespace posed_drape_test
}  // namespace toile::pipeline
