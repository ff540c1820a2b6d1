// dress --scene: one garment over another, from patterns to the report.
#include <gtest/gtest.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "geometry/intersections.h"
#include "geometry/surface_distance.h"
#include "io/mesh_file.h"
#include "pattern/file/garment_file.h"
#include "tests/cloth/panels.h"
#include "tests/support/tubes.h"
#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace outfit_test {

using Json = nlohmann::ordered_json;

/// The sample T-shirt, larger in both directions and placed so that its shoulders lie where the
/// original's do.
std::string larger_tshirt(double factor) {
  Json pattern = Json::parse(read_text(sample("tshirt")));
  for (auto& [name, panel] : pattern["pattern"]["panels"].items()) {
    for (Json& vertex : panel["vertices"]) {
      for (Json& coordinate : vertex) coordinate = factor * coordinate.get<double>();
    }
    const bool is_sleeve = name.find("sleeve") != std::string::npos;
    Json& place = panel["translation"];
    if (is_sleeve) place[0] = factor * place[0].get<double>();
    place[1] = place[1].get<double>() + (factor - 1) * (is_sleeve ? 14 : -62);
  }
  return pattern.dump();
}

TriangleMesh mesh_of(const fs::path& dressed) {
  const DressedGarment garment = read_dressed(dressed);
  return {garment.points, garment.triangles};
}

TEST(Outfit, AShirtOverAShirt) {
  const ScratchFolder folder;
  const fs::path raw = folder / "raw.ply", body = folder / "body.ply";
  succeed("make-mannequin", {"-o", raw, "-q"});
  succeed("clean-body", {raw, "-o", body, "-q"});
  write_text(folder / "large.json", larger_tshirt(1.12));
  const std::vector<std::string> mesh = {"--edge-length", "25mm", "-q", "-o"};
  const auto mesh_pattern = [&](const fs::path& pattern, const fs::path& to) {
    std::vector<std::string> words = {pattern};
    words.insert(words.end(), mesh.begin(), mesh.end());
    words.push_back(to);
    succeed("mesh-pattern", words);
  };
  mesh_pattern(sample("tshirt"), folder / "tee.obj");
  mesh_pattern(folder / "large.json", folder / "coat.obj");
  write_text(folder / "scene.json", R"({"body": "body.ply", "layers": [
      {"name": "tee", "garment": "tee.obj"}, {"name": "coat", "garment": "coat.obj"}]})");
  succeed("dress", {"--scene", folder / "scene.json", "-o", folder / "worn.obj", "--report",
                    folder / "worn-report.json", "-q"});

  const Json report = Json::parse(read_text(folder / "worn-report.json"));
  EXPECT_EQ(report["verdict"], "sewn");
  EXPECT_TRUE(report["not_dressed"].empty());
  ASSERT_EQ(report["layers"].size(), 2U);
  const char* names[] = {"tee", "coat"};
  for (int i = 0; i < 2; ++i) {
    const Json& layer = report["layers"][i];
    EXPECT_EQ(layer["name"], names[i]);
    EXPECT_EQ(layer["verdict"], "sewn");
    EXPECT_EQ(layer["seams"]["open"], 0);
    for (const char* with : {"body", "self", "layers"}) {
      EXPECT_EQ(layer["intersections"][with], 0) << names[i] << " with " << with;
    }
    EXPECT_EQ(layer["intersections"]["check"], "exact");
    EXPECT_EQ(layer["borders"], 4);
    EXPECT_EQ(layer["wraps"].size(), 3U);
    for (const Json& wrap : layer["wraps"]) EXPECT_GE(wrap["fraction"].get<double>(), 0.85);
  }
  EXPECT_EQ(report["layers"][0]["scene"]["terms"]["layer_contact"], 0);
  EXPECT_EQ(report["layers"][1]["scene"]["terms"]["layer_contact"],
            report["layers"][0]["garment"]["triangles"]);
  EXPECT_FALSE(fs::exists(folder / "worn.obj"));

  // No point of the outer garment is behind the inner one.
  const TriangleMesh inner = mesh_of(folder / "worn-tee.obj");
  const TriangleMesh outer = mesh_of(folder / "worn-coat.obj");
  EXPECT_TRUE(intersections(inner, outer).empty());
  const SurfaceDistance to_inner(inner);
  double min_outer = 1;
  int near = 0;
  for (const Vec3& p : outer.points) {
    min_outer = std::min(min_outer, to_inner.closest_point(p).distance);
    near += to_inner.closest_point(p).distance < 0.006;
  }
  RecordProperty("outer_to_inner_least_mm", std::to_string(1000 * min_outer));
  RecordProperty("outer_points_that_touch", near);
  EXPECT_GT(min_outer, 0);
  EXPECT_GT(near, 100) << "the layers touch, so the test can fail";

  // The same, moving together in the end: the outer shirt weighs on the inner one, which gives way.
  write_text(folder / "coupled.json", R"({"body": "body.ply", "layering": "coupled", "layers": [
      {"name": "tee", "garment": "tee.obj"}, {"name": "coat", "garment": "coat.obj"}]})");
  for (const char* threads : {"1", "2"}) {
    const std::string name = std::string("moved") + threads;
    std::vector<std::string> words = {
        "--scene",  folder / "coupled.json",          "-o",        folder / (name + ".obj"),
        "--report", folder / (name + "-report.json"), "--threads", threads,
        "-q"};
    if (name == "moved1") words.push_back("--certify-frames");
    succeed("dress", words);
  }
  for (const char* layer : {"-tee.obj", "-coat.obj"}) {
    EXPECT_TRUE(read_text(folder / (std::string("moved1") + layer)) ==
                read_text(folder / (std::string("moved2") + layer)))
        << layer;
  }
  const Json moved = Json::parse(read_text(folder / "moved1-report.json"));
  EXPECT_EQ(report["layering"], "frozen");
  EXPECT_EQ(moved["layering"], "coupled");
  EXPECT_EQ(moved["verdict"], "sewn");
  const Json& whole = moved["coupled"];
  EXPECT_TRUE(whole["converged"].get<bool>());
  EXPECT_LE(whole["residual"]["median"].get<double>(), 0.0015);
  EXPECT_LE(whole["residual"]["wide"].get<double>(), 0.0015);
  EXPECT_TRUE(whole["certified"]["stayed_clean"].get<bool>());
  ASSERT_EQ(whole["contacts"].size(), 1U);
  EXPECT_EQ(whole["contacts"][0]["inner"], "tee");
  EXPECT_EQ(whole["contacts"][0]["outer"], "coat");
  EXPECT_GT(whole["contacts"][0]["force_N"].get<double>(), 0.1);
  const TriangleMesh moved_inner = mesh_of(folder / "moved1-tee.obj");
  const TriangleMesh moved_outer = mesh_of(folder / "moved1-coat.obj");
  const TriangleMesh bare = fan_triangles(read_mesh(body));
  EXPECT_TRUE(intersections(moved_inner, moved_outer).empty());
  for (const TriangleMesh* layer : {&moved_inner, &moved_outer}) {
    EXPECT_TRUE(self_intersections(*layer).empty());
    EXPECT_TRUE(intersections(*layer, bare).empty());
  }
  double farthest = 0;
  for (std::size_t n = 0; n < inner.points.size(); ++n) {
    farthest = std::max(farthest, (moved_inner.points[n] - inner.points[n]).norm());
  }
  std::cout << "inner shirt gives way by " << 1000 * farthest << " mm\n";
  EXPECT_GT(farthest, 1e-4);
  EXPECT_NEAR(moved["layers"][0]["moved_coupled_mm"]["max"].get<double>(), 1000 * farthest, 1e-6);
}

