// Case 6: bodies in the wrong place, unit and shape; numbers that are none, in any input file.
#include <numbers>
#include <regex>

#include "geometry/repair.h"
#include "io/mesh_file.h"
#include "io/skeleton_file.h"
#include "pattern/file/garment_file.h"
#include "tests/stability/hard_case.h"
#include "tests/support/shapes.h"

namespace toile::test {
namespace wrong_inputs_test {

using pipeline::read_text;
using pipeline::run;
using pipeline::write_text;

class WrongBody : public HardCase {
 protected:
  static TriangleMesh body() { return fan_triangles(read_mesh(mannequin())); }
  static TriangleMesh moved(TriangleMesh mesh, const Vec3& way) {
    for (Vec3& p : mesh.points) p += way;
    return mesh;
  }
  static TriangleMesh times(TriangleMesh mesh, double factor) {
    for (Vec3& p : mesh.points) p *= factor;
    return mesh;
  }
  static fs::path joints() { return skeleton_path(mannequin()); }

  /// A mesh file of the folder, and the mannequin's joints beside it.
  fs::path written(const TriangleMesh& mesh, const std::string& name) {
    const fs::path path = folder / (name + ".ply");
    write_mesh(path, mesh);
    fs::copy_file(joints(), skeleton_path(path), fs::copy_options::overwrite_existing);
    return path;
  }

  /// What clean-body makes of a mesh that has no joints beside it.
  fs::path cleaned(const TriangleMesh& mesh, const std::string& what, const std::string& words) {
    const fs::path in = folder / "scan.ply";
    const fs::path out = folder / "cleaned.ply";
    write_mesh(in, mesh);
    const pipeline::Run done = run("clean-body", {in, "-o", out});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(done.err.find(words), std::string::npos) << done.err;
    EXPECT_TRUE(fs::exists(skeleton_path(out))) << "joints: " << done.err;
    EXPECT_TRUE(is_closed(fan_triangles(read_mesh(out))));
    state("6 " + what, "clean-body", "mended", words);
    return out;
  }

  /// Dressed on it, the band has to come out as on the mannequin itself.
  void dresses(const fs::path& body, const std::string& what, const std::string& method) {
    const fs::path garment = band();
    const Ending on_this = dress(body, garment, method);
    const Ending on_itself = dress(mannequin(), garment, method);
    EXPECT_EQ(on_this.outcome, "sewn") << on_this.said;
    EXPECT_NEAR(on_this.report["strain_off_seams"]["p99"].get<double>(),
                on_itself.report["strain_off_seams"]["p99"].get<double>(), 0.003);
    state("6 " + what, method, on_this.outcome, on_this.figures());
  }

