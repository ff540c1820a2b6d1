// The built pose-body: files, joints beside the mesh, wrong inputs, a real body.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/mesh_file.h"
#include "io/skeleton_file.h"
#include "tests/support/run_program.h"
#include "tests/support/shapes.h"

namespace toile::pipeline {
namespace pose_body_test {

using Json = nlohmann::json;

bool says(const Run& ended, const std::string& words) {
  return ended.err.find(words) != std::string::npos;
}

double worst_change(const Json& report) {
  double worst = 0;
  for (const Json& girth : report["girths"]) {
    const double change = girth["posed_cm"].get<double>() / girth["standing_cm"].get<double>() - 1;
    worst = std::max(worst, std::abs(change));
  }
  return worst;
}

TEST(PoseBodyProgram, SitsWithItsJointsBesideIt) {
  const ScratchFolder folder;
  ASSERT_EQ(run("make-mannequin", {"-o", folder / "body.ply", "--edge-length", "12mm"}).exit_code,
            0);
  const pipeline::Run ended =
      run("pose-body", {folder / "body.ply", "--pose", "sitting", "-o", folder / "sits.ply",
                        "--report", folder / "report.txt"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out, "");
  const Json report = Json::parse(read_text(folder / "report.txt"));
  EXPECT_EQ(report["self_intersections"]["left"], 0);
  EXPECT_LT(worst_change(report), 0.03);
  const Skeleton sits = read_skeleton(folder / "sits.body.json");
  EXPECT_NEAR(sits.joint("left_hip").y(), sits.joint("left_knee").y(), 0.02);
  EXPECT_GT(sits.joint("left_knee").z(), sits.joint("left_hip").z() + 0.3);
}

TEST(PoseBodyProgram, WrongInputsEndInOneMessage) {
  const ScratchFolder folder;
  ASSERT_EQ(run("make-mannequin", {"-o", folder / "body.ply", "--edge-length", "15mm"}).exit_code,
            0);
  const auto refused = [&](const std::string& body, const std::string& pose,
                           const std::string& words) {
    const pipeline::Run ended =
        run("pose-body", {folder / body, "--pose", pose, "-o", folder / "out.ply"});
    EXPECT_EQ(ended.exit_code, 1) << pose;
    EXPECT_TRUE(says(ended, words)) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_FALSE(fs::exists(folder / "out.ply"));
    EXPECT_FALSE(fs::exists(folder / "out.body.json"));
  };
  const pipeline::Run dancing =
      run("pose-body", {folder / "body.ply", "--pose", "dancing", "-o", folder / "out.ply"});
  EXPECT_EQ(dancing.exit_code, 2);
  EXPECT_TRUE(says(dancing, "is no pose")) << dancing.err;
  for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
           {R"({"joints": {"left_wing": {"flexion": 30}}})", "left_wing"},
           {R"({"joints": {"left_hip": {"flexion": 1e999}}})", "wrong.json"},
           {R"({"joints": {"left_hip": {"flexion": 130}}})", "give -30 to 120"}}) {
    write_text(folder / "wrong.json", text);
    refused("body.ply", folder / "wrong.json", words);
  }
  fs::copy_file(folder / "body.ply", folder / "bare.ply");
  refused("bare.ply", "walking", "holds no joints");
  TriangleMesh ball = test::sphere(0.5, 3);
  write_mesh(folder / "ball.ply", ball);
  fs::copy_file(folder / "body.body.json", folder / "ball.body.json");
  refused("ball.ply", "walking", "does not stand on y = 0");
  for (Vec3& p : ball.points) p.y() += 0.5;
  write_mesh(folder / "ball.ply", ball);
  refused("ball.ply", "walking", "outside of the body");
  Json joints = Json::parse(read_text(folder / "body.body.json"));
  joints["joints"]["left_knee"] = joints["joints"]["left_hip"];
  fs::copy_file(folder / "body.ply", folder / "short.ply");
  write_text(folder / "short.body.json", joints.dump());
  refused("short.ply", "walking", "left_hip and left_knee are at one place");

  // An arm through the trunk is written, with a warning.
  write_text(folder / "through.json", R"({"joints": {"left_shoulder": {"abduction": -30}}})");
  const pipeline::Run through =
      run("pose-body",
          {folder / "body.ply", "--pose", folder / "through.json", "-o", folder / "out.ply"});
  EXPECT_EQ(through.exit_code, 3) << through.err;
  EXPECT_TRUE(says(through, "folds the body into itself")) << through.err;
  EXPECT_TRUE(fs::exists(folder / "out.body.json"));
}

TEST(PoseBodyProgram, MeanAllWalksSitsAndReaches) {
  TOILE_REAL_DATA(data, "bodies/mean_all.obj");
  const ScratchFolder folder;
  ASSERT_EQ(run("clean-body", {data, "-o", folder / "body.ply", "-q"}).exit_code, 0);
  for (const std::string pose : {"walking", "sitting", "reaching"}) {
    const pipeline::Run ended =
        run("pose-body", {folder / "body.ply", "--pose", pose, "-o", folder / "posed.ply",
                          "--report", folder / "report.txt"});
    EXPECT_EQ(ended.exit_code, 0) << pose << ": " << ended.err;
    const Json report = Json::parse(read_text(folder / "report.txt"));
    EXPECT_EQ(report["self_intersections"]["left"], 0) << pose;
    EXPECT_LT(worst_change(report), 0.03) << pose;
  }
}

}  // namespace pose_body_test
}  // namespace toile::pipeline
