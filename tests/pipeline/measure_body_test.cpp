// The built measure-body: its files, freehand measures, and what it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "geometry/repair.h"
#include "io/mesh_file.h"
#include "io/skeleton_file.h"
#include "tests/support/run_program.h"
#include "tests/support/shapes.h"

namespace toile::pipeline {
namespace measure_body_test {

using Json = nlohmann::json;

class MeasureBodyProgram : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = new ScratchFolder;
    EXPECT_EQ(run("make-mannequin", {"-o", body(), "--edge-length", "15mm", "-q"}).exit_code, 0);
  }
  static void TearDownTestSuite() {
    delete shared_;
    shared_ = nullptr;
  }
  static fs::path body() { return *shared_ / "body.ply"; }

  ScratchFolder folder_;

 private:
  static ScratchFolder* shared_;
};
ScratchFolder* MeasureBodyProgram::shared_ = nullptr;

TEST_F(MeasureBodyProgram, WritesMeasuresUnderAllNames) {
  const pipeline::Run done =
      run("measure-body",
          {body(), "-o", folder_ / "m.json", "--as", "garmentcode=" + (folder_ / "b.yaml").string(),
           "--as", "vit=" + (folder_ / "b.vit").string(), "--as",
           "freesewing=" + (folder_ / "b.json").string(), "--html", folder_ / "m.html", "--at",
           "girth plane=waist name=mine", "--at", "girth plane=waist tilt=20deg name=sloping"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const Json json = Json::parse(read_text(folder_ / "m.json"));
  EXPECT_EQ(json["unit"], "cm");
  const Json& measures = json["measures"];
  EXPECT_NEAR(measures["hip"]["value"].get<double>(), 98, 0.3);
  EXPECT_EQ(measures["hip"]["iso"], "5.3.13");
  EXPECT_EQ(json["freehand"]["mine"]["value"], measures["waist"]["value"]);
  EXPECT_GT(json["freehand"]["sloping"]["value"].get<double>(),
            measures["waist"]["value"].get<double>());
  const std::string yaml = read_text(folder_ / "b.yaml");
  EXPECT_EQ(yaml.substr(0, 8), "body:\n  ");
  EXPECT_GE(std::count(yaml.begin(), yaml.end(), '\n'), 19);
  const std::string vit = read_text(folder_ / "b.vit");
  const std::string hip = "<m name=\"hip_circ\" value=\"";
  ASSERT_NE(vit.find(hip), std::string::npos);
  EXPECT_NEAR(std::stod(vit.substr(vit.find(hip) + hip.size())), 98, 0.3);
  const Json freesewing = Json::parse(read_text(folder_ / "b.json"));
  EXPECT_NEAR(freesewing["measurements"]["seat"].get<double>(), 980, 3);
  EXPECT_NE(read_text(folder_ / "m.html").find("data-region"), std::string::npos);
}

TEST_F(MeasureBodyProgram, LandmarksStandBesideTheBody) {
  ASSERT_EQ(run("clean-body", {body(), "-o", folder_ / "clean.ply", "-q"}).exit_code, 0);
  ASSERT_EQ(run("measure-body", {folder_ / "clean.ply", "-o", folder_ / "m.json"}).exit_code, 0);
  const Json made = Json::parse(read_text(skeleton_path(body())))["landmarks"];
  const Json cleaned = Json::parse(read_text(folder_ / "clean.body.json"))["landmarks"];
  EXPECT_EQ(cleaned, Json::parse(read_text(folder_ / "m.json"))["landmarks"]);
  ASSERT_EQ(made.size(), cleaned.size());
  for (const auto& [name, landmark] : made.items()) {
    ASSERT_TRUE(landmark["place_m"].is_array()) << name;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(landmark["place_m"][axis].get<double>(),
                  cleaned[name]["place_m"][axis].get<double>(), 0.001)
          << name;
    }
  }
}

TEST_F(MeasureBodyProgram, ComparesWithMeasuresTakenBefore) {
  write_text(folder_ / "before.csv", "name,value,unit\nhip,38,inch\n");
  const pipeline::Run done = run("measure-body", {body(), "-o", folder_ / "m.json", "--unit",
                                                  "inch", "--against", folder_ / "before.csv"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const Json json = Json::parse(read_text(folder_ / "m.json"));
  const Json& hip = json["against"]["hip"];
  EXPECT_EQ(hip["before"], 38);
  EXPECT_EQ(hip["now"], json["measures"]["hip"]["value"]);
  EXPECT_NEAR(hip["difference"].get<double>(), 98 / 2.54 - 38, 0.1);
}

TEST_F(MeasureBodyProgram, WhatIsNotTakenIsNeitherCountedNorPassedOver) {
  const auto counted = [](const std::string& said) {
    const std::size_t end = said.find(" measures taken");
    return said.substr(said.rfind('\n', end) + 1, end - said.rfind('\n', end) - 1);
  };
  const std::vector<std::string> words = {body(), "-o", folder_ / "m.json"};
  const std::string alone = counted(run("measure-body", words).err);
  std::vector<std::string> freehand = words;
  freehand.insert(freehand.end(), {"--at", "girth plane=1m", "--at", "girth plane=9m"});
  const std::string with = counted(run("measure-body", freehand).err);
  const auto number = [](const std::string& text, const char* after) {
    return std::stoi(text.substr(text.find(after) + std::string(after).size()));
  };
  EXPECT_EQ(number(with, ""), number(alone, "") + 1) << alone << with;
  EXPECT_EQ(number(with, " of "), number(alone, " of ") + 2) << alone << with;

  // Of a body with one arm, a measure of both sides is taken on one.
  TriangleMesh cut = fan_triangles(read_mesh(body()));
  std::erase_if(cut.triangles, [&](const Triangle& t) {
    return std::ranges::any_of(
        t, [&](int p) { return cut.points[p].x() < -0.215 && cut.points[p].y() > 0.75; });
  });
  RepairOptions options;
  options.largest_hole = 1;
  write_mesh(folder_ / "cut.ply", repair(test::soup(cut), "cut", options).mesh);
  write_text(folder_ / "before.csv", "name,value,unit\nwrist,16,cm\n");
  const pipeline::Run done = run("measure-body", {folder_ / "cut.ply", "-o", folder_ / "m.json",
                                                  "--against", folder_ / "before.csv"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(done.err.find("left_wrist: 16.00 before"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("right_wrist of " + (folder_ / "before.csv").string() + " is not taken"),
            std::string::npos)
      << done.err;
}

/// What was written for other programs is read back as it was, whatever unit is shown.
TEST_F(MeasureBodyProgram, FilesOfOtherProgramsCompareWithThemselves) {
  for (const std::string unit : {"cm", "inch"}) {
    for (const std::string program : {"vit", "freesewing", "garmentcode"}) {
      const std::string end = program == "freesewing" ? "json" : program == "vit" ? "vit" : "yaml";
      const fs::path file = folder_ / ("o." + end);
      const std::vector<std::string> words = {body(),   "-o", folder_ / "m.json",
                                              "--unit", unit, "-q"};
      std::vector<std::string> write = words;
      write.insert(write.end(), {"--as", program + "=" + file.string()});
      ASSERT_EQ(run("measure-body", write).exit_code, 0);
      std::vector<std::string> compare = words;
      compare.insert(compare.end(), {"--against", file});
      ASSERT_EQ(run("measure-body", compare).exit_code, 0);
      const Json against = Json::parse(read_text(folder_ / "m.json"))["against"];
      ASSERT_GT(against.size(), 5U) << program;
      EXPECT_NEAR(against["waist"]["difference"], 0, 0.021) << program << " " << unit;
      EXPECT_NEAR(against["left_wrist"]["difference"], 0, 0.021) << program << " " << unit;
    }
  }
}

TEST_F(MeasureBodyProgram, RefusesABodyInCentimetres) {
  std::string obj = "v 0 0 0\nv 50 0 0\nv 0 0 50\nv 0 170 0\n";
  obj += "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";
  write_text(folder_ / "large.obj", obj);
  const pipeline::Run ended =
      run("measure-body", {folder_ / "large.obj", "-o", folder_ / "m.json"});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_NE(ended.err.find("large.obj"), std::string::npos) << ended.err;
}

TEST_F(MeasureBodyProgram, TwoMeasuresOfOneNameAreAnError) {
  const pipeline::Run ended =
      run("measure-body", {body(), "-o", folder_ / "m.json", "--at", "girth plane=hip name=waist"});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_NE(ended.err.find("'waist' is there twice"), std::string::npos) << ended.err;
}

TEST_F(MeasureBodyProgram, TheJointsBesideTheBodyStay) {
  // Those that an earlier version wrote, too.
  fs::copy_file(body(), folder_ / "old.ply");
  fs::copy_file(skeleton_path(body()), folder_ / "old.json");
  for (const auto& [file, beside] : std::map<fs::path, fs::path>{
           {body(), skeleton_path(body())}, {folder_ / "old.ply", folder_ / "old.json"}}) {
    const std::string before = read_text(beside);
    EXPECT_EQ(run("measure-body", {file, "-o", beside}).exit_code, 1);
    EXPECT_EQ(read_text(beside), before);
  }
}

TEST_F(MeasureBodyProgram, MeasuresMayBeCalledAfterTheBody) {
  const fs::path measures = body().replace_extension(".json");
  // Twice: what the first wrote are no joints of an earlier version.
  for (int i = 0; i < 2; ++i) {
    const pipeline::Run done = run("measure-body", {body(), "-o", measures, "-q"});
    EXPECT_EQ(done.exit_code, 0) << done.err;
  }
  EXPECT_TRUE(Json::parse(read_text(measures)).contains("measures"));
  EXPECT_TRUE(Json::parse(read_text(skeleton_path(body()))).contains("joints"));
}

TEST_F(MeasureBodyProgram, RefusesWhatItDoesNotUnderstand) {
  for (const std::string wrong :
       {"girth plane=nothing", "hello", "girth plane=hip tilt=100deg", "distance from=crown",
        "height of=crown of=floor", "girth part=left_arm share=2", "distance from=1,2 to=crown"}) {
    const pipeline::Run done =
        run("measure-body", {body(), "-o", folder_ / "m.csv", "--at", wrong, "-q"});
    EXPECT_EQ(done.exit_code, 1) << wrong;
    EXPECT_NE(done.err.find(wrong), std::string::npos) << done.err;
  }
  EXPECT_TRUE(folder_.names().empty());
}

}  // namespace measure_body_test
}  // namespace toile::pipeline
