#include "cloth/start/placement_warnings.h"

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "cloth/scene/collider.h"
#include "cloth/start/positioning.h"
#include "geometry/body/mannequin/mannequin.h"
#include "io/mesh_file.h"
#include "pattern/file/pattern_file.h"
#include "pattern/mesh/mesh_panels.h"
#include "tests/support/run_program.h"

namespace toile {
namespace placement_warnings_test {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Names = std::vector<std::string>;

/// A body to look at panels on.
struct Stage {
  explicit Stage(const TriangleMesh& body, Skeleton bones = {})
      : collider(body), skeleton(std::move(bones)) {
    scene.collider = &collider;
    if (!skeleton.joints.empty()) scene.skeleton = &skeleton;
  }
  explicit Stage(const Mannequin& mannequin) : Stage(mannequin.surface, mannequin.skeleton) {}
  Stage(const Stage&) = delete;

  Collider collider;
  Skeleton skeleton;
  Scene scene;
};

const Stage& mannequin() {
  static const Stage stage(make_mannequin({.edge_length = 0.014}));
  return stage;
}

Json sample(const std::string& name) {
  return Json::parse(
      pipeline::read_text(fs::path(TOILE_SOURCE_DIR) / "samples" / (name + ".json")));
}

/// The panels as they are placed on the stage.
PanelMesh placed(const Json& file, const Stage& stage) {
  std::vector<Remark> remarks;
  PanelMesh garment =
      mesh_panels(parse_pattern(file.dump(), "pattern.json", remarks), {0.025}, remarks);
  garment.placed = position_panels(garment, stage.collider.grid(), stage.scene.skeleton).placed;
  return garment;
}

struct WarnedPanels {
  Names swapped;
  Names other_side;
  Names inside_out;
};

WarnedPanels warned_panels(const Json& file, const Stage& stage = mannequin()) {
  WarnedPanels found;
  for (const PlacementWarning& warning : placement_warnings(placed(file, stage), stage.scene)) {
    EXPECT_NE(text_of(warning).find("panel '" + warning.panel + "' "), std::string::npos);
    using Kind = PlacementWarning::Kind;
    Names& names = warning.kind == Kind::swapped      ? found.swapped
                   : warning.kind == Kind::other_side ? found.other_side
                                                      : found.inside_out;
    names.push_back(warning.panel);
  }
  return found;
}

void expect_none(const Json& file, const Stage& stage, const std::string& name) {
  const WarnedPanels found = warned_panels(file, stage);
  EXPECT_EQ(found.swapped, Names()) << name;
  EXPECT_EQ(found.other_side, Names()) << name;
  EXPECT_EQ(found.inside_out, Names()) << name;
  // With room to spare.
  double least = 1;
  for (const double facing : facing_out(placed(file, stage), stage.collider.skin())) {
    least = std::min(least, facing);
  }
  std::cout << name << ": facing out by " << least << " at least\n";
  EXPECT_GT(least, 0.5) << name;
}

TEST(DoubtfulStart, NoneOfTheSamplesIs) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(TOILE_SOURCE_DIR) / "samples")) {
    if (entry.path().extension() != ".json") continue;
    const std::string name = entry.path().stem();
    expect_none(sample(name), mannequin(), name);
    ++count;
  }
  EXPECT_GE(count, 11);
  const Stage walking(make_mannequin({.edge_length = 0.014, .pose = walking_pose()}));
  expect_none(sample("walking_dress"), walking, "walking_dress on the walking mannequin");
}

TEST(DoubtfulStart, NoneOfGarmentCodesIs) {
  TOILE_REAL_DATA(body, "bodies/mean_all.obj");
  const Stage stage(fan_triangles(read_mesh(body)));
  for (const std::string name : {"shirt_mean", "dress_pencil"}) {
    TOILE_REAL_DATA(pattern, "patterns/garmentcode/" + name + ".json");
    expect_none(Json::parse(pipeline::read_text(pattern)), stage, name);
  }
}

/// The sample T-shirt, its sleeves in two halves that stand by translation and rotation.
class TshirtSleeves : public testing::Test {
 protected:
  Json& panel(const std::string& name) { return file["pattern"]["panels"][name]; }
  void place_as(const std::string& name, const std::string& other) {
    for (const char* key : {"translation", "rotation", "placement"}) {
      panel(name)[key] = panel(other)[key];
    }
  }

  Json file = sample("tshirt");
};

TEST_F(TshirtSleeves, AtEachOthersArmsAreNamed) {
  for (const std::string half : {"_sleeve_f", "_sleeve_b"}) {
    const Json left = panel("left" + half);
    place_as("left" + half, "right" + half);
    for (const char* key : {"translation", "rotation", "placement"}) {
      panel("right" + half)[key] = left[key];
    }
  }
  const WarnedPanels found = warned_panels(file);
  EXPECT_EQ(found.other_side,
            Names({"left_sleeve_b", "left_sleeve_f", "right_sleeve_b", "right_sleeve_f"}));
  EXPECT_EQ(found.inside_out, Names());
}

