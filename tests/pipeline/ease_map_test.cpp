#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "io/checksum.h"
#include "io/mesh_file.h"
#include "io/skeleton_file.h"
#include "pattern/file/garment_file.h"
#include "tests/support/run_program.h"
#include "tests/support/tubes.h"

namespace toile::pipeline {
namespace ease_map_test {

/// A cylinder with a skeleton beside it, and cloth around it that stands off by 10 mm.
class EaseMap : public testing::Test {
 protected:
  EaseMap() {
    write_mesh(body, test::closed_tube(0.15, 0.15, 1.6, 300));
    DressedGarment garment = test::cloth_tube(0.16, 0.16, 0.8, 1.3, 60, 10);
    garment.panels[0] = "front, \"left\" & right";
    write_dressed(dressed, garment);
  }

  pipeline::Run ease_map(std::vector<std::string> more) const {
    std::vector<std::string> words = {"--body", body.string(), dressed.string(), "-o",
                                      html.string()};
    words.insert(words.end(), more.begin(), more.end());
    return run("ease-map", words);
  }

  ScratchFolder scratch;
  fs::path body = scratch / "body.ply";
  fs::path dressed = scratch / "dressed.obj";
  fs::path html = scratch / "ease.html";
};

TEST_F(EaseMap, WritesAllItsFiles) {
  const fs::path csv = scratch / "e.csv", json = scratch / "e.json", ply = scratch / "e.ply",
                 png = scratch / "e.png";
  const auto done = ease_map({"--csv", csv, "--report", json, "--ply", ply, "--png", png});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.out, "");

  const nlohmann::json statistics = nlohmann::json::parse(read_text(json));
  EXPECT_NEAR(statistics["total"]["mean_mm"].get<double>(), 10, 0.02);
  EXPECT_NEAR(statistics["total"]["std_mm"].get<double>(), 0, 0.01);
  EXPECT_EQ(statistics["total"]["contact_percent"], 0);
  EXPECT_NEAR(statistics["total"]["area_cm2"].get<double>(),
              1e4 * 2 * std::numbers::pi * 0.16 * 0.5, 20);
  ASSERT_EQ(statistics["panels"].size(), 2U);
  EXPECT_EQ(statistics["panels"][0]["name"], "front, \"left\" & right");
  EXPECT_EQ(statistics["panels"][1]["points"], 31 * 11);

  std::istringstream rows(read_text(csv));
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "panel,u_m,v_m,x_m,y_m,z_m,gap_mm");
  std::getline(rows, row);
  EXPECT_TRUE(row.starts_with("\"front, \"\"left\"\" & right\",")) << row;
  int count = 1;
  while (std::getline(rows, row)) ++count;
  EXPECT_EQ(count, 2 * 31 * 11);

  EXPECT_EQ(read_mesh(ply).points.size(), 60U * 11U);
  EXPECT_NE(read_text(ply).find("property uchar red"), std::string::npos);
  EXPECT_EQ(read_text(png).substr(1, 3), "PNG");
  const std::string page = read_text(html);
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  EXPECT_NE(page.find("front, &quot;left&quot; &amp; right"), std::string::npos);
  EXPECT_EQ(scratch.names(), (std::vector<std::string>{"body.ply", "dressed.obj", "e.csv", "e.json",
                                                       "e.ply", "e.png", "ease.html"}));
}

TEST_F(EaseMap, FiguresAloneNeedNoPage) {
  const fs::path with_page = scratch / "with.json", alone = scratch / "alone.json";
  ASSERT_EQ(ease_map({"--report", with_page}).exit_code, 0);
  fs::remove(html);
  const auto done = run("ease-map", {"--body", body, dressed, "--report", alone});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(done.err.find("wrote " + alone.string()), std::string::npos) << done.err;
  EXPECT_EQ(scratch.names(),
            (std::vector<std::string>{"alone.json", "body.ply", "dressed.obj", "with.json"}));
  const auto figures = [](const fs::path& file) {
    nlohmann::json report = nlohmann::json::parse(read_text(file));
    report.erase("seconds");
    return report;
  };
  EXPECT_EQ(figures(alone), figures(with_page));
}