  void refuses(const TriangleMesh& mesh, const std::string& what, const std::string& words) {
    const std::string said = refused("dress", {"--body", written(mesh, "wrong"), band()});
    EXPECT_NE(said.find(words), std::string::npos) << said;
    state("6 " + what, "both", "error", said);
  }
};

TEST_F(WrongBody, TenKilometresAwayIsRefusedAndBroughtBack) {
  for (const Vec3& way : {Vec3(1e4, 0, 0), Vec3(0, 1e4, 0), Vec3(-7e3, 0, 7e3)}) {
    refuses(moved(body(), way), "body 10 km away", "from the origin");
  }
  dresses(cleaned(moved(body(), {1e4, 0, 0}), "body 10 km away", "m along x"),
          "body 10 km away, cleaned", "relaxation");
}

TEST_F(WrongBody, InAnotherUnitIsRefusedAndTold) {
  const std::pair<const char*, double> units[] = {
      {"mm", 1000}, {"cm", 100}, {"dm", 10}, {"in", 1 / 0.0254}};
  for (const auto& [unit, factor] : units) {
    const TriangleMesh mesh = times(body(), factor);
    refuses(mesh, std::string("body in ") + unit, "m tall");
    cleaned(mesh, std::string("body in ") + unit, std::string("unit taken to be ") + unit);
  }
  refuses(times(body(), 1e-3), "body in km", "m tall");
}

TEST_F(WrongBody, OpenIsRefusedAndClosed) {
  TriangleMesh open = body();
  open.triangles.resize(open.triangles.size() - 40);
  refuses(open, "open body", "border edges");
  cleaned(open, "open body", "filled");
}

TEST_F(WrongBody, OpenAtTheWaistIsRefusedByBoth) {
  TriangleMesh half = body();
  std::erase_if(half.triangles, [&](const Triangle& t) { return half.points[t[0]].y() > 1.2; });
  refuses(half, "body cut off at the chest", "border edges");
  write_mesh(folder / "half.ply", half);
  const std::string said = refused("clean-body", {folder / "half.ply"});
  EXPECT_NE(said.find("too large to be filled"), std::string::npos) << said;
  state("6 body cut off at the chest", "clean-body", "error", said);
}

TEST_F(WrongBody, InsideOutIsRefusedAndTurned) {
  refuses(inside_out(body()), "body inside out", "inside out");
  cleaned(inside_out(body()), "body inside out", "turned inside out");
}

TEST_F(WrongBody, ListedTwice) {
  TriangleMesh twice = body();
  twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.end());
  refuses(twice, "body's facets listed twice", "more than two triangles");
  cleaned(twice, "body's facets listed twice", "listed twice removed");
}

// Two closed surfaces in one place are a surface still: nothing is wrong with either.
TEST_F(WrongBody, Doubled) {
  const fs::path path = written(together(body(), body()), "doubled");
  for (const std::string& method : both_methods) dresses(path, "body doubled", method);
  cleaned(together(body(), body()), "body doubled", "doubled others");
}

/// Its left arm in the torso: some hundred facets through each other.
TEST_F(WrongBody, ThroughItself) {
  TriangleMesh crossed = body();
  for (Vec3& p : crossed.points) {
    if (p.x() > 0.33) p.x() -= 0.45;
  }
  write_mesh(folder / "crossed.ply", crossed);
  const fs::path garment = band();
  for (const std::string& method : both_methods) {
    // Its joints can't be found, so that what is wrapped is not measured.
    const Ending ending = dress(folder / "crossed.ply", garment, method);
    EXPECT_EQ(ending.outcome, "sewn") << ending.said;
    EXPECT_TRUE(ending.says("what the garment wraps is not measured")) << ending.said;
    state("6 body through itself", method, ending.outcome, ending.figures());
  }
  const pipeline::Run clean =
      run("clean-body", {folder / "crossed.ply", "-o", folder / "cleaned.ply"});
  EXPECT_EQ(clean.exit_code, 3);  // written, and not to be relied on
  EXPECT_NE(clean.err.find("pairs of triangles cross"), std::string::npos) << clean.err;
  state("6 body through itself", "clean-body", "warning", "says where triangles cross");
}

TEST_F(WrongBody, AnotherBodysJoints) {
  Json others = Json::parse(read_text(joints()));
  others["joints"]["chest"] = {0, 1e300, 0};
  write_mesh(folder / "body.ply", body());
  write_text(folder / "body.body.json", others.dump());
  const std::string said = refused("dress", {"--body", folder / "body.ply", band()});
  EXPECT_NE(said.find("joints, chest"), std::string::npos) << said;
  state("6 another body's joints", "both", "error", said);
}

class NoNumber : public HardCase {
 protected:
  /// What stands before the value of a key.
  static std::string after_key(std::string key) {
    key.insert(0, 1, '"');
    return key.append("\": ?");
  }
  /// A copy of `file` under `name` in which what `pattern` finds first has its number replaced.
  fs::path spoilt(const fs::path& file, const std::string& name, const std::string& pattern,
                  const std::string& number) {
    const std::string text = read_text(file);
    std::smatch found;
    EXPECT_TRUE(std::regex_search(text, found, std::regex(pattern + "([-+0-9.eE]+)")))
        << pattern << " is not in " << file;
    const auto at = static_cast<std::size_t>(found.position(1));
    write_text(folder / name, text.substr(0, at) + number +
                                  text.substr(at + static_cast<std::size_t>(found.length(1))));
    return folder / name;
  }
  /// Both, with a note of how many.
  void expect_refused(const std::string& program, const std::vector<std::string>& words,
                      const std::string& file) {
    const std::string said = refused(program, words);
    EXPECT_NE(said.find(file), std::string::npos) << "names the file: " << said;
    ++refusals_;
  }
  int refusals_ = 0;
};

const char* const no_numbers[] = {"nan", "-nan", "inf", "-inf", "NaN", "Infinity", "1e999"};

TEST_F(NoNumber, InAMesh) {
  const fs::path body = folder / "plain.obj";
  ASSERT_EQ(run("clean-body", {mannequin(), "-o", body, "-q"}).exit_code, 0);
  const fs::path garment = band();
  const std::string json = read_text(garment_json_path(garment));
  for (const char* number : no_numbers) {
    spoilt(body, "body.obj", "v \\S+ ", number);
    expect_refused("dress", {"--body", folder / "body.obj", garment}, "body.obj:");
    expect_refused("clean-body", {folder / "body.obj"}, "body.obj:");
    for (const char* of : {"v ", "vt "}) {
      spoilt(garment, "spoilt.obj", std::string("\n") + of, number);
      write_text(folder / "spoilt.garment.json", json);
      expect_refused("dress", {"--body", mannequin(), folder / "spoilt.obj"}, "spoilt.obj:");
    }
  }
  state("6 NaN and infinity in meshes", "clean-body, dress", "error",
        std::to_string(refusals_) + " of " + std::to_string(refusals_) + " name file and line");
}

TEST_F(NoNumber, InBinaryMeshes) {
  const TriangleMesh mesh = fan_triangles(read_mesh(mannequin()));
  for (const double number : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    TriangleMesh spoilt = mesh;
    spoilt.points[100].y() = number;
    for (const char* name : {"body.ply", "body.stl", "body.off"}) {
      write_mesh(folder / name, spoilt);
      expect_refused("dress", {"--body", folder / name, band()}, name);
      expect_refused("clean-body", {folder / name}, name);
    }
  }
  state("6 NaN and infinity in PLY, STL, OFF", "clean-body, dress", "error",
        std::to_string(refusals_) + " of " + std::to_string(refusals_) + " name the file");
}

TEST_F(NoNumber, InAnyJson) {
  const fs::path garment = band();
  const fs::path joints = skeleton_path(mannequin());
  fs::copy_file(garment, folder / "spoilt.obj");
  fs::copy_file(mannequin(), folder / "body.ply");
  const std::string fabric =
      R"({"areal_density_kg_per_m2": 0.15, "thickness_mm": 0.3, "shear_N_per_m": 200,
          "stretch_warp_N_per_m": 1000, "bending_N_m": 1e-5, "friction": 0.4, "damping_s": 2e-5})";
  write_text(folder / "plain-fabric.json", fabric);
  write_text(folder / "plain-scene.json",
             Json({{"body", mannequin()},
                   {"gravity", {0, -9.81, 0}},
                   {"layers", {{{"name", "a"}, {"garment", garment}}}}})
                 .dump());
  for (const char* number : {"NaN", "Infinity", "-Infinity", "1e999", "\"12\"", "[]"}) {
    for (const char* key : {"grain", "length_a", "edge_length"}) {
      spoilt(garment_json_path(garment), "spoilt.garment.json", after_key(key), number);
      expect_refused("dress", {"--body", mannequin(), folder / "spoilt.obj"},
                     "spoilt.garment.json");
    }
    spoilt(joints, "body.body.json", "\"pelvis\": \\[\\s*", number);
    expect_refused("dress", {"--body", folder / "body.ply", garment}, "body.body.json");
    for (const char* key :
         {"\"vertices\": ?\\[\\[", "\"translation\": ?\\[", "\"units_in_meter\": ?"}) {
      spoilt(folder / "band-pattern.json", "pattern.json", key, number);
      expect_refused("mesh-pattern", {folder / "pattern.json"}, "pattern.json");
    }
    const Json quantities = Json::parse(fabric);
    for (const auto& [key, value] : quantities.items()) {
      spoilt(folder / "plain-fabric.json", "fabric.json", after_key(key), number);
      expect_refused("dress", {"--body", mannequin(), garment, "--fabric", folder / "fabric.json"},
                     "fabric.json");
    }
    spoilt(folder / "plain-scene.json", "scene.json", "\"gravity\": ?\\[0,", number);
    expect_refused("dress", {"--scene", folder / "scene.json"}, "scene.json");
  }
  state("6 NaN, infinity, text in JSON", "mesh-pattern, dress", "error",
        std::to_string(refusals_) + " of " + std::to_string(refusals_) + " name the file");
}

