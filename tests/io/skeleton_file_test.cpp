#include "io/skeleton_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "geometry/error.h"
#include "io/output_file.h"

namespace toile {
namespace skeleton_file_test {

namespace fs = std::filesystem;

class SkeletonFile : public testing::Test {
 protected:
  SkeletonFile()
      : path_(fs::temp_directory_path() / ("toile-" + std::to_string(getpid()) + ".json")) {}
  ~SkeletonFile() override { fs::remove(path_); }

  std::string error_of(const std::string& text) const {
    write_file(path_, text);
    try {
      read_skeleton(path_);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path path_;
};

TEST_F(SkeletonFile, ReadsBackWhatWasWritten) {
  Skeleton skeleton;
  for (const std::string_view name : joint_names) skeleton.joints[std::string(name)] = {0, 1.1, 2};
  skeleton.joints["pelvis"] = {0.1, 1.0 / 3, -1e-17};
  skeleton.segments = body_segments();
  write_skeleton(path_, skeleton);
  EXPECT_FALSE(read_skeleton(path_).cleaned);
  BodyMove cleaned;
  cleaned.rotation << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  cleaned.translation = {1e4, 1.0 / 3, -2};
  cleaned.metres_per_unit = 0.0254;
  skeleton.cleaned = cleaned;
  write_skeleton(path_, skeleton);
  const Skeleton read = read_skeleton(path_);
  ASSERT_TRUE(read.cleaned);
  EXPECT_EQ(read.cleaned->rotation, cleaned.rotation);
  EXPECT_EQ(read.cleaned->translation, cleaned.translation);
  EXPECT_EQ(read.cleaned->metres_per_unit, cleaned.metres_per_unit);
  EXPECT_EQ(read.joints, skeleton.joints);
  ASSERT_EQ(read.segments.size(), skeleton.segments.size());
  EXPECT_EQ(read.segments[0].part, "torso");
  EXPECT_EQ(read.segments[0].from, "pelvis");
  EXPECT_EQ(read.segments[0].to, "waist");
  EXPECT_FALSE(read.measures);
  skeleton.measures.emplace();
  skeleton.measures->girths = {{"waist", {0, 1.0 / 3, 0.01}, {0, 1, 0}, 0.8}};
  skeleton.measures->lengths = {{"waist", 0.8}, {"left_arm_length", 0.56}};
  skeleton.measures->shoulder_points = {{"left", {0.2, 1.4, 0}}};
  write_skeleton(path_, skeleton);
  const std::optional<BodyMeasures> measures = read_skeleton(path_).measures;
  ASSERT_TRUE(measures);
  ASSERT_EQ(measures->girths.size(), 1U);
  EXPECT_EQ(measures->girths[0].name, "waist");
  EXPECT_EQ(measures->girths[0].origin, skeleton.measures->girths[0].origin);
  EXPECT_EQ(measures->girths[0].normal, skeleton.measures->girths[0].normal);
  EXPECT_EQ(measures->girths[0].girth, 0.8);
  EXPECT_EQ(measures->lengths, skeleton.measures->lengths);
  EXPECT_EQ(measures->shoulder_points, skeleton.measures->shoulder_points);
}

TEST_F(SkeletonFile, ErrorsNameTheKey) {
  Skeleton skeleton;
  for (const std::string_view name : joint_names) skeleton.joints[std::string(name)] = {0, 1.1, 2};
  skeleton.segments = body_segments();
  skeleton.cleaned = BodyMove{};
  skeleton.measures.emplace();
  skeleton.measures->girths = {{"waist", {0, 1, 0}, {0, 1, 0}, 0.8}};
  write_skeleton(path_, skeleton);
  const auto sound = nlohmann::json::parse(read_file(path_));
  const auto expect = [&](const std::string& words, const auto& damage) {
    nlohmann::json damaged = sound;
    damage(damaged);
    EXPECT_NE(error_of(damaged.dump()).find(words), std::string::npos) << error_of(damaged.dump());
  };
  expect("no error", [](auto& j) { j["more"] = 1; });
  expect("girth_m: is no length", [](auto& j) { j["measures"]["girths"][0]["girth_m"] = -1; });
  expect("normal: is not of length 1", [](auto& j) {
    j["measures"]["girths"][0]["normal"] = {0, 2, 0};
  });
  expect("lengths_m", [](auto& j) { j["measures"].erase("lengths_m"); });
  expect(", units: is not m", [](auto& j) { j["units"] = "cm"; });
  expect("has no 'up'", [](auto& j) { j.erase("up"); });
  expect("has no 'joints'", [](auto& j) { j.erase("joints"); });
  expect("has no 'segments'", [](auto& j) { j.erase("segments"); });
  expect("joint 'left_knee' is missing", [](auto& j) { j["joints"].erase("left_knee"); });
  expect(", joints, neck[1]: is not a number", [](auto& j) { j["joints"]["neck"][1] = "x"; });
  expect(", joints, neck: has 2 entries", [](auto& j) { j["joints"]["neck"].erase(2); });
  for (const double far : {1e15, -1e18, 1e300}) {
    expect(", joints, neck: a coordinate is", [=](auto& j) { j["joints"]["neck"][0] = far; });
  }
  expect("'tail' is unknown", [](auto& j) { j["segments"][0]["part"] = "tail"; });
  expect("joint 'c' is missing", [](auto& j) { j["segments"][0]["to"] = "c"; });
  expect("segments[0]: is not an object", [](auto& j) { j["segments"][0] = 3; });
  expect("has no segment of torso from pelvis", [](auto& j) { j["segments"].erase(0); });
  expect("cleaned, rotation: is no rotation", [](auto& j) { j["cleaned"]["rotation"][0][0] = -1; });
  expect("rotation[1]: has 2 entries", [](auto& j) { j["cleaned"]["rotation"][1].erase(2); });
  expect("is not positive", [](auto& j) { j["cleaned"]["metres_per_unit"] = 0; });
  EXPECT_NE(error_of("").find(":1:1: is not JSON here"), std::string::npos);
  EXPECT_NE(error_of("[]").find("is not an object"), std::string::npos);
  EXPECT_NE(error_of(R"({"joints":{"a":[0,1e999,2]}})").find("a number is too large"),
            std::string::npos);
}

TEST_F(SkeletonFile, IsToldFromOtherJson) {
  const auto is_skeleton = [this](const std::string& text) {
    write_file(path_, text);
    return is_skeleton_file(path_);
  };
  EXPECT_TRUE(is_skeleton(R"({"format": "toile-body"})"));
  EXPECT_TRUE(is_skeleton(R"({"format": "toil", "joints": {}})"));
  EXPECT_FALSE(is_skeleton(R"({"pattern": {}})"));
  EXPECT_FALSE(is_skeleton("[3]"));
  EXPECT_THROW(is_skeleton(R"({"format": "toile-body")"), Error);
  EXPECT_FALSE(is_skeleton_file(path_.string() + ".absent"));
}

TEST(SkeletonPath, LiesBesideTheBody) {
  EXPECT_EQ(skeleton_path("some/body.v2.ply"), fs::path("some/body.v2.body.json"));
}

TEST_F(SkeletonFile, OfAnEarlierVersionIsRead) {
  const fs::path body = fs::path(path_).replace_extension(".ply");
  write_skeleton(path_, Skeleton());
  EXPECT_EQ(skeleton_beside(body), path_);
  write_file(path_, R"({"format": "toile-measures", "landmarks": {}})");
  EXPECT_EQ(skeleton_beside(body), skeleton_path(body));
}

}  // namespace skeleton_file_test
}  // namespace toile
