#include "io/skeleton_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

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
  skeleton.joints["pelvis"] = {0.1, 1.0 / 3, -1e-17};
  skeleton.joints["waist"] = {0, 1.1, 2};
  skeleton.segments = {{"torso", "pelvis", "waist"}};
  write_skeleton(path_, skeleton);
  const Skeleton read = read_skeleton(path_);
  EXPECT_EQ(read.joints, skeleton.joints);
  ASSERT_EQ(read.segments.size(), 1u);
  EXPECT_EQ(read.segments[0].part, "torso");
  EXPECT_EQ(read.segments[0].from, "pelvis");
  EXPECT_EQ(read.segments[0].to, "waist");
}

TEST_F(SkeletonFile, ErrorsNameTheKey) {
  const std::string head = R"({"units":"m","up":"y","joints":{"a":[0,1,2],"b":[0,0,0]})";
  EXPECT_EQ(error_of(head + R"(,"segments":[{"part":"head","from":"a","to":"b"}],"more":1})"),
            "no error");
  EXPECT_NE(error_of("").find("not JSON"), std::string::npos);
  EXPECT_NE(error_of("[]").find("no JSON object"), std::string::npos);
  EXPECT_NE(error_of(R"({"units":"cm","up":"y"})").find("'units'"), std::string::npos);
  EXPECT_NE(error_of(R"({"units":"m"})").find("'up'"), std::string::npos);
  EXPECT_NE(error_of(head + "}").find("'segments'"), std::string::npos);
  EXPECT_NE(
      error_of(R"({"units":"m","up":"y","joints":{"a":[0,"x",2]},"segments":[]})").find("'a'"),
      std::string::npos);
  EXPECT_NE(error_of(R"({"units":"m","up":"y","joints":{"a":[0,1e999,2]},"segments":[]})"),
            "no error");
  EXPECT_NE(error_of(head + R"(,"segments":[{"part":"tail","from":"a","to":"b"}]})").find("'tail'"),
            std::string::npos);
  EXPECT_NE(error_of(head + R"(,"segments":[{"part":"head","from":"a","to":"c"}]})").find("'c'"),
            std::string::npos);
  EXPECT_NE(error_of(head + R"(,"segments":[3]})").find("'part'"), std::string::npos);
}

TEST(SkeletonPath, LiesBesideTheBody) {
  EXPECT_EQ(skeleton_path("some/body.v2.ply"), fs::path("some/body.v2.json"));
}

}  // namespace skeleton_file_test
}  // namespace toile