TEST_F(TshirtSleeves, OnlyThoseAtTheWrongArmAreNamed) {
  for (const std::string half : {"_sleeve_f", "_sleeve_b"}) {
    place_as("left" + half, "right" + half);
  }
  EXPECT_EQ(warned_panels(file).other_side, Names({"left_sleeve_b", "left_sleeve_f"}));
}

TEST_F(TshirtSleeves, AHalfAtTheWrongArmIsNamed) {
  place_as("left_sleeve_f", "right_sleeve_f");
  EXPECT_EQ(warned_panels(file).other_side, Names({"left_sleeve_f"}));
}

TEST_F(TshirtSleeves, ASignOfXIsFound) {
  for (const std::string half : {"_sleeve_f", "_sleeve_b"}) {
    Json& x = panel("left" + half)["translation"][0];
    x = -x.get<double>();
  }
  EXPECT_EQ(warned_panels(file).other_side, Names({"left_sleeve_b", "left_sleeve_f"}));
}

TEST_F(TshirtSleeves, NamesPlayNoPart) {
  // As placed and sewn, each panel is what the other's name says.
  std::string text = file.dump();
  for (const auto& [from, to] : std::map<std::string, std::string>{
           {"\"left_", "\"LEFT_"}, {"\"right_", "\"left_"}, {"\"LEFT_", "\"right_"}}) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
      // Body parts are the body's.
      if (text.compare(at + from.size(), 3, "arm") == 0) {
        at += from.size() - to.size() + 1;
        continue;
      }
      text.replace(at, from.size(), to);
    }
  }
  EXPECT_EQ(warned_panels(Json::parse(text)).other_side, Names());
}

TEST_F(TshirtSleeves, OneThatIsTurnedAroundIsInsideOut) {
  Json& y = panel("left_back")["rotation"][1];
  y = y.get<double>() + 180;
  const WarnedPanels found = warned_panels(file);
  EXPECT_EQ(found.inside_out, Names({"left_back"}));
  EXPECT_EQ(found.other_side, Names());
}

TEST(DoubtfulStart, ASleeveRolledAroundTheWrongArmIsNamed) {
  Json file = sample("jacket");
  file["pattern"]["panels"]["left_sleeve"]["placement"]["part"] = "right_arm";
  // Its name and its seams tell better.
  EXPECT_EQ(warned_panels(file).other_side, Names());
  std::string text = file.dump();
  const std::string name = "left_sleeve";
  for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos;) {
    text.replace(at, name.size(), "sleeve");
  }
  EXPECT_EQ(warned_panels(Json::parse(text)).other_side, Names({"sleeve"}));
}

TEST(DoubtfulStart, LegsInEachOthersPlaceAreNamed) {
  Json file = sample("trousers");
  Json& panels = file["pattern"]["panels"];
  for (const std::string half : {"_front", "_back"}) {
    for (const auto& [side, displacement] : {std::pair("left", -35.0), std::pair("right", 35.0)}) {
      Json& x = panels[side + half]["translation"][0];
      x = x.get<double>() + displacement;
    }
  }
  const Names legs = {"left_back", "left_front", "right_back", "right_front"};
  const WarnedPanels found = warned_panels(file);
  EXPECT_EQ(found.swapped, legs);
  EXPECT_EQ(found.other_side, Names());
  EXPECT_EQ(found.inside_out, Names());

  // Half waistbands that stand as they should are not blamed for the legs.
  for (const auto& [side, left, edge] : {std::tuple("left", 1, 7), {"right", -10, 5}}) {
    const std::string name = side + std::string("_band");
    Json segment = {{"vertices", {{0, 0}, {9, 0}, {9, 3}, {0, 3}}},
                    {"edges", Json::array()},
                    {"translation", {left, 104, 20}},
                    {"rotation", {0, 0, 0}}};
    for (int i = 0; i < 4; ++i) segment["edges"].push_back({{"endpoints", {i, (i + 1) % 4}}});
    panels[name] = segment;
    file["pattern"]["stitches"].push_back(
        Json::array({{{"panel", name}, {"edge", 0}},
                     {{"panel", side + std::string("_front")}, {"edge", edge}}}));
  }
  EXPECT_EQ(warned_panels(file).swapped, legs);
  EXPECT_EQ(warned_panels(file).other_side, Names());
}

TEST(DoubtfulStart, ASinglePanelBehindTheBodyThatFacesItIsInsideOut) {
  const auto sheet = [](double z, double turned) {
    Json file = Json::parse(R"({"pattern": {"panels": {"sheet": {
        "vertices": [[-20, 0], [20, 0], [20, 40], [-20, 40]],
        "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]},
                  {"endpoints": [3, 0]}]}}}, "properties": {"units_in_meter": 100}})");
    file["pattern"]["panels"]["sheet"]["translation"] = {0, 90, z};
    file["pattern"]["panels"]["sheet"]["rotation"] = {0, turned, 0};
    return warned_panels(file).inside_out;
  };
  EXPECT_EQ(sheet(30, 0), Names());
  EXPECT_EQ(sheet(-30, 0), Names({"sheet"}));
  EXPECT_EQ(sheet(-30, 180), Names());
  EXPECT_EQ(sheet(30, 180), Names({"sheet"}));
}

}  // namespace placement_warnings_test
}  // namespace toile
