// The built clean-body, from files to files, messages and exit codes.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/intersections.h"
#include "geometry/surface_distance.h"
#include "io/mesh_file.h"
#include "io/skeleton_file.h"
#include "tests/support/run_program.h"
#include "tests/support/shapes.h"

namespace toile {
namespace clean_body_test {

using pipeline::run;
using pipeline::ScratchFolder;
using Json = nlohmann::json;

TriangleMesh triangles(const std::filesystem::path& path) {
  const PolygonSoup soup = read_mesh(path);
  TriangleMesh mesh;
  mesh.points = soup.points;
  for (const auto& polygon : soup.polygons) {
    EXPECT_EQ(polygon.size(), 3u);
    mesh.triangles.push_back({polygon[0], polygon[1], polygon[2]});
  }
  return mesh;
}

double highest(const TriangleMesh& mesh) {
  double y = 0;
  for (const Vec3& p : mesh.points) y = std::max(y, p.y());
  return y;
}

bool says(const pipeline::Run& ended, const std::string& words) {
  return ended.err.find(words) != std::string::npos;
}

TEST(CleanBodyProgram, MeanAllIsCleanAndHardlyMoved) {
  TOILE_REAL_DATA(data, "bodies/mean_all.obj");
  const ScratchFolder folder;
  const pipeline::Run ended =
      run("clean-body", {data.string(), "-o", (folder / "body.ply").string(), "--report",
                         (folder / "report.json").string()});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(folder.names(),
            (std::vector<std::string>{"body.body.json", "body.ply", "report.json"}));
  const TriangleMesh body = triangles(folder / "body.ply");
  EXPECT_TRUE(test::is_closed(body));
  EXPECT_NEAR(highest(body), 1.7199, 1e-4);
  EXPECT_TRUE(self_intersections(body).empty());

  // Nothing a garment could feel: below 2 mm from either surface to the other.
  const TriangleMesh before = triangles(data);
  double moved = 0;
  const SurfaceDistance to_body(body);
  for (const Vec3& p : before.points)
    moved = std::max(moved, std::abs(to_body.closest_point(p).distance));
  const SurfaceDistance to_before(before);
  for (const Vec3& p : body.points)
    moved = std::max(moved, std::abs(to_before.closest_point(p).distance));
  EXPECT_LT(moved, 0.002);
  EXPECT_NEAR(test::volume(body) / test::volume(before), 1, 1e-4);

  const Json report = Json::parse(pipeline::read_text(folder / "report.json"));
  EXPECT_NEAR(report["body"]["height_m"].get<double>(), 1.7199, 1e-4);
  EXPECT_EQ(report["body"]["points"], body.points.size());
  EXPECT_EQ(report["self_intersections"]["left"], 0);
  EXPECT_GT(report["self_intersections"]["found"], 42);
  EXPECT_TRUE(report["skeleton"].get<bool>());

  const Skeleton skeleton = read_skeleton(folder / "body.body.json");
  for (const std::string joint : {"shoulder", "elbow", "wrist", "hip", "knee", "ankle"}) {
    const Vec3 left = skeleton.joint("left_" + joint);
    const Vec3 right = skeleton.joint("right_" + joint);
    EXPECT_GT(left.x(), 0.05) << joint;
    EXPECT_LT((left - Vec3(-right.x(), right.y(), right.z())).norm(), 0.015) << joint;
    EXPECT_LT(to_body.closest_point(left).distance, -0.015) << joint;
    EXPECT_LT(to_body.closest_point(right).distance, -0.015) << joint;
  }
  // arm_pose_angle of the body's own measures is 45.5 degrees below level.
  const Vec3 arm = skeleton.joint("left_elbow") - skeleton.joint("left_shoulder");
  EXPECT_NEAR(std::atan2(-arm.y(), arm.x()) * 180 / std::numbers::pi, 45.5, 5);
}

TEST(CleanBodyProgram, MakeHumanInDecimetresStands) {
  TOILE_REAL_DATA(data, "bodies/makehuman_base.obj");
  const ScratchFolder folder;
  const pipeline::Run ended =
      run("clean-body", {data.string(), "-o", (folder / "body.ply").string(), "--unit", "dm"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const TriangleMesh body = triangles(folder / "body.ply");
  EXPECT_TRUE(test::is_closed(body));
  EXPECT_GT(test::volume(body), 0.04);
  EXPECT_GT(highest(body), 1.5);
  EXPECT_LT(highest(body), 2.0);
  EXPECT_TRUE(std::filesystem::exists(folder / "body.body.json"));
  EXPECT_TRUE(says(ended, "lifted by 81.68 cm"));

  const pipeline::Run inferred =
      run("clean-body", {data.string(), "-o", (folder / "again.ply").string()});
  EXPECT_EQ(inferred.exit_code, 0);
  EXPECT_TRUE(says(inferred, "unit taken to be dm")) << inferred.err;
  EXPECT_EQ(pipeline::read_text(folder / "again.ply"), pipeline::read_text(folder / "body.ply"));
}

TEST(CleanBodyProgram, SameBitsForAnyThreads) {
  TOILE_REAL_DATA(data, "bodies/mean_all.obj");
  const ScratchFolder folder;
  for (const std::string threads : {"1", "2"}) {
    ASSERT_EQ(run("clean-body", {data.string(), "-q", "-o", (folder / (threads + ".ply")).string(),
                                 "--threads", threads})
                  .exit_code,
              0);
  }
  EXPECT_EQ(pipeline::read_text(folder / "1.ply"), pipeline::read_text(folder / "2.ply"));
  EXPECT_EQ(pipeline::read_text(folder / "1.json"), pipeline::read_text(folder / "2.json"));
}

/// Runs on a file of that content and expects exit code 1, a message with `words`, no output.
void expect_refused(const std::string& name, const std::string& content, const std::string& words) {
  SCOPED_TRACE(name + ": " + words);
  const ScratchFolder folder;
  pipeline::write_text(folder / name, content);
  const pipeline::Run ended =
      run("clean-body", {(folder / name).string(), "-o", (folder / "body.ply").string(), "--report",
                         (folder / "report.json").string()});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_TRUE(says(ended, words)) << ended.err;
  EXPECT_TRUE(says(ended, name)) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_EQ(folder.names(), std::vector<std::string>{name});
}

const std::string cube_points =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
const std::string five_faces = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n";

TEST(CleanBodyProgram, ANameThatNoFolderTakesIsOneMessage) {
  const ScratchFolder folder;
  const std::string name = std::string(300, 'x') + ".obj";
  const pipeline::Run ended =
      run("clean-body", {(folder / name).string(), "-o", (folder / "body.ply").string()});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_TRUE(says(ended, name + ": can't be reached (")) << ended.err;
  EXPECT_FALSE(says(ended, "filesystem error")) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
}

TEST(CleanBodyProgram, BadInputIsOneMessageAndNoFile) {
  expect_refused("cube.obj", cube_points + five_faces, "1 hole is too large");
  expect_refused("empty.obj", "", "no OBJ statement");
  expect_refused("empty.ply", "", "empty");
  expect_refused("letter.obj", "Dear reader,\nthis is a letter.\n", "no OBJ statement");
  expect_refused("nan.obj", "v 0 0 0\nv 0 nan 1\nv 1 0 0\nf 1 2 3\n", "nan.obj:2");
  expect_refused("points.obj", cube_points, "8 can be a body");
  expect_refused("range.obj", cube_points + "f 1 2 9\n", "range.obj:9");
  expect_refused("body.xyz", "0 0 0\n", "1 can be a body");
  std::string strip;
  const int around = 30;
  for (int i = 0; i < around; ++i) {
    const double turn = 2 * std::numbers::pi * i / around;
    for (const double side : {-0.3, 0.3}) {
      const double radius = 1 + side * std::cos(turn / 2);
      strip += "v " + std::to_string(radius * std::cos(turn)) + " " +
               std::to_string(side * std::sin(turn / 2)) + " " +
               std::to_string(radius * std::sin(turn)) + "\n";
    }
  }
  for (int i = 1; i < around; ++i) {
    strip += "f " + std::to_string(2 * i - 1) + " " + std::to_string(2 * i) + " " +
             std::to_string(2 * i + 2) + " " + std::to_string(2 * i + 1) + "\n";
  }
  strip += "f " + std::to_string(2 * around - 1) + " " + std::to_string(2 * around) + " 1 2\n";
  expect_refused("moebius.obj", strip, "one-sided");
}

TEST(CleanBodyProgram, AClosedCubeIsABodyWithoutSkeleton) {
  const ScratchFolder folder;
  pipeline::write_text(folder / "cube.obj", cube_points + five_faces + "f 1 5 8 4\n");
  // A skeleton of an earlier run would be taken for this body's, by whichever name it has.
  write_skeleton(folder / "body.body.json", Skeleton{});
  write_skeleton(folder / "body.json", Skeleton{});
  const pipeline::Run ended =
      run("clean-body", {(folder / "cube.obj").string(), "-o", (folder / "body.ply").string()});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(says(ended, "warning: ")) << ended.err;
  EXPECT_TRUE(says(ended, "no skeleton is found")) << ended.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"body.ply", "cube.obj"}));
  EXPECT_NEAR(test::volume(triangles(folder / "body.ply")), 1, 1e-12);
}

/// Runs on `mesh` and expects a warning with `words`, on the screen and in the report, which it
/// returns.
Json expect_warned(const TriangleMesh& mesh, const std::string& words, int exit_code = 0) {
  SCOPED_TRACE(words);
  const ScratchFolder folder;
  write_mesh(folder / "ball.ply", mesh);
  const pipeline::Run ended =
      run("clean-body", {"-q", (folder / "ball.ply").string(), "-o", (folder / "body.ply").string(),
                         "--report", (folder / "report.json").string()});
  EXPECT_EQ(ended.exit_code, exit_code) << ended.err;
  EXPECT_TRUE(says(ended, words)) << ended.err;
  Json report = Json::parse(pipeline::read_text(folder / "report.json"));
  bool kept = false;
  for (const Json& said : report["warnings"]) {
    const std::string warning = said["text"];
    EXPECT_TRUE(says(ended, "warning: " + warning + "\n"));
    kept = kept || warning.find(words) != std::string::npos;
  }
  EXPECT_TRUE(kept);
  return report;
}

TEST(CleanBodyProgram, AGuessedUnitIsSaidAndAHeightIsTaken) {
  const ScratchFolder folder;
  TriangleMesh body = make_mannequin({.edge_length = 0.015}).surface;
  double tall = 0;
  for (const Vec3& p : body.points) tall = std::max(tall, p.y());
  const auto scaled = [&](double height) {
    TriangleMesh other = body;
    for (Vec3& p : other.points) p *= height / tall;
    write_mesh(folder / "in.ply", other);
    return (folder / "in.ply").string();
  };
  const std::string out = (folder / "body.ply").string();
  pipeline::Run ended = run("clean-body", {scaled(1.7), "-o", out});
  EXPECT_TRUE(says(ended, "unit taken to be m, since the body is then 1.70 m tall")) << ended.err;
  EXPECT_FALSE(says(ended, "are a guess")) << ended.err;
  ended = run("clean-body", {scaled(1.7), "-o", out, "--unit", "m"});
  EXPECT_FALSE(says(ended, "unit taken to be")) << ended.err;
  // Models that were scaled to one size.
  ended = run("clean-body", {scaled(2), "-o", out});
  EXPECT_TRUE(says(ended, "warning: the body is exactly 2 units tall")) << ended.err;
  ended = run("clean-body", {scaled(3.1), "-o", out});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_TRUE(says(ended, "--height 168cm")) << ended.err;
  ended = run("clean-body", {scaled(3.1), "-o", out, "--height", "168cm"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(says(ended, "168.00 cm tall")) << ended.err;
  EXPECT_FALSE(says(ended, "warning")) << ended.err;
  EXPECT_EQ(run("clean-body", {scaled(3.1), "-o", out, "--height", "168"}).exit_code, 2);
  EXPECT_EQ(run("clean-body", {scaled(3.1), "-o", out, "--height", "5m"}).exit_code, 2);
  EXPECT_EQ(
      run("clean-body", {scaled(3.1), "-o", out, "--height", "168cm", "--unit", "m"}).exit_code, 2);
}

TEST(CleanBodyProgram, ALeaningBodyIsTurnedUprightAndTheReportSaysByHowMuch) {
  const ScratchFolder folder;
  TriangleMesh body = make_mannequin({.edge_length = 0.014}).surface;
  const Eigen::AngleAxisd lean(8 * std::numbers::pi / 180, Vec3::UnitX());
  for (Vec3& p : body.points) p = lean * p;
  write_mesh(folder / "leaning.ply", body);
  for (const bool keeps : {false, true}) {
    std::vector<std::string> arguments = {(folder / "leaning.ply").string(), "-o",
                                          (folder / "body.ply").string(), "--report",
                                          (folder / "report.json").string()};
    if (keeps) arguments.insert(arguments.end(), {"--up", "y"});
    const pipeline::Run ended = run("clean-body", arguments);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const Json report = Json::parse(pipeline::read_text(folder / "report.json"));
    EXPECT_NEAR(report["changed"]["levelled_degrees"].get<double>(), keeps ? 0 : 8, 2);
    EXPECT_EQ(says(ended, "degrees to stand upright"), !keeps) << ended.err;
  }
}

TEST(CleanBodyProgram, AFilledHoleIsWarnedOfWithSizeAndPlace) {
  TriangleMesh ball = test::sphere(0.75, 5);
  std::erase_if(ball.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](int p) { return ball.points[p].x() > 0.744; });
  });
  const Json report = expect_warned(ball, " cm across was filled, 75 cm above the floor, at x 0.7");
  EXPECT_TRUE(report["body"]["usable"].get<bool>());
}

