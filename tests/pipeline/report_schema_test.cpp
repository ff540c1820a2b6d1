// Real reports of all programs against docs/report.schema.json.
#include <gtest/gtest.h>

#include <iostream>
#include <set>

#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace report_schema_test {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

/// The reports in the files, by the schema's definition of that name.
pipeline::Run validate(const std::string& definition, const std::vector<fs::path>& reports) {
  const fs::path source = TOILE_SOURCE_DIR;
  std::vector<std::string> words = {source / "docs" / "report.schema.json", definition};
  words.insert(words.end(), reports.begin(), reports.end());
  return run(source / "tests" / "support" / "validate_report", words);
}

/// The objects of a report, and its values that are none. Of an array it takes the first item.
void collect(const Json& value, const Pointer& at, std::vector<Pointer>& objects,
             std::vector<Pointer>& values) {
  (value.is_object() ? objects : values).push_back(at);
  if (value.is_array() && !value.empty()) collect(value[0], at / 0, objects, values);
  if (!value.is_object()) return;
  for (const auto& [key, part] : value.items()) collect(part, at / key, objects, values);
}

/// Its tests share a mannequin.
class ReportSchema : public WornSample {
 protected:
  static void SetUpTestSuite() {
    shared = new ScratchFolder;
    succeed("make-mannequin", {"-o", *shared / "body.ply", "-q"});
  }
  static void TearDownTestSuite() {
    delete shared;
    shared = nullptr;
  }

  ReportSchema() { body = *shared / "body.ply"; }

  Json read(const std::string& file) const { return Json::parse(read_text(folder / file)); }

  void expect_valid(const std::string& definition, const std::string& file,
                    const std::vector<std::string>& keys = {}) const {
    const pipeline::Run done = validate(definition, {folder / file});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    const Json report = read(file);
    for (const std::string& key : keys) EXPECT_TRUE(report.contains(Pointer(key))) << key;
  }

  /// That each of these is found: a key more in any object, another type of any value. What another
  /// report of the suite had is not tried again.
  void expect_faults_found(const std::string& definition, const std::string& file) const {
    const Json report = read(file);
    std::vector<Pointer> objects, values;
    collect(report, Pointer(), objects, values);
    // An object of other keys is another one.
    const auto was_tried = [&](const Pointer& at) {
      std::string form = definition + at.to_string();
      const Json& value = report[at];
      if (value.is_object()) {
        for (const auto& [key, part] : value.items()) form += " " + key;
      } else {
        form += std::string(" ") + value.type_name();
      }
      return !tried.insert(form).second;
    };
    std::erase_if(objects, was_tried);
    std::erase_if(values, was_tried);
    std::vector<fs::path> faulty;
    std::vector<std::string> faults;
    const auto add = [&](const Json& wrong, const std::string& fault) {
      faulty.push_back(folder / ("fault" + std::to_string(faulty.size()) + ".json"));
      write_text(faulty.back(), wrong.dump());
      faults.push_back(fault);
    };
    for (const Pointer& object : objects) {
      Json wrong = report;
      wrong[object]["undocumented"] = nullptr;
      add(wrong, "a key more in " + object.to_string());
    }
    for (const Pointer& value : values) {
      Json wrong = report;
      wrong[value] = Json::object();
      add(wrong, "an object for " + value.to_string());
    }
    if (faulty.empty()) return;
    const pipeline::Run done = validate(definition, faulty);
    EXPECT_EQ(done.exit_code, 1) << done.err;
    for (std::size_t i = 0; i < faulty.size(); ++i) {
      EXPECT_NE(done.err.find(faulty[i].string() + ": $"), std::string::npos) << faults[i];
    }
    std::cout << definition << ": " << faulty.size() << " faults in " << done.seconds << " s\n";
  }

  /// Shirts that fit over each other.
  void mesh_larger(const std::string& name, double factor) const {
    Json pattern = Json::parse(read_text(sample("tshirt")));
    for (auto& [panel_name, panel] : pattern["pattern"]["panels"].items()) {
      for (Json& vertex : panel["vertices"]) {
        for (Json& coordinate : vertex) coordinate = factor * coordinate.get<double>();
      }
      const bool is_sleeve = panel_name.find("sleeve") != std::string::npos;
      Json& place = panel["translation"];
      if (is_sleeve) place[0] = factor * place[0].get<double>();
      place[1] = place[1].get<double>() + (factor - 1) * (is_sleeve ? 14 : -62);
    }
    mesh_as(name, pattern);
  }

