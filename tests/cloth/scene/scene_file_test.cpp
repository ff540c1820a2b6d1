#include "cloth/scene/scene_file.h"

#include <gtest/gtest.h>

#include "tests/pattern/samples.h"
#include "tests/support/run_program.h"

namespace toile {
namespace scene_file_test {

namespace fs = std::filesystem;
using pipeline::write_text;

class SceneFiles : public testing::Test {
 protected:
  SceneFiles() {
    fs::create_directory(folder / "parts");
    for (const char* name : {"body.ply", "bones.json", "parts/tee.obj", "parts/coat.obj",
                             "parts/coat-panels.json", "wool.json"}) {
      write_text(folder / name, "");
    }
  }

  SceneFile read(const std::string& text) const {
    write_text(scene, text);
    return read_scene(scene);
  }
  std::string refusal(const std::string& text) const {
    return samples::error_of([&] { read(text); });
  }
  /// The refusal of a scene with these layers.
  std::string refused_layers(const std::string& layers) const {
    return refusal(R"({"body": "body.ply", "layers": [)" + layers + "]}");
  }

  pipeline::ScratchFolder folder;
  fs::path scene = folder / "scene.json";
};

TEST_F(SceneFiles, PathsCountFromTheSceneFile) {
  const SceneFile read_back = read(R"({"body": "body.ply", "skeleton": "./bones.json", "layers": [
      {"name": "T-shirt", "garment": "parts/tee.obj"},
      {"name": "coat", "garment": "parts/coat.obj", "garment_json": "parts/coat-panels.json",
       "fabric": "wool.json"},
      {"name": "Überwurf 2", "garment": "parts/../parts/coat.obj", "fabric": "default"}]})");
  EXPECT_EQ(read_back.body, folder / "body.ply");
  EXPECT_EQ(read_back.skeleton, folder / "bones.json");
  ASSERT_EQ(read_back.layers.size(), 3U);
  EXPECT_EQ(read_back.layers[0].name, "T-shirt");
  EXPECT_EQ(read_back.layers[0].garment, folder / "parts" / "tee.obj");
  EXPECT_TRUE(read_back.layers[0].garment_json.empty());
  EXPECT_EQ(read_back.layers[0].fabric, "");
  EXPECT_EQ(read_back.layers[1].garment_json, folder / "parts" / "coat-panels.json");
  EXPECT_EQ(read_back.layers[1].fabric, (folder / "wool.json").string());
  EXPECT_EQ(read_back.layers[2].garment, folder / "parts" / "coat.obj");
  EXPECT_EQ(read_back.layers[2].fabric, "default");
  const std::string absolute = (folder / "body.ply").string();
  EXPECT_EQ(read("{\"body\": \"" + absolute +
                 R"(", "layers": [{"name": "a", "garment": "parts/tee.obj"}]})")
                .body,
            absolute);
}

TEST_F(SceneFiles, LayersAreFrozenUnlessTheyAreCoupled) {
  const std::string layers = R"("layers": [{"name": "a", "garment": "parts/tee.obj"}]})";
  EXPECT_FALSE(read(R"({"body": "body.ply", )" + layers).coupled);
  EXPECT_FALSE(read(R"({"body": "body.ply", "layering": "frozen", )" + layers).coupled);
  EXPECT_TRUE(read(R"({"body": "body.ply", "layering": "coupled", )" + layers).coupled);
  EXPECT_HOLDS(refusal(R"({"body": "body.ply", "layering": "loose", )" + layers), "layering");
  EXPECT_HOLDS(refusal(R"({"body": "body.ply", "layering": true, )" + layers), "is not text");
}

