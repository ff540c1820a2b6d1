// The program dress, alone and in the whole chain from a body and a pattern to the ease map.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/mesh_file.h"
#include "tests/cloth/panels.h"
#include "tests/pattern/samples.h"
#include "tests/support/tubes.h"
#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace dress_test {

using Json = nlohmann::json;

/// Lines of an OBJ file that start with `word`.
std::vector<std::string> lines(const fs::path& obj, const std::string& word) {
  std::istringstream text(read_text(obj));
  std::vector<std::string> found;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with(word + " ")) found.push_back(line);
  }
  return found;
}

/// The names after a word such as "o", which begins an object.
std::vector<std::string> panels_of(const fs::path& obj, const std::string& word) {
  std::vector<std::string> names;
  for (const std::string& line : lines(obj, word)) names.push_back(line.substr(word.size() + 1));
  return names;
}

/// Corners of the faces as (v, vt), in the file's order.
std::vector<std::pair<int, int>> corners(const fs::path& obj) {
  std::vector<std::pair<int, int>> all;
  for (const std::string& line : lines(obj, "f")) {
    std::istringstream words(line.substr(2));
    for (std::string word; words >> word;) {  // v/vt or v/vt/vn
      std::istringstream corner(word);
      int v = 0, vt = 0;
      char slash = 0;
      corner >> v >> slash >> vt;
      all.emplace_back(v, vt);
    }
  }
  return all;
}

/// Dresses a body with a pattern in a folder of its own; every step has to end well.
struct Chain {
  ScratchFolder folder;
  fs::path body = folder / "body.ply";
  fs::path garment = folder / "garment.obj";
  fs::path dressed = folder / "dressed.obj";
  Json report;

  void prepare(const fs::path& raw_body, const fs::path& pattern, const std::string& edge_length) {
    succeed("clean-body", {raw_body, "-o", body, "-q"});
    succeed("mesh-pattern", {pattern, "-o", garment, "--edge-length", edge_length, "-q"});
  }

  void dress(const fs::path& to, const std::vector<std::string>& options = {}) {
    std::vector<std::string> words = {
        "--body", body, garment, "-o", to, "--report", to.string() + ".json"};
    words.insert(words.end(), options.begin(), options.end());
    succeed("dress", words);
    report = Json::parse(read_text(to.string() + ".json"));
  }

  double number(const std::string& pointer) const {
    return report.at(Json::json_pointer(pointer)).get<double>();
  }

  double wrapped(const std::string& part) const {
    for (const Json& wrap : report["wraps"]) {
      if (wrap["part"] == part) return wrap["fraction"];
    }
    return 0;
  }
};

void expect_sewn_without_intersections(const Chain& chain) {
  EXPECT_EQ(chain.report["verdict"], "sewn");
  EXPECT_EQ(chain.number("/seams/open"), 0);
  EXPECT_LE(chain.number("/seams/max_gap_mm"), 0.01);
  EXPECT_EQ(chain.number("/intersections/body"), 0);
  EXPECT_EQ(chain.number("/intersections/self"), 0);
  EXPECT_EQ(chain.report["intersections"]["check"], "exact");
  EXPECT_TRUE(chain.report["converged"].get<bool>());
}