/// A cylinder, and a loose tube around it; nothing holds the tube, so it finds no rest.
class OutfitInput : public testing::Test {
 protected:
  OutfitInput() {
    write_mesh(folder / "body.ply", test::closed_tube(0.1, 0.1, 0.4, 40));
    PanelMesh garment;
    for (const double z : {0.15, -0.15}) {
      test::add_panel(
          garment, z > 0 ? "front" : "back", test::grid(0.4, 0.1, 8, 2),
          [&](const Vec2& p) { return Vec3((p.x() - 0.2) * (z > 0 ? 1 : -1), 0.2 + p.y(), z); });
    }
    const auto side_of = [&](int panel, bool right) {
      return test::side(garment.panels[panel], 8, 2, right);
    };
    garment.seams = {test::seam("left", side_of(0, true), side_of(1, false)),
                     test::seam("right", side_of(1, true), side_of(0, false))};
    for (MeshedSeam& seam : garment.seams) seam.length_a = seam.length_b = 0.1;
    write_garment(folder / "tube.obj", garment);
    write_scene({"first", "second"});
    before = folder.names();
  }

  void write_scene(const std::vector<std::string>& names) const {
    Json json = {{"body", "body.ply"}, {"layers", Json::array()}};
    for (const std::string& name : names) {
      json["layers"].push_back({{"name", name}, {"garment", "tube.obj"}});
    }
    write_text(scene, json.dump());
  }

  pipeline::Run dress(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"--scene", scene, "-o", output, "--report", report, "-q"};
    words.insert(words.end(), more.begin(), more.end());
    return run("dress", words, 60);
  }

  void expect_refused(const pipeline::Run& done, const std::string& place, int code = 1) const {
    EXPECT_EQ(done.exit_code, code) << done.err;
    EXPECT_NE(done.err.find(place), std::string::npos) << done.err;
    EXPECT_EQ(folder.names(), before);
  }

  ScratchFolder folder;
  fs::path scene = folder / "scene.json";
  fs::path output = folder / "out.obj";
  fs::path report = folder / "report.json";
  std::vector<std::string> before;
};

