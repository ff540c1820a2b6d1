// The built clean-body on simulated scans.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "geometry/body/find_skeleton.h"
#include "geometry/body/mannequin/mannequin.h"
#include "geometry/body/measures.h"
#include "io/mesh_file.h"
#include "io/skeleton_file.h"
#include "tests/support/run_program.h"
#include "tests/support/scanner.h"
#include "tests/support/shapes.h"

namespace toile {
namespace clean_scan_test {

using pipeline::run;
using pipeline::ScratchFolder;
using pipeline::write_text;
using Json = nlohmann::json;

std::string table_of(const std::vector<Vec3>& points) {
  std::string text;
  char line[100];
  for (const Vec3& p : points) {
    std::snprintf(line, sizeof line, "%.2f %.2f %.2f\n", p.x(), p.y(), p.z());
    text += line;
  }
  return text;
}

bool says(const pipeline::Run& ended, const std::string& words) {
  return ended.err.find(words) != std::string::npos;
}

/// Of tests that a fine surface tells no more: half of the time of 7 mm.
constexpr const char* coarse = "12mm";

/// The mannequin, made once.
class CleanScan : public testing::Test {
 protected:
  static void SetUpTestSuite() { body = new Mannequin(make_mannequin({.edge_length = 0.012})); }
  static void TearDownTestSuite() { delete body; }

  TriangleMesh written() const { return fan_triangles(read_mesh(folder / "body.ply")); }
  std::vector<Vec3> scanned(unsigned seed, double unit = 1000) const {
    std::vector<Vec3> points =
        test::scan_body(body->surface, {.points = 50000, .seed = seed}).cloud.points;
    for (Vec3& p : points) p *= unit;
    return points;
  }

  ScratchFolder folder;
  static Mannequin* body;
};

Mannequin* CleanScan::body = nullptr;

// Suites of their own run beside the others.
using CleanScanAgain = CleanScan;
using CleanScanFloor = CleanScan;

TEST_F(CleanScan, TwoFilesWithPosesBecomeABodyWithJoints) {
  // The scanner counts in millimetres, z up. Its second file is in a frame of its own.
  std::vector<Vec3> first, second;
  for (const Vec3& p : scanned(1)) {
    (first.size() <= second.size() ? first : second).push_back(Vec3(p.x(), -p.z(), p.y()));
  }
  for (Vec3& p : second) p = Vec3(-p.y(), p.x(), p.z() - 100);
  write_text(folder / "a.xyz", table_of(first));
  write_text(folder / "b.pts", std::to_string(second.size()) + "\n" + table_of(second));
  write_text(folder / "a.txt", "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  write_text(folder / "b.txt", "0 1 0 0\n-1 0 0 0\n0 0 1 100\n0 0 0 1\n");
  const pipeline::Run ended =
      run("clean-body",
          {folder / "a.xyz", folder / "b.pts", "--pose", folder / "a.txt", "--pose",
           folder / "b.txt", "-o", folder / "body.ply", "--report", folder / "report.json"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(says(ended, "read 50000 points of 2 files")) << ended.err;
  EXPECT_TRUE(says(ended, "unit taken to be mm")) << ended.err;

  const TriangleMesh surface = written();
  EXPECT_TRUE(test::is_closed(surface));
  const SurfaceDistance to_truth(body->surface);
  std::vector<double> off;
  for (const Vec3& p : surface.points) off.push_back(std::abs(to_truth.closest_point(p).distance));
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() * 9 / 10], 0.003);
  const Skeleton joints = read_skeleton(skeleton_path(folder / "body.ply"));
  const Skeleton truth = find_skeleton(body->surface, "body");
  for (const char* name : {"chest", "neck", "left_shoulder", "left_elbow", "right_ankle"}) {
    EXPECT_LT((joints.joint(name) - truth.joint(name)).norm(), 0.03) << name;
  }
  // The pelvis is at the height of the crotch, which no camera saw.
  EXPECT_LT((joints.joint("pelvis") - truth.joint("pelvis")).norm(), 0.03);

  const Json report = Json::parse(pipeline::read_text(folder / "report.json"));
  EXPECT_EQ(report["read"]["points"], 50000);
  EXPECT_EQ(report["scan"]["files"], 2);
  EXPECT_EQ(report["scan"]["up"], "z");
  EXPECT_EQ(report["unit"]["metres"], 0.001);
  EXPECT_LT(report["scan"]["error_mm"]["rms"], 1.5);
  std::vector<std::string> places;
  for (const Json& hole : report["scan"]["holes"]) places.push_back(hole["place"]);
  for (const char* place :
       {"crotch", "crown", "left armpit", "right armpit", "left sole", "right sole"}) {
    EXPECT_GE(std::count(places.begin(), places.end(), place), 1) << place;
  }
}

TEST_F(CleanScanAgain, GirthsRepeat) {
  const std::vector<std::string> names = {"bust", "underbust", "waist", "abdomen", "hip", "neck"};
  std::map<std::string, std::vector<double>> girths;
  for (const unsigned seed : {1u, 2u, 3u}) {
    write_text(folder / "scan.asc", table_of(scanned(seed)));
    ASSERT_EQ(run("clean-body",
                  {folder / "scan.asc", "-q", "-o", folder / "body.ply", "--edge-length", coarse})
                  .exit_code,
              0);
    for (const Measure& m : measure_body(find_landmarks(written(), "body"))) {
      const bool is_girth = std::count(names.begin(), names.end(), m.name) > 0;
      if (is_girth && m.value) girths[m.name].push_back(*m.value);
    }
  }
  EXPECT_EQ(girths.size(), names.size());
  for (const auto& [name, values] : girths) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    EXPECT_LT(*high - *low, 0.006) << name;
  }
}

double bust_of(const TriangleMesh& mesh) {
  const std::vector<Measure> measures = measure_body(find_landmarks(mesh, "body"));
  const Measure* bust = find_measure(measures, "bust");
  return bust != nullptr && bust->value ? *bust->value : 0;
}

TEST_F(CleanScanFloor, ASlopingFloorIsLevelled) {
  const double truth = bust_of(body->surface);
  for (const double degrees : {5.0, 15.0}) {
    const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, Vec3(1, 0, 0.7).normalized());
    std::vector<Vec3> points = scanned(1);
    for (Vec3& p : points) p = turn * p;
    write_text(folder / "scan.xyz", table_of(points));
    const pipeline::Run ended =
        run("clean-body", {folder / "scan.xyz", "-o", folder / "body.ply", "--report",
                           folder / "report.json", "--edge-length", coarse});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_TRUE(says(ended, "the floor sloped by as much")) << ended.err;
    EXPECT_EQ(says(ended, "is the scan turned right?"), degrees > 8) << ended.err;
    const Json report = Json::parse(pipeline::read_text(folder / "report.json"));
    EXPECT_NEAR(report["scan"]["floor_slope_degrees"], degrees, 0.3);
    EXPECT_NEAR(bust_of(written()), truth, 0.005);
    // The joints tell how the points came to the body.
    const BodyMove move = *read_skeleton(skeleton_path(folder / "body.ply")).cleaned;
    const SurfaceDistance surface(written());
    std::vector<double> off;
    for (const Vec3& p : points) {
      const Vec3 at = move.rotation * (p * move.metres_per_unit) + move.translation;
      off.push_back(std::abs(surface.closest_point(at).distance));
    }
    std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2),
                     off.end());
    EXPECT_LT(off[off.size() / 2], 0.002);
  }
}