// The paper's method on the sample skirt band and its too small sister: Zhong & Xu 2009, fig. 13.
TEST(Dress, ByThePapersMethodTellsWhatSewsFromWhatDoesNot) {
  Chain chain;
  const fs::path mannequin = chain.folder / "mannequin.ply";
  succeed("make-mannequin", {"-o", mannequin, "--edge-length", "12mm", "-q"});
  chain.prepare(mannequin, fs::path(TOILE_SOURCE_DIR) / "samples/band.json", "25mm");
  chain.dress(chain.dressed, {"--method", "paper", "--strain-control", "converged", "-q"});
  EXPECT_EQ(chain.report["method"], "paper");
  EXPECT_EQ(chain.report["verdict"], "sewn");
  EXPECT_EQ(chain.number("/seams/open"), 0);
  EXPECT_EQ(chain.number("/intersections/body") + chain.number("/intersections/self"), 0);
  EXPECT_LE(chain.number("/strain_off_seams/max"), 0.0105);
  EXPECT_GT(chain.wrapped("torso"), 0.95);

  const fs::path small = chain.folder / "small.obj";
  succeed("mesh-pattern", {fs::path(TOILE_SOURCE_DIR) / "samples/band_small.json", "-o", small,
                           "--edge-length", "25mm", "-q"});
  const fs::path report = chain.folder / "small.report.json";
  const pipeline::Run done =
      run("dress", {"--body", chain.body, small, "-o", chain.folder / "short.obj", "--report",
                    report, "--method", "paper", "-q"});
  EXPECT_EQ(done.exit_code, 3) << done.err;
  const Json said = Json::parse(read_text(report));
  EXPECT_EQ(said["verdict"], "unsewable");
  // Either both seams stand open, or one is sewn and the other lacks what both do.
  double gap_cm = 0;
  for (const Json& seam : said["unsewable_seams"]) {
    EXPECT_FALSE(seam["name"].get<std::string>().empty());
    gap_cm += seam["gap_cm"].get<double>();
  }
  EXPECT_GT(gap_cm, 4);
  EXPECT_LT(gap_cm, 11);
}

TEST(Dress, OptionsOfThePapersMethodAreChecked) {
  const auto with = [](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"--body", "body.ply", "garment.obj", "-o", "out.obj"};
    words.insert(words.end(), more.begin(), more.end());
    return run("dress", words);
  };
  EXPECT_EQ(with({"--method", "magic"}).exit_code, 2);
  EXPECT_EQ(with({"--sewing", "tau=0.3"}).exit_code, 2);  // belongs to the paper's
  EXPECT_EQ(with({"--method", "paper", "--shear-limit", "5"}).exit_code, 2);
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--sewing", "tau"},
                                                {"--sewing", "tua=1"},
                                                {"--sewing", "tau=-1"},
                                                {"--sewing", "delta=0"},
                                                {"--strain-control", "iron"},
                                                {"--time-step", "1"},
                                                {"--restitution", "2"}}) {
    std::vector<std::string> words = {"--method", "paper"};
    words.insert(words.end(), wrong.begin(), wrong.end());
    const pipeline::Run done = with(words);
    EXPECT_EQ(done.exit_code, 2) << wrong[0] << " " << wrong[1];
    EXPECT_NE(done.err.find(wrong[0]), std::string::npos) << done.err;
  }
}