TEST_F(SceneFiles, PanelsMayLieOverALaterLayer) {
  const auto scene_of = [](const std::string& layering, const std::string& over) {
    return R"({"body": "body.ply", "layering": ")" + layering + R"(", "layers": [
        {"name": "shirt", "garment": "parts/tee.obj", "panels_over": )" +
           over + R"(}, {"name": "jacket", "garment": "parts/coat.obj"}]})";
  };
  const SceneFile given = read(scene_of("coupled", R"({"jacket": ["collar_*", "bow"]})"));
  EXPECT_EQ(given.layers[0].panels_over.at("jacket"),
            (std::vector<std::string>{"collar_*", "bow"}));
  EXPECT_TRUE(given.layers[1].panels_over.empty());
  EXPECT_HOLDS(refusal(scene_of("frozen", R"({"jacket": ["collar_*"]})")), "move together");
  EXPECT_HOLDS(refusal(scene_of("coupled", R"({"shirt": ["collar_*"]})")), "no later layer");
  EXPECT_HOLDS(refusal(scene_of("coupled", R"({"coat": ["collar_*"]})")), "no later layer");
  EXPECT_HOLDS(refusal(scene_of("coupled", R"({"jacket": []})")), "has 0 entries");
}

TEST_F(SceneFiles, WhatIsWrongIsNamed) {
  EXPECT_HOLDS(refusal("{"), "scene.json:1");
  EXPECT_HOLDS(refusal("[]"), "is not an object");
  EXPECT_HOLDS(refusal(R"({"layers": []})"), "has no 'body'");
  EXPECT_HOLDS(refusal(R"({"body": "body.ply"})"), "has no 'layers'");
  EXPECT_HOLDS(refused_layers(""), "has 0 entries");
  EXPECT_HOLDS(refusal(R"({"body": "body.ply", "layer": []})"), "unknown key 'layer'");
  EXPECT_HOLDS(refusal(R"({"body": "nobody.ply", "layers": []})"), "nobody.ply");
  EXPECT_HOLDS(refusal(R"({"body": 7, "layers": []})"), "is not text");
  EXPECT_HOLDS(refused_layers(R"({"name": "a"})"), "has no 'garment'");
  EXPECT_HOLDS(refused_layers(R"({"garment": "parts/tee.obj"})"), "has no 'name'");
  EXPECT_HOLDS(refused_layers(R"({"name": "a", "garment": "parts"})"), "is no file");
  EXPECT_HOLDS(refused_layers(R"({"name": "a", "garment": "parts/tee.obj", "fabric": "silk"})"),
               "silk");
  EXPECT_HOLDS(refused_layers(R"({"name": "a", "garment": "parts/tee.obj", "colour": "red"})"),
               "layers[0]");
  EXPECT_HOLDS(refused_layers(R"({"name": "a", "garment": "parts/tee.obj"},
                                 {"name": "A", "garment": "parts/coat.obj"})"),
               "earlier layer");
  EXPECT_HOLDS(samples::error_of([&] { read_scene(folder / "none.json"); }), "none.json");
}

TEST_F(SceneFiles, GravityIsAVectorOfAReasonableSize) {
  const auto with = [](const std::string& gravity) {
    return R"({"body": "body.ply", "layers": [{"name": "a", "garment": "parts/tee.obj"}], )"
           R"("gravity": )" +
           gravity + "}";
  };
  EXPECT_EQ(read(with("[1.5, 0, -9]")).gravity, Vec3(1.5, 0, -9));
  EXPECT_EQ(read(with("null")).gravity, std::nullopt);
  for (const char* wrong :
       {"-9.81", "[0, -9.81]", "[0, 0, 0]", "[0, \"-9.81\", 0]", "[0, 1e9, 0]"}) {
    EXPECT_HOLDS(refusal(with(wrong)), "gravity");
  }
}

TEST_F(SceneFiles, NamesStayInTheFolder) {
  for (const char* name : {"", "..", "../x", "a/b", "a\\\\b", "c:d", ".hidden", " a", "a ", "a.",
                           "a\\u0000b", "a\\nb", "a*"}) {
    const std::string text =
        std::string("{\"name\": \"") + name + R"(", "garment": "parts/tee.obj"})";
    EXPECT_HOLDS(refused_layers(text), "file's name") << name;
  }
  EXPECT_HOLDS(
      refused_layers("{\"name\": \"" + std::string(65, 'a') + R"(", "garment": "parts/tee.obj"})"),
      "bytes long");
}

}  // namespace scene_file_test
}  // namespace toile