TEST_F(EaseMap, MeasuresGirthsWhereThereAreJoints) {
  Skeleton skeleton;
  skeleton.joints = {{"pelvis", {0, 0.85, 0}}, {"waist", {0, 1.05, 0}}, {"chest", {0, 1.25, 0}}};
  skeleton.segments = {{"torso", "pelvis", "waist"}, {"torso", "waist", "chest"}};
  write_skeleton(scratch / "body.body.json", skeleton);
  const auto done = ease_map({"--report", scratch / "e.json"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const nlohmann::json statistics = nlohmann::json::parse(read_text(scratch / "e.json"));
  ASSERT_GT(statistics["girths"].size(), 5U);
  for (const auto& girth : statistics["girths"]) {
    EXPECT_NEAR(girth["ease_cm"].get<double>(), 2 * std::numbers::pi, 0.2);
  }
}

TEST_F(EaseMap, WhatIsCutTooSmallIsWarnedOf) {
  Skeleton skeleton;
  skeleton.joints = {{"pelvis", {0, 0.85, 0}}, {"waist", {0, 1.05, 0}}, {"chest", {0, 1.25, 0}}};
  skeleton.segments = {{"torso", "pelvis", "waist"}, {"torso", "waist", "chest"}};
  write_skeleton(scratch / "body.body.json", skeleton);
  // Around the body's 94.2 cm the cloth was cut to 90.
  DressedGarment tight = test::cloth_tube(0.16, 0.16, 0.8, 1.3, 90, 10);
  write_dressed(dressed, tight);
  const auto done = ease_map({"-q", "--report", scratch / "e.json"});
  EXPECT_EQ(done.exit_code, 0);
  const nlohmann::json girths = nlohmann::json::parse(read_text(scratch / "e.json"))["girths"];
  bool named = false;
  for (const auto& girth : girths) {
    EXPECT_NEAR(girth["as_cut_cm"].get<double>(), 90, 0.01);
    EXPECT_NEAR(girth["as_cut_ease_cm"].get<double>(), -4.2, 0.15);
    EXPECT_GT(girth["ease_cm"].get<double>(), 5);
    named = named || girth.contains("level");
  }
  ASSERT_TRUE(named);
  EXPECT_NE(done.err.find(" cm smaller than the body, and stretched by that"), std::string::npos)
      << done.err;
}

/// A drape that was written anew is not judged by the report of the one before.
TEST_F(EaseMap, TheReportOfAnotherDrapeIsNotTaken) {
  const fs::path report = scratch / "dressed.json";
  const auto verdict_with = [&](const std::string& sha256) {
    write_text(report,
               R"({"verdict": "sewn", "fit": {"verdict": "ok", "levels": []}, "warnings": [],
                           "panels": [], "scene": {"body_offset_mm": 2}, "dressed_sha256": ")" +
                   sha256 + "\"}");
    EXPECT_EQ(ease_map({"--report", scratch / "e.json"}).exit_code, 0);
    return nlohmann::json::parse(read_text(scratch / "e.json"));
  };
  EXPECT_EQ(verdict_with(sha256_of_file(dressed))["verdict"], "sewn");
  const nlohmann::json other = verdict_with(std::string(64, '0'));
  EXPECT_FALSE(other.contains("verdict"));
  EXPECT_NE(other["notes"].dump().find("is not the report of this drape"), std::string::npos);
  EXPECT_NE(read_text(html).find("is not the report of this drape"), std::string::npos);
}

/// Names of files need not be UTF-8; reports are.
TEST_F(EaseMap, NamesThatAreNoUtf8DoNoHarm) {
  const fs::path strange = scratch / "dre\xffssed.obj";
  fs::copy_file(dressed, strange);
  const auto done =
      run("ease-map", {"--body", body, strange, "-o", html, "--report", scratch / "e.json"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_TRUE(nlohmann::json::accept(read_text(scratch / "e.json")));
}

TEST_F(EaseMap, AnotherBodysJointsAreRefused) {
  Skeleton skeleton;
  skeleton.joints = {{"pelvis", {0, 0.85, 0}}, {"waist", {0, 1.05, 0}}, {"chest", {0.2, 1.25, 0}}};
  skeleton.segments = {{"torso", "pelvis", "waist"}, {"torso", "waist", "chest"}};
  write_skeleton(scratch / "body.body.json", skeleton);
  const auto done = ease_map({});
  EXPECT_EQ(done.exit_code, 1);
  // The body is a tube of 15 cm radius.
  EXPECT_NE(done.err.find("joint 'chest' lies 5.0 cm outside of the body"), std::string::npos)
      << done.err;
  EXPECT_FALSE(fs::exists(html));
}

TEST_F(EaseMap, SameBytesForAnyNumberOfThreads) {
  ASSERT_EQ(ease_map({"--threads", "1"}).exit_code, 0);
  const std::string one = read_text(html);
  ASSERT_EQ(ease_map({"--threads", "2"}).exit_code, 0);
  EXPECT_EQ(read_text(html), one);
}

TEST_F(EaseMap, OpenBodyIsRefused) {
  TriangleMesh open = test::closed_tube(0.15, 0.15, 1.6, 30);
  open.triangles.pop_back();
  write_mesh(body, open);
  const auto done = ease_map({});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("3 border edges"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("clean-body"), std::string::npos);
  EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1);
  EXPECT_FALSE(fs::exists(html));
}

TEST_F(EaseMap, BadInputIsOneMessage) {
  const fs::path text = scratch / "text.obj";
  write_text(text, "this is no mesh\n");
  const fs::path missing = scratch / "missing.obj";
  const fs::path plain = scratch / "plain.obj";  // no vt, no group
  write_text(plain, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const fs::path& bad : {text, missing, plain}) {
    const auto done = run("ease-map", {"--body", body, bad, "-o", html});
    EXPECT_EQ(done.exit_code, 1) << bad;
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    EXPECT_NE(done.err.find(bad.filename()), std::string::npos) << done.err;
    EXPECT_FALSE(fs::exists(html));
  }
}

TEST_F(EaseMap, BadOptions) {
  EXPECT_EQ(ease_map({"--top", "-5mm"}).exit_code, 2);
  EXPECT_EQ(ease_map({"--contact", "thin"}).exit_code, 2);
  EXPECT_EQ(ease_map({"--contact", "3"}).exit_code, 2);
  EXPECT_EQ(ease_map({"--png", scratch / "e.jpg"}).exit_code, 1);
  EXPECT_EQ(run("ease-map", {"--body", body, dressed, "-o", scratch / "e.csv"}).exit_code, 1);
  EXPECT_EQ(ease_map({"--ply", scratch / "e.obj"}).exit_code, 1);
  EXPECT_EQ(ease_map({"--skeleton", scratch / "missing.json"}).exit_code, 1);
  EXPECT_EQ(run("ease-map", {dressed, "-o", html}).exit_code, 2);
  EXPECT_EQ(run("ease-map", {"--body", body, dressed}).exit_code, 2);
  EXPECT_FALSE(fs::exists(html));
}

TEST_F(EaseMap, FarAwayGarmentIsWarnedOf) {
  DressedGarment far = test::cloth_tube(0.16, 0.16, 0.8, 1.3, 20, 2);
  for (Vec3& point : far.points) point *= 100;  // in centimetres
  write_dressed(dressed, far);
  const auto done = ease_map({"-q"});
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_NE(done.err.find("metres"), std::string::npos) << done.err;
}

TEST_F(EaseMap, RenderDrawsTheSameFiles) {
  const fs::path png = scratch / "p.png";
  const auto done = run("render", {"--body", body, dressed, "-o", png, "--views", "front,top",
                                   "--width", "100", "--whole"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(read_text(png).substr(1, 3), "PNG");
  EXPECT_EQ(run("render", {dressed, "-o", png, "--views", "below"}).exit_code, 2);
  EXPECT_EQ(run("render", {"-o", png}).exit_code, 1);
  const auto jpeg = run("render", {dressed, "-o", scratch / "p.jpg"});
  EXPECT_EQ(jpeg.exit_code, 1);
  EXPECT_NE(jpeg.err.find("p.jpg: is not named .png"), std::string::npos) << jpeg.err;
  EXPECT_FALSE(fs::exists(scratch / "p.jpg"));
}

}  // namespace ease_map_test
}  // namespace toile::pipeline