TEST(Dress, TheSampleFromBodyAndPatternToEaseMap) {
  Chain chain;
  const fs::path raw = chain.folder / "raw.ply";
  succeed("make-mannequin", {"-o", raw, "-q"});
  chain.prepare(raw, fs::path(TOILE_SOURCE_DIR) / "samples" / "tshirt.json", "15mm");
  chain.dress(chain.dressed, {"-q", "--threads", "1"});

  expect_sewn_without_intersections(chain);
  const auto flat = corners(chain.garment);
  const auto worn = corners(chain.dressed);
  EXPECT_EQ(chain.number("/garment/triangles"), lines(chain.garment, "f").size());
  EXPECT_EQ(chain.number("/garment/nodes"), lines(chain.dressed, "v").size());
  EXPECT_EQ(chain.number("/garment/panels"), lines(chain.dressed, "o").size());
  EXPECT_EQ(chain.number("/garment/seams"), chain.number("/seams/sewn"));
  EXPECT_EQ(chain.number("/scene/terms/stretch"), chain.number("/garment/triangles"));
  EXPECT_GT(chain.number("/scene/terms/bend"), 0);
  EXPECT_GT(chain.number("/scene/terms/seam"), 0);
  EXPECT_EQ(chain.number("/scene/terms/body_contact"), chain.number("/garment/nodes"));
  EXPECT_EQ(chain.number("/scene/terms/strain_limit"), 0);
  EXPECT_TRUE(chain.report["method"].is_string());
  std::vector<std::string> stages;
  double seconds = 0;
  for (const Json& stage : chain.report["stages"]) {
    if (stages.empty() || stages.back() != stage["name"]) stages.push_back(stage["name"]);
    seconds += stage["seconds"].get<double>();
    EXPECT_TRUE(stage["converged"].is_boolean());
    EXPECT_GE(stage["steps"].get<int>(), 0);
  }
  EXPECT_EQ(stages,
            (std::vector<std::string>{"position", "close_seams", "untangle", "settle", "rest"}));
  EXPECT_GT(chain.number("/seconds"), seconds);
  EXPECT_GT(chain.number("/residual/median"), 0);
  EXPECT_LE(chain.number("/residual/median"), 0.0015);  // what the default asks for
  EXPECT_LT(chain.number("/residual/median"), chain.number("/residual/max"));
  EXPECT_LT(chain.number("/residual/rms"), chain.number("/residual/max"));
  EXPECT_LE(chain.number("/strain/rms"), chain.number("/strain/p99"));
  EXPECT_LE(chain.number("/strain/p99"), chain.number("/strain/max"));
  EXPECT_LE(chain.number("/strain_off_seams/p99"), 0.01);
  EXPECT_GT(chain.number("/strain_off_seams/rms"), 1e-5);
  EXPECT_LE(chain.number("/area_change_percent/max_panel"), 0.5);
  EXPECT_LE(std::abs(chain.number("/area_change_percent/total")),
            chain.number("/area_change_percent/max_panel"));
  EXPECT_GT(chain.number("/area_change_percent/max_during"),
            chain.number("/area_change_percent/max_panel"));
  EXPECT_LE(chain.number("/perimeter_change_percent/max_panel"), 1.0);
  EXPECT_GE(chain.number("/perimeter_change_percent/max_during"),
            chain.number("/perimeter_change_percent/max_panel"));
  EXPECT_EQ(chain.number("/borders"), 4);
  for (const char* part : {"torso", "left_arm", "right_arm"}) EXPECT_GE(chain.wrapped(part), 0.97);
  EXPECT_EQ(chain.report["wraps"].size(), 3U);

  // The same faces with the same flat coordinates; what is sewn shares a v.
  EXPECT_EQ(lines(chain.dressed, "vt"), lines(chain.garment, "vt"));
  EXPECT_EQ(panels_of(chain.dressed, "o"), panels_of(chain.garment, "g"));
  ASSERT_EQ(worn.size(), flat.size());
  std::map<int, int> node_of_point;
  for (std::size_t i = 0; i < worn.size(); ++i) {
    ASSERT_EQ(worn[i].second, flat[i].second);
    const auto [known, is_new] = node_of_point.try_emplace(flat[i].first, worn[i].first);
    EXPECT_EQ(known->second, worn[i].first);
  }
  const auto stitches = lines(chain.garment, "l");
  EXPECT_GT(stitches.size(), 100U);
  for (const std::string& stitch : stitches) {
    std::istringstream words(stitch.substr(2));
    int a = 0, b = 0;
    words >> a >> b;
    EXPECT_EQ(node_of_point.at(a), node_of_point.at(b)) << stitch;
  }

  chain.dress(chain.folder / "two.obj", {"-q", "--threads", "2"});
  EXPECT_TRUE(read_text(chain.folder / "two.obj") == read_text(chain.dressed));

  const fs::path ease = chain.folder / "ease.json";
  succeed("ease-map", {"--body", chain.body, chain.dressed, "-o", chain.folder / "ease.html",
                       "--report", ease, "-q"});
  const Json total = Json::parse(read_text(ease))["total"];
  // Outside the body everywhere, on it somewhere.
  EXPECT_GT(total["min_mm"].get<double>(), 0);
  EXPECT_LT(total["min_mm"].get<double>(), 2.5);
  EXPECT_GT(total["mean_mm"].get<double>(), 5);
}

TEST(Dress, ARealShirt) {
  TOILE_REAL_DATA(body, "bodies/mean_all.obj");
  TOILE_REAL_DATA(pattern, "patterns/garmentcode/shirt_mean.json");
  Chain chain;
  chain.prepare(body, pattern, "10mm");
  chain.dress(chain.dressed);
  expect_sewn_without_intersections(chain);
  for (const char* part : {"torso", "left_arm", "right_arm"}) EXPECT_GE(chain.wrapped(part), 0.97);
  EXPECT_EQ(chain.number("/borders"), 4);
  EXPECT_LE(chain.number("/area_change_percent/max_panel"), 0.5);
  EXPECT_LE(chain.number("/perimeter_change_percent/max_panel"), 1.0);
  EXPECT_LE(chain.number("/strain_off_seams/p99"), 0.04);
}