TEST_F(NoNumber, InOptions) {
  const fs::path garment = band();
  int refusals = 0;
  for (const char* number : {"nan", "inf", "-1", "1e999", "1e300", "x"}) {
    for (const std::string option :
         {"--gravity=0,%,0", "--strain-limit=%", "--shear-limit=%", "--residual=%", "--release=%s",
          "--method=paper --time-step=%", "--method=paper --restitution=%"}) {
      if (option.starts_with("--gravity") && number == std::string("-1")) continue;  // the moon's
      std::vector<std::string> words = {"--body", mannequin(), garment, "-o", folder / "no.obj"};
      std::istringstream all(option);
      for (std::string word; all >> word;) {
        if (const auto at = word.find('%'); at != std::string::npos) word.replace(at, 1, number);
        words.push_back(word);
      }
      const pipeline::Run done = run("dress", words, 60);
      EXPECT_TRUE(done.exit_code == 1 || done.exit_code == 2) << option << number << done.err;
      EXPECT_FALSE(fs::exists(folder / "no.obj"));
      ++refusals;
    }
  }
  state("6 NaN, infinity, nonsense in options", "dress", "error",
        std::to_string(refusals) + " of " + std::to_string(refusals) + " refused");
}

}  // namespace wrong_inputs_test
}  // namespace toile::test