TEST_F(OutfitInput, ScenesThatAreNoneAreRefused) {
  write_text(scene, "{");
  expect_refused(dress(), "scene.json");
  write_scene({});
  expect_refused(dress(), "layers");
  write_scene({"a", "a"});
  expect_refused(dress(), "earlier layer");
  write_scene({"../a"});
  expect_refused(dress(), "file's name");
  write_scene({"a"});
  expect_refused(dress({"--fabric", "velvet"}), "velvet");
  const std::string layers = R"("layers": [{"name": "a", "garment": "tube.obj"}]})";
  write_text(scene, R"({"body": "body.ply", "layering": "glued", )" + layers);
  expect_refused(dress(), "neither 'frozen' nor 'coupled'");
  write_text(scene, R"({"body": "body.ply", "layering": "coupled", )" + layers);
  expect_refused(dress({"--method", "paper"}), "--method", 2);
  fs::remove(scene);
  std::erase(before, "scene.json");
  expect_refused(dress(), "scene.json");
}

TEST_F(OutfitInput, ASceneNamesBodyAndGarments) {
  expect_refused(dress({"--body", folder / "body.ply"}), "--scene names", 2);
  expect_refused(dress({folder / "tube.obj"}), "--scene names", 2);
  const pipeline::Run bare = run("dress", {"-o", output});
  expect_refused(bare, "body", 2);
}

TEST_F(OutfitInput, APanelOverAnotherThatIsNotThereIsSaidBeforeAnythingIsDressed) {
  write_text(scene, R"({"body": "body.ply", "layering": "coupled", "layers": [
      {"name": "first", "garment": "tube.obj", "panels_over": {"second": ["lapel"]}},
      {"name": "second", "garment": "tube.obj"}]})");
  expect_refused(dress(), "no panel is called 'lapel'");
}

TEST_F(OutfitInput, NoInputIsOverwritten) {
  fs::rename(folder / "tube.obj", folder / "out-first.obj");
  fs::rename(folder / "tube.garment.json", folder / "out-first.garment.json");
  write_text(scene, R"({"body": "body.ply",
                        "layers": [{"name": "first", "garment": "out-first.obj"}]})");
  before = folder.names();
  expect_refused(dress(), "would be overwritten");
  report = folder / "out-first.garment.json";
  output = folder / "other.obj";
  expect_refused(dress(), "would be overwritten");
  report = folder / "other-first.obj";
  expect_refused(dress(), "other-first.obj: would be written twice");
}

TEST_F(OutfitInput, ALayerThatIsOnlyNotAtRestIsDressedOver) {
  const pipeline::Run done = dress({"--no-floor"});  // it falls on
  EXPECT_EQ(done.exit_code, 3) << done.err;
  const Json said = Json::parse(read_text(report));
  EXPECT_EQ(said["layers"].size(), 2U);
  EXPECT_EQ(said["layers"][0]["verdict"], "unconverged");
  EXPECT_EQ(said["verdict"], "unconverged");
  EXPECT_TRUE(said["not_dressed"].empty());
  EXPECT_TRUE(fs::exists(folder / "out-first.obj"));

  // On one thread: the same bits.
  output = folder / "one.obj";
  EXPECT_EQ(dress({"--no-floor", "--threads", "1"}).exit_code, 3);
  for (const char* layer : {"first", "second"}) {
    const std::string file = std::string("-") + layer + ".obj";
    EXPECT_TRUE(read_text(folder / ("one" + file)) == read_text(folder / ("out" + file))) << layer;
  }
}

TEST_F(OutfitInput, NothingIsDressedOverALayerThatFailed) {
  // A tube of 44 cm for a cylinder of 63.
  PanelMesh tight;
  for (const double z : {0.15, -0.15}) {
    test::add_panel(
        tight, z > 0 ? "front" : "back", test::grid(0.22, 0.1, 8, 2),
        [&](const Vec2& p) { return Vec3((p.x() - 0.11) * (z > 0 ? 1 : -1), 0.15 + p.y(), z); });
  }
  const auto side_of = [&](int panel, bool right) {
    return test::side(tight.panels[panel], 8, 2, right);
  };
  tight.seams = {test::seam("left", side_of(0, true), side_of(1, false)),
                 test::seam("right", side_of(0, false), side_of(1, true))};
  for (MeshedSeam& seam : tight.seams) seam.length_a = seam.length_b = 0.1;
  write_garment(folder / "tight.obj", tight);
  write_text(scene, R"({"body": "body.ply", "layers": [
      {"name": "tight", "garment": "tight.obj"}, {"name": "coat", "garment": "tube.obj"}]})");
  // The default method closes every seam; the paper's does not.
  const pipeline::Run done = dress({"--method", "paper"});
  EXPECT_EQ(done.exit_code, 3) << done.err;
  EXPECT_NE(done.err.find("layer tight is unsewable"), std::string::npos) << done.err;
  const Json said = Json::parse(read_text(report));
  EXPECT_EQ(said["verdict"], "unsewable");
  EXPECT_EQ(said["layers"].size(), 1U);
  for (const Json& seam : said["layers"][0]["unsewable_seams"]) {
    EXPECT_NEAR(seam["gap_cm"].get<double>(), (63 - 44) / 2.0, 2) << seam;
  }
  EXPECT_EQ(said["not_dressed"], Json::array({"coat"}));
  EXPECT_TRUE(fs::exists(folder / "out-tight.obj"));
  EXPECT_FALSE(fs::exists(folder / "out-coat.obj"));
}

}  // namespace outfit_test
}  // namespace toile::pipeline