TEST(Dress, ARealDress) {
  TOILE_REAL_DATA(body, "bodies/mean_all.obj");
  TOILE_REAL_DATA(pattern, "patterns/garmentcode/dress_pencil.json");
  Chain chain;
  chain.prepare(body, pattern, "10mm");
  chain.dress(chain.dressed);
  expect_sewn_without_intersections(chain);
  EXPECT_GE(chain.wrapped("torso"), 0.97);
  EXPECT_EQ(chain.number("/borders"), 4);
  EXPECT_LE(chain.number("/area_change_percent/max_panel"), 0.5);
  EXPECT_LE(chain.number("/strain_off_seams/p99"), 0.06);
}

// Places that the report names are compared with the strain that is measured on the written file.
TEST(Dress, AStrainLimitIsKeptOrThePlacesAreNamedWhereItIsNot) {
  Chain chain;
  const fs::path raw = chain.folder / "raw.ply";
  succeed("make-mannequin", {"-o", raw, "-q"});
  chain.prepare(raw, sample("tshirt"), "25mm");
  chain.dress(chain.dressed, {"-q"});
  EXPECT_FALSE(chain.report.contains("tight_regions"));
  chain.dress(chain.dressed, {"-q", "--strain-limit", "0.01"});
  std::cout << "T-shirt: " << chain.report["warp_weft_strain"] << "\n";
  EXPECT_LE(chain.number("/warp_weft_strain/max"), 0.011);
  EXPECT_EQ(chain.report["tight_regions"], Json::array());
  EXPECT_EQ(chain.number("/tight_specks"), 0);

  chain.prepare(raw, sample("fitted_tshirt"), "25mm");
  const pipeline::Run done =
      run("dress", {"--body", chain.body, chain.garment, "-o", chain.dressed, "--strain-limit",
                    "0.01", "--report", chain.dressed.string() + ".json"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  chain.report = Json::parse(read_text(chain.dressed.string() + ".json"));
  EXPECT_EQ(chain.report["verdict"], "sewn");
  ASSERT_FALSE(chain.report["tight_regions"].empty());
  double before = 100 * chain.number("/warp_weft_strain/max");
  EXPECT_NEAR(chain.number("/tight_regions/0/largest_percent"), before, 1e-6);
  for (const Json& place : chain.report["tight_regions"]) {
    std::cout << "fitted T-shirt: " << place << "\n";
    const double largest = place["largest_percent"];
    EXPECT_LE(largest, before + 1e-6);
    EXPECT_GT(place["mean_percent"], 1.1);
    EXPECT_GE(place["area_cm2"], 1);
    EXPECT_GT(place["missing_cm"], 0);
    before = largest;
  }
  const std::string panel = chain.report["tight_regions"][0]["panel"];
  EXPECT_NE(done.err.find("beyond the strain limit: panel " + panel), std::string::npos)
      << done.err;
}

/// A loose tube of cloth placed around a cylinder: small, and quickly read.
class DressInput : public testing::Test {
 protected:
  DressInput() {
    write_mesh(body, test::closed_tube(0.15, 0.15, 1.6, 60));
    PanelMesh garment;
    for (const double z : {0.2, -0.2}) {
      test::add_panel(
          garment, z > 0 ? "front" : "back", test::grid(0.56, 0.3, 14, 8),
          [&](const Vec2& p) { return Vec3((p.x() - 0.28) * (z > 0 ? 1 : -1), 0.8 + p.y(), z); });
    }
    const auto side_of = [&](int panel, bool right) {
      return test::side(garment.panels[panel], 14, 8, right);
    };
    garment.seams = {test::seam("left", side_of(0, true), side_of(1, false)),
                     test::seam("right", side_of(1, true), side_of(0, false))};
    for (MeshedSeam& seam : garment.seams) seam.length_a = seam.length_b = 0.3;
    write_garment(obj, garment);
  }

  pipeline::Run dress(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"--body", body, obj, "-o", dressed, "--report", report};
    words.insert(words.end(), more.begin(), more.end());
    return run("dress", words, 60);
  }

  /// One message that names `place`, exit code 1, and nothing written.
  void expect_refused(const pipeline::Run& done, const std::string& place) const {
    EXPECT_EQ(done.exit_code, 1) << done.err;
    EXPECT_EQ(done.out, "");
    std::istringstream text(done.err);
    int messages = 0;
    for (std::string line; std::getline(text, line);) messages += !line.starts_with("warning: ");
    EXPECT_EQ(messages, 1) << done.err;
    EXPECT_NE(done.err.find(place), std::string::npos) << done.err;
    for (const std::string& name : folder.names()) {
      EXPECT_TRUE(name == "body.ply" || name.starts_with("garment.") || name == "fabric.json" ||
                  name == "other.json")
          << name;
    }
  }

  ScratchFolder folder;
  fs::path body = folder / "body.ply";
  fs::path obj = folder / "garment.obj";
  fs::path dressed = folder / "dressed.obj";
  fs::path report = folder / "dressed.json";
};

TEST_F(DressInput, BodiesThatAreNone) {
  TriangleMesh open = test::closed_tube(0.15, 0.15, 1.6, 60);
  open.triangles.pop_back();
  write_mesh(body, open);
  const auto done = dress();
  expect_refused(done, "body.ply");
  EXPECT_NE(done.err.find("clean-body"), std::string::npos) << done.err;
  write_text(body, "this is no mesh\n");
  expect_refused(dress(), "body.ply");
  write_text(body, "");
  expect_refused(dress(), "body.ply");
  fs::remove(body);
  expect_refused(dress(), "body.ply");
}

TEST_F(DressInput, GarmentsThatAreNone) {
  const std::string good = read_text(obj);
  for (const char* number : {"nan", "inf", "1e999"}) {
    const auto at = good.find("\nv ") + 3;
    write_text(obj, std::string(good).replace(at, good.find(' ', at) - at, number));
    expect_refused(dress(), "garment.obj");
  }
  write_text(obj, good.substr(0, good.size() / 2));
  expect_refused(dress(), "garment.");
  write_text(obj, "");
  expect_refused(dress(), "garment.");
  write_text(obj, good);
  const std::string json = read_text(folder / "garment.garment.json");
  write_text(folder / "garment.garment.json", json.substr(0, json.size() / 2));
  expect_refused(dress(), "garment.garment.json");
  fs::remove(folder / "garment.garment.json");
  expect_refused(dress(), "garment.garment.json");
  fs::remove(obj);
  expect_refused(dress(), "garment.");
}

TEST_F(DressInput, PanelsNameTheirFabrics) {
  Json json = Json::parse(read_text(folder / "garment.garment.json"));
  json["panels"][0]["fabric"] = "main";
  json["panels"][1]["fabric"] = "jersey";
  write_text(folder / "garment.garment.json", json.dump());
  expect_refused(dress(), "--fabric main=FILE.json");
  expect_refused(dress({"--fabric", "main=velvet"}), "velvet");
  expect_refused(dress({"--fabric", "main=denim", "--fabric", "collar=denim"}), "'collar'");
  expect_refused(dress({"--fabric", "main=denim", "--fabric", "main=jersey"}), "twice");
  expect_refused(dress({"--fabric", "denim", "--fabric", "jersey"}), "twice");
  const pipeline::Run done = dress({"--fabric", "main=denim", "--fabric", "silk-satin"});
  EXPECT_TRUE(done.exit_code == 0 || done.exit_code == 3) << done.err;
  const Json scene = Json::parse(read_text(report))["scene"];
  EXPECT_EQ(scene["fabric"], "silk-satin");
  for (const auto& [panel, fabric] : {std::pair("front", "denim"), {"back", "jersey"}}) {
    const auto used = std::ranges::find_if(scene["fabrics"], [&](const Json& one) {
      return std::ranges::find(one["panels"], panel) != one["panels"].end();
    });
    ASSERT_NE(used, scene["fabrics"].end());
    EXPECT_EQ((*used)["quantities"]["name"], fabric);
  }
}

TEST_F(DressInput, SettingsThatMakeNoSense) {
  expect_refused(dress({"--fabric", "velvet"}), "velvet");
  write_text(folder / "fabric.json", R"({"friction": -1})");
  expect_refused(dress({"--fabric", folder / "fabric.json"}), "friction");
  const auto expect_no_value = [this](const std::string& option, const std::string& value) {
    const pipeline::Run ended = dress({option + "=" + value});
    EXPECT_EQ(ended.exit_code, 2) << option << " " << value;
    EXPECT_EQ(ended.err.find("dress: error: " + option), 0U) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_FALSE(fs::exists(dressed));
  };
  expect_no_value("--strain-limit", "2");
  expect_no_value("--strain-limit", "nan");
  expect_no_value("--shear-limit", "90");
  for (const char* gravity : {"9.81", "0,0,0", "0,-9.81,0,0", "0,-981,0", "0;-9.81;0", "nan,0,0"}) {
    expect_no_value("--gravity", gravity);
  }
  expect_refused(dress({"--skeleton", folder / "missing.json"}), "missing.json");
  write_text(folder / "other.json", "{}");
  expect_refused(dress({"--skeleton", folder / "other.json"}), "other.json");
  expect_refused(dress({"--garment-json", folder / "missing.json"}), "missing.json");
}

TEST_F(DressInput, OutputsThatCannotBeWritten) {
  dressed = folder / "missing" / "dressed.obj";
  expect_refused(dress(), "missing");
  dressed = folder / "dressed.ply";
  expect_refused(dress(), "name it dressed.obj");
}

TEST_F(DressInput, WrongUsage) {
  const auto bodiless = run("dress", {obj, "-o", dressed});
  EXPECT_EQ(bodiless.exit_code, 2);
  EXPECT_NE(bodiless.err.find("dress: --body is missing\n"), std::string::npos) << bodiless.err;
  EXPECT_EQ(run("dress", {"--body", body, "-o", dressed}).exit_code, 2);
  EXPECT_EQ(run("dress", {"--body", body, obj}).exit_code, 2);
  EXPECT_EQ(dress({"--no-such-option"}).exit_code, 2);
  EXPECT_EQ(dress({"--strain-limit", "tight"}).exit_code, 2);
  EXPECT_FALSE(fs::exists(dressed));
}

TEST_F(DressInput, WhatFindsNoRestIsWrittenWithItsVerdict) {
  // Nothing holds a tube that is wider than its cylinder.
  const fs::path frames = folder / "frames";
  fs::create_directory(frames);
  write_text(frames / "9999-rest.obj", "of an earlier, longer run");
  const auto done = dress({"--frames", frames, "--certify-frames"});
  EXPECT_EQ(done.exit_code, 3) << done.err;
  EXPECT_NE(done.err.find("warning: "), std::string::npos);  // no skeleton: no wraps
  const std::string restless = "the garment did not come to rest: panel '";
  EXPECT_HOLDS(done.err, "warning: " + restless);
  const Json said = Json::parse(read_text(report));
  EXPECT_EQ(said["verdict"], "unconverged");
  EXPECT_TRUE(std::ranges::any_of(said["warnings"], [&](const Json& warning) {
    return warning["code"] == "unconverged" &&
           warning["text"].get<std::string>().rfind(restless, 0) == 0;
  }));
  EXPECT_FALSE(said["converged"].get<bool>());
  EXPECT_TRUE(said["wraps"].empty());
  EXPECT_EQ(said["seams"]["sewn"], 2);
  EXPECT_EQ(said["borders"], 2);
  EXPECT_EQ(corners(dressed).size(), 3U * 448U);
  int written = 0;
  for (const auto& entry : fs::directory_iterator(frames)) {
    ++written;
    EXPECT_EQ(corners(entry.path()).size(), 3U * 448U) << entry.path();
  }
  EXPECT_GT(written, 20);
  const Json& certified = said["certified"];
  EXPECT_EQ(certified["frames"].size(), written);
  EXPECT_EQ(certified["frames"].front()["stage"], "position");
  EXPECT_EQ(certified["frames"].back()["stage"], "dressed");
  // The tube is wide enough to sew itself without touching anything.
  EXPECT_EQ(certified["clean_from_frame"], 0);
  EXPECT_EQ(certified["clean_from_stage"], "position");
  EXPECT_EQ(certified["stayed_clean"], true);
  for (const Json& frame : certified["frames"]) EXPECT_EQ(frame["clean"], true) << frame;
}

}  // namespace dress_test
}  // namespace toile::pipeline
