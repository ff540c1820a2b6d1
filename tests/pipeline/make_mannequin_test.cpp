// The built make-mannequin: poses, the joints beside the mesh, and how clean-body takes them on.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/mesh_file.h"
#include "io/skeleton_file.h"
#include "tests/support/run_program.h"

namespace toile::pipeline {
namespace make_mannequin_test {

using Json = nlohmann::json;

Run make(const fs::path& to, const std::string& pose, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"-o", to, "--pose", pose, "--edge-length", "15mm"};
  words.insert(words.end(), more.begin(), more.end());
  return run("make-mannequin", words);
}

bool says(const Run& ended, const std::string& words) {
  return ended.err.find(words) != std::string::npos;
}

double farthest(const Skeleton& a, const Skeleton& b) {
  double off = 0;
  for (const auto& [name, joint] : a.joints) off = std::max(off, (joint - b.joint(name)).norm());
  return off;
}

TEST(MakeMannequinProgram, WalksWithItsJointsBesideIt) {
  const ScratchFolder folder;
  const pipeline::Run ended =
      make(folder / "walk.ply", "walking", {"--report", folder / "report.txt"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"report.txt", "walk.body.json", "walk.ply"}));
  const Json report = Json::parse(read_text(folder / "report.txt"));
  EXPECT_NEAR(report["girths"]["knee"]["girth_cm"].get<double>(), 35.31, 0.3);

  // The true joints go through clean-body as they are.
  const pipeline::Run cleaned = run("clean-body", {folder / "walk.ply", "-o", folder / "body.ply"});
  ASSERT_EQ(cleaned.exit_code, 0) << cleaned.err;
  EXPECT_TRUE(says(cleaned, "joints taken from " + (folder / "walk.body.json").string()))
      << cleaned.err;
  const Skeleton walk = read_skeleton(folder / "walk.body.json");
  EXPECT_LT(farthest(walk, read_skeleton(folder / "body.body.json")), 1e-9);

  // In centimetres and 30 cm above the floor they come down with the body.
  const PolygonSoup soup = read_mesh(folder / "walk.ply");
  TriangleMesh raised;
  for (const Vec3& p : soup.points) raised.points.push_back(100 * (p + 0.3 * Vec3::UnitY()));
  for (const auto& t : soup.polygons) raised.triangles.push_back({t[0], t[1], t[2]});
  write_mesh(folder / "raised.ply", raised);
  Skeleton up = walk;
  for (auto& [name, joint] : up.joints) joint.y() += 0.3;
  write_skeleton(folder / "raised.body.json", up);
  const pipeline::Run lowered =
      run("clean-body", {folder / "raised.ply", "-o", folder / "low.ply"});
  ASSERT_EQ(lowered.exit_code, 0) << lowered.err;
  EXPECT_TRUE(says(lowered, "joints taken from")) << lowered.err;
  EXPECT_LT(farthest(walk, read_skeleton(folder / "low.body.json")), 1e-6);
}

TEST(MakeMannequinProgram, AnotherBodysJointsAreNotTaken) {
  const ScratchFolder folder;
  ASSERT_EQ(make(folder / "walk.ply", "walking").exit_code, 0);
  ASSERT_EQ(make(folder / "stand.ply", "standing").exit_code, 0);
  fs::copy_file(skeleton_path(folder / "walk.ply"), skeleton_path(folder / "stand.ply"),
                fs::copy_options::overwrite_existing);
  const pipeline::Run cleaned =
      run("clean-body", {folder / "stand.ply", "-o", folder / "body.ply"});
  ASSERT_EQ(cleaned.exit_code, 0) << cleaned.err;
  EXPECT_TRUE(says(cleaned, "is not this body's")) << cleaned.err;
  const Skeleton found = read_skeleton(folder / "body.body.json");
  EXPECT_GT(farthest(read_skeleton(folder / "walk.body.json"), found), 0.05);
  EXPECT_NEAR(found.joint("left_knee").z(), -0.005, 0.01);

  // A body that faces -z is turned, whatever an earlier run left beside it.
  TriangleMesh back;
  const PolygonSoup soup = read_mesh(folder / "stand.ply");
  for (const Vec3& p : soup.points) back.points.emplace_back(-p.x(), p.y(), -p.z());
  for (const auto& t : soup.polygons) back.triangles.push_back({t[0], t[1], t[2]});
  write_mesh(folder / "back.ply", back);
  for (const std::string which : {"first", "second"}) {
    const pipeline::Run turned =
        run("clean-body", {folder / "back.ply", "-o", folder / "back.obj"});
    ASSERT_EQ(turned.exit_code, 0) << turned.err;
    EXPECT_TRUE(says(turned, "turned to face +z")) << which << " run: " << turned.err;
  }

  // Of the name of earlier versions, other JSON is none of its business; a broken skeleton is an
  // error.
  fs::remove(skeleton_path(folder / "stand.ply"));
  write_text(folder / "stand.json", R"({"bust": 93.6})");
  EXPECT_EQ(run("clean-body", {folder / "stand.ply", "-o", folder / "body.ply"}).exit_code, 0);
  write_text(folder / "stand.json", R"({"format": "toile-body", "units": "ft"})");
  const pipeline::Run broken =
      run("clean-body", {folder / "stand.ply", "-o", folder / "other.ply"});
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_TRUE(says(broken, "stand.json")) << broken.err;
  EXPECT_FALSE(fs::exists(folder / "other.ply"));
}