TEST(CleanBodyProgram, ASurfaceOfCrossingsIsNoBodyToDress) {
  TriangleMesh ball = test::sphere(0.75, 3);
  for (std::size_t i = 0; i < ball.points.size(); i += 2) ball.points[i] *= 0.6;
  for (std::size_t i = 0; i < ball.points.size(); i += 3) ball.points[i].x() += 0.3;
  const Json report = expect_warned(ball, "this body can't be relied on", 3);
  EXPECT_FALSE(report["body"]["usable"].get<bool>());
  EXPECT_GT(report["self_intersections"]["left"], 100);
  EXPECT_GT(report["self_intersections"]["area_percent"], 2);
}

TEST(CleanBodyProgram, OutputThatCannotBeWrittenIsAnError) {
  const ScratchFolder folder;
  pipeline::write_text(folder / "cube.obj", cube_points + five_faces + "f 1 5 8 4\n");
  const std::string cube = (folder / "cube.obj").string();
  EXPECT_EQ(run("clean-body", {cube, "-o", (folder / "none" / "body.ply").string()}).exit_code, 1);
  EXPECT_EQ(run("clean-body", {cube, "-o", (folder / "body.txt").string()}).exit_code, 1);
  EXPECT_EQ(
      run("clean-body", {(folder / "missing.obj").string(), "-o", (folder / "body.ply").string()})
          .exit_code,
      1);
  std::filesystem::create_directory(folder / "folder.ply");
  EXPECT_EQ(run("clean-body", {cube, "-o", (folder / "folder.ply").string()}).exit_code, 1);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"cube.obj", "folder.ply"}));
}

TEST(CleanBodyProgram, UsageErrorsEndWithTwo) {
  EXPECT_EQ(run("clean-body", {}).exit_code, 2);
  EXPECT_EQ(run("clean-body", {"body.obj"}).exit_code, 2);
  EXPECT_EQ(run("clean-body", {"-o", "body.ply"}).exit_code, 2);
  EXPECT_EQ(run("clean-body", {"body.obj", "-o", "b.ply", "--unit", "furlong"}).exit_code, 2);
  EXPECT_EQ(run("clean-body", {"body.obj", "-o", "b.ply", "--nonsense"}).exit_code, 2);
  const pipeline::Run help = run("clean-body", {"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.out.find("--unit"), std::string::npos);
}

}  // namespace clean_body_test
}  // namespace toile
