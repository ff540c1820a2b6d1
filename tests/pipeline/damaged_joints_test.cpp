// A body.body.json that is damaged: each program that reads it says so and writes nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace toile {
namespace damaged_joints_test {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using pipeline::run;

class DamagedJoints : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<pipeline::ScratchFolder>();
    ASSERT_EQ(run("make-mannequin", {"-q", "--edge-length", "15mm", "-o", *folder_ / "body.ply"})
                  .exit_code,
              0);
    ASSERT_EQ(run("mesh-pattern", {"-q", fs::path(TOILE_SOURCE_DIR) / "samples/band_small.json",
                                   "-o", *folder_ / "band.obj"})
                  .exit_code,
              0);
    sound_ = Json::parse(pipeline::read_text(*folder_ / "body.body.json"));
  }
  static void TearDownTestSuite() { folder_.reset(); }

  /// Runs each program that reads joints beside the body, with body.body.json of that content.
  static void expect_refused(const std::string& content, const std::string& words) {
    SCOPED_TRACE(words);
    pipeline::write_text(*folder_ / "body.body.json", content);
    const fs::path out = *folder_ / "out";
    const std::string body = *folder_ / "body.ply";
    const std::string band = *folder_ / "band.obj";
    fs::create_directory(out);
    for (const pipeline::Run& ended :
         {run("dress", {"--body", body, band, "-o", out / "dressed.obj"}),
          run("ease-map", {"--body", body, band, "-o", out / "ease.html"}),
          run("clean-body", {body, "-o", out / "clean.ply"})}) {
      EXPECT_EQ(ended.exit_code, 1);
      EXPECT_NE(ended.err.find("body.body.json" + words), std::string::npos) << ended.err;
      EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    }
    EXPECT_TRUE(fs::is_empty(out));
  }

  static void expect_refused(const std::function<void(Json&)>& damage, const std::string& words) {
    Json damaged = sound_;
    damage(damaged);
    expect_refused(damaged.dump(), words);
  }

  static inline std::unique_ptr<pipeline::ScratchFolder> folder_;
  static inline Json sound_;
};

TEST_F(DamagedJoints, AreRefusedByEachProgram) {
  expect_refused("", ":1:1: is not JSON here");
  expect_refused(sound_.dump().substr(0, 300), ":1:300: is not JSON here");
  expect_refused(std::string(140000, '[') + std::string(140000, ']'),
                 ":1:101: more than 100 lists");
  expect_refused([](Json& j) { j["joints"].erase("neck"); },
                 ", segments[2]: joint 'neck' is missing");
  expect_refused([](Json& j) { j["joints"]["neck"][1] = nullptr; },
                 ", joints, neck[1]: is not a number");
  expect_refused([](Json& j) { j["joints"]["neck"][1] = 1e300; },
                 ", joints, neck: a coordinate is 1e+300");
  expect_refused(
      [](Json& j) {
        j["format"] = "toile-bod";
        j["units"] = "cm";
      },
      ", units: is not m");
  expect_refused([](Json& j) { j["segments"].erase(3); }, ", segments: has no segment of head");
}

}  // namespace damaged_joints_test
}  // namespace toile