  void mesh_as(const std::string& name, const Json& pattern) const {
    write_text(folder / (name + "-pattern.json"), pattern.dump());
    succeed("mesh-pattern", {folder / (name + "-pattern.json"), "-o", folder / (name + ".obj"),
                             "--edge-length", "40mm", "-q"});
  }

  pipeline::Run dress_scene(const Json& scene, const std::vector<std::string>& options = {}) const {
    write_text(folder / "scene.json", scene.dump());
    std::vector<std::string> words = {"--scene",  folder / "scene.json",  "-o", folder / "worn.obj",
                                      "--report", folder / "report.json", "-q"};
    words.insert(words.end(), options.begin(), options.end());
    return run("dress", words);
  }

  static ScratchFolder* shared;
  static inline std::set<std::string> tried;
};

ScratchFolder* ReportSchema::shared = nullptr;

/// Suites run side by side.
using ReportSchemaOfStarts = ReportSchema;
using ReportSchemaOfLayers = ReportSchema;

/// The sample band with panels of `width` centimetres.
Json band(double width) {
  Json pattern = Json::parse(read_text(sample("band")));
  for (Json& panel : pattern["pattern"]["panels"]) {
    panel["vertices"] = {{-width / 2, 5}, {width / 2, 5}, {width / 2, 21}, {-width / 2, 21}};
    panel["edges"] = Json::array();
    for (int i = 0; i < 4; ++i) panel["edges"].push_back({{"endpoints", {i, (i + 1) % 4}}});
  }
  return pattern;
}

TEST_F(ReportSchema, HoldsForTheBodysPrograms) {
  succeed("make-mannequin",
          {"-o", folder / "raw.ply", "--report", folder / "mannequin.json", "-q"});
  succeed("clean-body", {folder / "raw.ply", "-o", folder / "clean.ply", "--report",
                         folder / "cleaning.json", "-q"});
  expect_valid("make_mannequin", "mannequin.json");
  expect_valid("clean_body", "cleaning.json");
  succeed("clean-body", {folder / "raw.ply", "--points", "-o", folder / "scanned.ply", "--report",
                         folder / "scan.json", "-q"});
  expect_valid("clean_body", "scan.json", {"/scan/holes", "/scan/error_mm/p95"});
  expect_faults_found("make_mannequin", "mannequin.json");
  expect_faults_found("clean_body", "cleaning.json");
  succeed("pose-body", {folder / "raw.ply", "--pose", "sitting", "-o", folder / "posed.ply",
                        "--report", folder / "posing.json", "-q"});
  expect_valid("pose_body", "posing.json");
  expect_faults_found("pose_body", "posing.json");
}

TEST_F(ReportSchema, HoldsForDrapeTest) {
  succeed("drape-test", {"jersey", "--edge-length", "15mm", "--starts", "2", "-o", folder / "d.png",
                         "--report", folder / "draping.json", "-q"});
  expect_valid("drape_test", "draping.json");
  expect_faults_found("drape_test", "draping.json");
}

TEST_F(ReportSchema, HoldsForImportPattern) {
  succeed("import-pattern", {fs::path(TOILE_SOURCE_DIR) / "tests/io/drawings/r2013.dxf", "-o",
                             folder / "drawn.json", "--report", folder / "import.json", "-q"});
  expect_valid("import_pattern", "import.json", {"/panels/0/grain_degrees"});
  expect_faults_found("import_pattern", "import.json");
}

TEST_F(ReportSchema, HoldsForFindSeamsAndEditSeams) {
  const auto found = run("find-seams", {sample("tshirt"), "-o", folder / "sewn.json", "--report",
                                        folder / "seams.json", "--min-confidence", "0.99", "-q"});
  EXPECT_EQ(found.exit_code, 3) << found.err;
  expect_valid("find_seams", "seams.json", {"/undecided/0/alternative", "/edges_open/0/edge"});
  expect_faults_found("find_seams", "seams.json");
  succeed("edit-seams",
          {sample("tshirt"), "-o", folder / "page.html", "--report", folder / "edit.json", "-q"});
  expect_valid("edit_seams", "edit.json");
  expect_faults_found("edit_seams", "edit.json");
}