TEST(MakeMannequinProgram, PosesFromFilesAndWrongOnes) {
  const ScratchFolder folder;
  write_text(folder / "stride.json", R"({"joints": {"left_hip": {"flexion": 30}}})");
  EXPECT_EQ(make(folder / "a.ply", folder / "stride.json", {"-q"}).exit_code, 0);
  const Skeleton posed = read_skeleton(folder / "a.body.json");
  EXPECT_GT(posed.joint("left_knee").z(), posed.joint("right_knee").z() + 0.15);
  for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
           {R"({"joints": {"left_wing": {"flexion": 30}}})", "left_wing"},
           {R"({"joints": {"left_hip": {"flexion": 300}}})", "left_hip"},
           {R"({"joints": {"left_hip": {"flexion": true}}})", "left_hip"},
           {"nothing", "wrong.json"}}) {
    write_text(folder / "wrong.json", text);
    const pipeline::Run refused = make(folder / "b.ply", folder / "wrong.json");
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_TRUE(says(refused, words)) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_FALSE(fs::exists(folder / "b.ply"));
    EXPECT_FALSE(fs::exists(folder / "b.body.json"));
  }
  EXPECT_EQ(make(folder / "b.ply", "dancing").exit_code, 2);
  EXPECT_EQ(make(folder / "b.ply", folder / "missing.json").exit_code, 1);
  EXPECT_FALSE(fs::exists(folder / "b.ply"));
}

TEST(MakeMannequinProgram, MakesABodyToMeasures) {
  const ScratchFolder folder;
  write_text(folder / "me.vit",
             R"xml(<vit><unit>cm</unit><body-measurements><m name="height" value="168"/>
             <m name="bust_circ" value="92"/><m name="hip_circ" value="90"/>
             <m name="leg_knee_circ" value="45"/></body-measurements></vit>)xml");
  // The command line wins over the file, and a side over a whole.
  const pipeline::Run made =
      run("make-mannequin",
          {"--measures", folder / "me.vit", "--measures", "hip=99", "--measures", "left_knee=37",
           "--edge-length", "15mm", "-o", folder / "me.ply", "--report", folder / "me.txt"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Json report = Json::parse(read_text(folder / "me.txt"));
  EXPECT_NEAR(report["body"]["height_m"].get<double>(), 1.68, 0.003);
  EXPECT_EQ(report["measures"]["hip"]["source"], "given");
  EXPECT_NEAR(report["measures"]["hip"]["measured_cm"].get<double>(), 99, 0.2);
  EXPECT_EQ(report["measures"]["waist"]["source"], "filled");
  EXPECT_EQ(report["measures"]["knee"]["wanted_cm"], 37);
  EXPECT_TRUE(says(made, "filled from proportions")) << made.err;
  EXPECT_TRUE(fs::exists(folder / "me.body.json"));
}

TEST(MakeMannequinProgram, NamesMeasuresThatContradict) {
  const ScratchFolder folder;
  const auto refused = [&](const std::vector<std::string>& measures) {
    std::vector<std::string> words = {"-o", folder / "no.ply"};
    for (const std::string& measure : measures) {
      words.insert(words.end(), {"--measures", measure});
    }
    const pipeline::Run ended = run("make-mannequin", words);
    EXPECT_EQ(ended.exit_code, 1) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_FALSE(fs::exists(folder / "no.ply"));
    return ended;
  };
  EXPECT_TRUE(says(refused({"height=170", "bust=20", "hip=98"}), "bust 20 cm"));
  EXPECT_TRUE(
      says(refused({"height=170", "bust=94", "hip=98", "waist=140"}), "waist 140 cm and hip 98"));
  EXPECT_TRUE(says(refused({"height=170", "bust=94"}), "there is no hip"));
  EXPECT_TRUE(says(refused({"height=170", "wings=94"}), "wings"));
  // What is filled from a height in the wrong unit makes no giant.
  EXPECT_TRUE(says(refused({"waist_to_floor=2000", "bust=94", "hip=100"}), "height"));
  EXPECT_TRUE(says(refused({"height=170", "bust=94", "hip=100", "bust_span=500"}), "bust_span"));
}

}  // namespace make_mannequin_test
}  // namespace toile::pipeline