TEST_F(CleanScanFloor, ABodyThatLiesOnAFloorIsWarnedOf) {
  // On its back, on a floor of 1.4 m by 2.3 m, seen from above.
  TriangleMesh lying = body->surface;
  double low = 1;
  for (Vec3& p : lying.points) {
    p = Vec3(p.x(), p.z(), 0.85 - p.y());
    low = std::min(low, p.y());
  }
  for (Vec3& p : lying.points) p.y() -= low;
  const test::Rays rays(lying);
  std::vector<Vec3> points;
  std::mt19937_64 bits(1);
  const auto share = [&bits] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  while (points.size() < 60000) {
    const Vec3 to(1.8 * share() - 0.9, 0, 2.3 * share() - 1.15);
    const Vec3 from(points.size() % 2 == 0 ? -1.5 : 1.5, 2, 3 * share() - 1.5);
    const Vec3 direction = (to - from).normalized();
    const double distance = std::min(rays.meet(from, direction).distance, (to - from).norm());
    points.push_back(1000 * (from + distance * direction));
  }
  write_text(folder / "scan.xyz", table_of(points));
  const pipeline::Run ended =
      run("clean-body", {folder / "scan.xyz", "-o", folder / "body.ply", "--edge-length", coarse});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(says(ended, "warning: the body lies on a floor")) << ended.err;
}

TEST_F(CleanScanAgain, TheSameBitsForAnyNumberOfThreads) {
  write_text(folder / "scan.xyz", table_of(scanned(1)));
  for (const char* threads : {"1", "2"}) {
    ASSERT_EQ(run("clean-body", {folder / "scan.xyz", "-q", "--threads", threads, "--edge-length",
                                 coarse, "-o", folder / (std::string(threads) + ".ply")})
                  .exit_code,
              0);
  }
  EXPECT_EQ(pipeline::read_text(folder / "1.ply"), pipeline::read_text(folder / "2.ply"));
}

TEST_F(CleanScan, TheFacesOfAMeshCanBeIgnored) {
  // Half of the faces: as a mesh it has holes without end.
  TriangleMesh broken = make_mannequin().surface;
  for (std::size_t i = 0; i < broken.triangles.size(); i += 2) {
    std::swap(broken.triangles[i][0], broken.triangles[i][1]);
  }
  write_mesh(folder / "scan.ply", broken);
  const pipeline::Run ended =
      run("clean-body", {folder / "scan.ply", "--points", "--edge-length", coarse, "-o",
                         folder / "body.ply", "--up", "y", "--front", "z"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(test::is_closed(written()));
  EXPECT_NEAR(test::volume(written()), test::volume(body->surface),
              0.01 * test::volume(body->surface));
}

TEST_F(CleanScan, WhatIsNoScanEndsWithAMessage) {
  write_text(folder / "few.xyz", "1 2 3\n4 5 6\n");
  write_text(folder / "bad.xyz", "1 2 3\n4 five 6\n");
  pipeline::Run ended = run("clean-body", {folder / "few.xyz", "-o", folder / "body.ply"});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_TRUE(says(ended, "holds 2 points")) << ended.err;
  ended = run("clean-body", {folder / "bad.xyz", "-o", folder / "body.ply"});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_TRUE(says(ended, "bad.xyz:2: 'five' is not a number")) << ended.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"bad.xyz", "few.xyz"}));
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--up", "w"},
                                                {"--up", "y", "--front=-y"},
                                                {"--pose", "a.txt", "--pose", "b.txt"}}) {
    std::vector<std::string> words = {folder / "few.xyz", "-o", folder / "body.ply"};
    words.insert(words.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(run("clean-body", words).exit_code, 2) << wrong[0];
  }
}

}  // namespace clean_scan_test
}  // namespace toile