TEST_F(ReportSchema, HoldsForMeshPatternDressEaseMapAndRender) {
  succeed("mesh-pattern", {sample("tshirt"), "-o", garment, "--edge-length", "25mm", "--report",
                           folder / "mesh.json", "-q"});
  EXPECT_EQ(dress("dressed", {"--certify-frames"}).exit_code, 0);
  succeed("ease-map",
          {"--body", body, folder / "dressed.obj", "-o", folder / "ease.html", "--report",
           folder / "ease-report.json", "--against", folder / "dressed.obj", "-q"});
  succeed("render", {"--body", body, folder / "dressed.obj", "-o", folder / "drape.png", "--report",
                     folder / "render.json", "-q"});
  succeed("export-pattern",
          {sample("tshirt"), "-o", folder / "shirt.svg", "--report", folder / "export.json", "-q"});
  expect_valid("export_pattern", "export.json", {"/panels/0/name"});
  succeed("measure-pattern",
          {sample("tshirt"), "-o", folder / "pom.csv", "--report", folder / "pom.json", "-q"});
  expect_valid("measure_pattern", "pom.json", {"/points/0/actual_cm"});
  expect_faults_found("measure_pattern", "pom.json");
  expect_faults_found("export_pattern", "export.json");
  expect_valid("mesh_pattern", "mesh.json");
  expect_valid("dress", "dressed.json", {"/certified/frames/0", "/quality", "/wraps/0"});
  expect_valid("ease_map", "ease-report.json", {"/girths/1/level", "/against/differences/0"});
  expect_valid("render", "render.json");
  expect_faults_found("mesh_pattern", "mesh.json");
  expect_faults_found("dress", "dressed.json");
  expect_faults_found("ease_map", "ease-report.json");
  expect_faults_found("render", "render.json");
  // A report is only its own program's.
  EXPECT_EQ(validate("dress_scene", {folder / "dressed.json"}).exit_code, 1);
}

TEST_F(ReportSchema, HoldsForWhatToileFitWrites) {
  const pipeline::Run done = run("toile", {"fit", "--body", body, sample("gathered_skirt"), "-o",
                                           folder / "fit", "--edge-length", "40mm", "-q"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  expect_valid("dress", "fit/dressed.json", {"/scene/fabrics/0"});
  const pipeline::Run compared =
      run("toile", {"compare", folder / "fit", "-o", folder / "table.csv", "--target", "close",
                    "--report", folder / "compare.json", "-q"});
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
  expect_valid("compare", "compare.json", {"/runs/0/worst", "/runs/0/target", "/best/0/report"});
  expect_faults_found("compare", "compare.json");
}

TEST_F(ReportSchemaOfStarts, HoldsForElasticsAttachmentsAndRelease) {
  mesh(sample("tube_top"), "25mm");
  EXPECT_EQ(dress("top").exit_code, 0);
  expect_valid("dress", "top.json",
               {"/elastics/0", "/attachments/0", "/scene/positioned/0/gap_mm"});
  expect_faults_found("dress", "top.json");

  // A cloth before the body, hung by its upper corners.
  write_text(folder / "cloth.json", R"({"pattern": {"panels": {"cloth": {
      "placement": {"part": "torso", "side": "front", "at": "waist", "level": 0},
      "vertices": [[-20, -30], [20, -30], [20, 0], [-20, 0]],
      "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]},
                {"endpoints": [3, 0]}],
      "attach": [{"vertex": 2, "to": "place", "while": "always"},
                 {"vertex": 3, "to": "waist", "while": "always"}]}}},
      "properties": {"units_in_meter": 100}})");
  mesh(folder / "cloth.json", "60mm");
  EXPECT_EQ(dress("hung", {"--release", "1s"}).exit_code, 0);
  expect_valid("dress", "hung.json",
               {"/attachments/0/pull_N", "/release/crept_mm", "/scene/positioned/0/distance_mm"});
  expect_faults_found("dress", "hung.json");
}

TEST_F(ReportSchemaOfStarts, HoldsForGarmentsThatCannotBeSewn) {
  mesh_as("garment", band(25));
  EXPECT_EQ(dress("tight").exit_code, 3);
  expect_valid("dress", "tight.json", {"/tight_seams/0", "/fit/levels/0"});
  expect_faults_found("dress", "tight.json");

  // Fronts and backs on one side of the body, which the sleeves go around.
  Json tshirt = Json::parse(read_text(sample("tshirt")));
  Json& panels = tshirt["pattern"]["panels"];
  for (const std::string side : {"left", "right"}) {
    panels[side + "_back"]["translation"] = panels[side + "_front"]["translation"];
    panels[side + "_back"]["rotation"] = panels[side + "_front"]["rotation"];
  }
  mesh_as("garment", tshirt);
  EXPECT_EQ(dress("open").exit_code, 3);
  expect_valid("dress", "open.json", {"/unwrapped/0"});
}

TEST_F(ReportSchemaOfStarts, HoldsForLayoutsThatStandElsewhereOrNowhere) {
  Json tshirt = Json::parse(read_text(sample("tshirt")));
  for (auto& [name, panel] : tshirt["pattern"]["panels"].items()) {
    panel["translation"][1] = panel["translation"][1].get<double>() - 60;
  }
  mesh_as("garment", tshirt);
  EXPECT_EQ(dress("lower").exit_code, 0);
  expect_valid("dress", "lower.json", {"/scene/layout_moved/translation_mm/1"});
  expect_faults_found("dress", "lower.json");

  for (auto& [name, panel] : tshirt["pattern"]["panels"].items()) {
    panel["translation"] = {0, 0, 0};
  }
  mesh_as("garment", tshirt);
  const pipeline::Run done = dress("nowhere");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  expect_valid("dress", "nowhere.json", {"/scene/placed_by_seams/panels/0/side"});
  for (const Json& place : report("nowhere")["scene"]["placed_by_seams"]["panels"]) {
    const std::string name = place["panel"];
    const bool is_front = name.ends_with("_front") || name.ends_with("_f");
    EXPECT_EQ(place["side"], is_front ? "front" : "back") << name;
    const bool is_sleeve = name.find("sleeve") != std::string::npos;
    const std::string side = name.starts_with("left") ? "left" : "right";
    EXPECT_EQ(place["part"], is_sleeve ? side + "_arm" : "torso") << name;
  }

  // Places are asked of panels that are there.
  const pipeline::Run asked =
      dress("asked", {"--place", "left_sleeve_f=left_arm:front", "--place", "nobody=torso"});
  EXPECT_EQ(asked.exit_code, 1);
  EXPECT_NE(asked.err.find("nobody"), std::string::npos) << asked.err;
}

TEST_F(ReportSchemaOfStarts, HoldsForPanelsThatWereMoved) {
  body = folder / "body.ply";
  succeed("make-mannequin", {"-o", body, "--pose", "walking", "-q"});
  mesh(sample("tshirt"), "25mm");
  EXPECT_EQ(dress("walking", {"--cache"}).exit_code, 0);
  expect_valid("dress", "walking.json", {"/scene/turned_degrees", "/other_seconds/write_cache"});
  expect_faults_found("dress", "walking.json");
}

TEST_F(ReportSchemaOfStarts, HoldsForAStrainLimitAndAResidual) {
  mesh(sample("band_small"), "25mm");
  EXPECT_EQ(dress("limited", {"--strain-limit", "0.01", "--residual", "0.01"}).exit_code, 0);
  expect_valid("dress", "limited.json", {"/tight_regions/0", "/tight_specks"});
  EXPECT_FALSE(read("limited.json").contains("quality"));
  expect_faults_found("dress", "limited.json");
}

TEST_F(ReportSchemaOfLayers, HoldsForThePapersMethod) {
  mesh(sample("band"), "40mm");
  EXPECT_EQ(dress("paper", {"--method", "paper", "--certify-frames"}).exit_code, 0);
  expect_valid("dress", "paper.json", {"/time_step_s", "/certified", "/scene/terms/edge_springs"});
  expect_faults_found("dress", "paper.json");
}

TEST_F(ReportSchemaOfLayers, HoldsForLayersThatMoveTogether) {
  mesh_larger("shirt", 1);
  mesh_larger("coat", 1.12);
  const Json scene = {{"body", body},
                      {"layering", "coupled"},
                      {"layers",
                       {{{"name", "shirt"}, {"garment", "shirt.obj"}},
                        {{"name", "coat"}, {"garment", "coat.obj"}}}}};
  EXPECT_EQ(dress_scene(scene, {"--certify-frames"}).exit_code, 0);
  expect_valid("dress_scene", "report.json",
               {"/coupled/contacts/0", "/coupled/certified", "/layers/0/moved_coupled_mm",
                "/layers/1/scene/moved_off_layers_mm"});
  expect_faults_found("dress_scene", "report.json");
}

TEST_F(ReportSchemaOfLayers, HoldsForLayersThatAreNotDressed) {
  mesh_as("tight", band(25));
  mesh_as("loose", band(60));
  const Json scene = {{"body", body},
                      {"layers",
                       {{{"name", "inner"}, {"garment", "tight.obj"}},
                        {{"name", "outer"}, {"garment", "loose.obj"}}}}};
  EXPECT_EQ(dress_scene(scene, {"--method", "paper"}).exit_code, 3);
  expect_valid("dress_scene", "report.json", {"/not_dressed/0", "/layers/0/unsewable_seams/0"});
}

}  // namespace report_schema_test
}  // namespace toile::pipeline
