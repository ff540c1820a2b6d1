// The program mesh-pattern, from the pattern file to the garment's two files.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "pattern/file/garment_file.h"
#include "tests/pattern/samples.h"
#include "tests/support/worn_sample.h"

namespace toile {
namespace mesh_pattern_test {

namespace fs = std::filesystem;
using pipeline::read_text;
using pipeline::Run;
using pipeline::run;
using pipeline::ScratchFolder;
using pipeline::write_text;

Run mesh(const ScratchFolder& folder, const std::string& pattern,
         std::vector<std::string> options = {}) {
  write_text(folder / "bag.json", pattern);
  std::vector<std::string> arguments = {(folder / "bag.json").string(), "-o",
                                        (folder / "garment.obj").string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run("mesh-pattern", arguments, 60);
}

TEST(MeshPattern, WritesAGarmentThatReadsBack) {
  const ScratchFolder folder;
  const auto done = mesh(folder, samples::bag, {"--report", (folder / "report.json").string()});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.out, "");
  EXPECT_HOLDS(done.err, "note: ");
  EXPECT_HOLDS(done.err, "2 panels, ");
  EXPECT_HOLDS(done.err, "seam left side");
  EXPECT_HOLDS(done.err, "smallest angle");
  const PanelMesh garment = read_garment(folder / "garment.obj");
  EXPECT_EQ(garment.subdivisions, 2);
  EXPECT_EQ(garment.seams.size(), 3u);
  const auto report = nlohmann::json::parse(read_text(folder / "report.json"));
  EXPECT_EQ(report["garment"]["material_points"], garment.flat.size());
  EXPECT_EQ(report["garment"]["triangles"], garment.triangles.size());
  EXPECT_GT(report["panels"][0]["smallest_angle_degrees"], 20);
  EXPECT_NEAR(report["panels"][1]["area_cm2"].get<double>(),
              1e4 * (0.3 * 0.41 + 0.3 * 0.3 * 0.2 / 3), 10);
  EXPECT_EQ(report["notes"].size(), 2u);
}

TEST(MeshPattern, TheSameBitsForAnyNumberOfThreads) {
  const ScratchFolder one;
  const ScratchFolder four;
  ASSERT_EQ(mesh(one, samples::bag, {"--threads", "1", "-q"}).exit_code, 0);
  ASSERT_EQ(mesh(four, samples::bag, {"--threads", "4", "-q"}).exit_code, 0);
  EXPECT_EQ(read_text(one / "garment.obj"), read_text(four / "garment.obj"));
  EXPECT_EQ(read_text(one / "garment.garment.json"), read_text(four / "garment.garment.json"));
}

TEST(MeshPattern, FlatLaysThePanelsSideBySide) {
  const ScratchFolder folder;
  const auto done = mesh(folder, samples::bag, {"--flat", "-q", "--edge-length", "2cm"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.err, "");
  const PanelMesh garment = read_garment(folder / "garment.obj");
  double right = -1;
  for (const MeshedPanel& panel : garment.panels) {
    double low = 1e300;
    double high = -1e300;
    for (int i = panel.first_point; i < panel.first_point + panel.points; ++i) {
      const Vec3& point = garment.placed[static_cast<std::size_t>(i)];
      EXPECT_EQ(point.z(), 0);
      low = std::min(low, point.x());
      high = std::max(high, point.x());
    }
    EXPECT_GT(low, right);
    right = high;
  }
}

TEST(MeshPattern, BadInputEndsWithOneMessageAndNoFile) {
  const std::string crossed = samples::file(samples::polygon("bow", "[0,0],[10,10],[10,0],[0,10]"));
  for (const std::string& text : {std::string("not json"), std::string(), crossed,
                                  samples::bag.substr(0, samples::bag.size() / 2)}) {
    const ScratchFolder folder;
    const auto failed = mesh(folder, text);
    EXPECT_EQ(failed.exit_code, 1);
    EXPECT_HOLDS(failed.err, "mesh-pattern: error: ");
    EXPECT_HOLDS(failed.err, "bag.json");
    EXPECT_EQ(std::count(failed.err.begin(), failed.err.end(), '\n'), 1);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"bag.json"});
  }
  const ScratchFolder folder;
  EXPECT_EQ(run("mesh-pattern", {"no/such.json", "-o", (folder / "g.obj").string()}).exit_code, 1);
  EXPECT_EQ(mesh(folder, samples::bag, {"--edge-length", "-3mm"}).exit_code, 2);
  EXPECT_EQ(mesh(folder, samples::bag, {"--edge-length", "1um"}).exit_code, 2);
  const auto bare = mesh(folder, samples::bag, {"--edge-length", "25"});
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_HOLDS(bare.err, "--edge-length: '25' is not a length; give a positive number with m, dm");
  EXPECT_EQ(mesh(folder, samples::bag, {"--subdivisions", "5"}).exit_code, 2);
  EXPECT_EQ(mesh(folder, samples::bag, {"--nonsense"}).exit_code, 2);
  const auto none = run("mesh-pattern", {"-o", (folder / "g.obj").string()});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_HOLDS(none.err, "mesh-pattern: the pattern is missing\nusage: ");
  const auto two = run("mesh-pattern", {"a.json", "b.json", "-o", (folder / "g.obj").string()});
  EXPECT_EQ(two.exit_code, 2);
  EXPECT_HOLDS(two.err, "mesh-pattern: takes one pattern; 'b.json' is too many\nusage: ");
}

TEST(MeshPattern, ThePatternIsNeverOverwritten) {
  const ScratchFolder folder;
  const fs::path named_so = folder / "bag.garment.json";
  write_text(named_so, samples::bag);
  const auto beside = run("mesh-pattern", {named_so, "-o", folder / "bag.obj"});
  EXPECT_EQ(beside.exit_code, 1);
  EXPECT_HOLDS(beside.err, "bag.garment.json: would be overwritten; give the output another name");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"bag.garment.json"});
  write_text(folder / "bag.obj", samples::bag);
  const auto itself =
      run("mesh-pattern", {(folder / "bag.obj").string(), "-o", (folder / "bag.obj").string()});
  EXPECT_EQ(itself.exit_code, 1);
  EXPECT_HOLDS(itself.err, "would be overwritten");
  EXPECT_EQ(read_text(folder / "bag.obj"), samples::bag);
  EXPECT_EQ(read_text(named_so), samples::bag);
}

TEST(MeshPattern, AGarmentMayBeCalledAfterItsPattern) {
  const ScratchFolder folder;
  const fs::path pattern = folder / "band.json";
  fs::copy_file(fs::path(TOILE_SOURCE_DIR) / "samples/band.json", pattern);
  const std::string before = read_text(pattern);
  // The body has the name, too.
  pipeline::succeed("make-mannequin", {"-o", folder / "band.ply", "--edge-length", "15mm", "-q"});
  const auto dress = [&] {
    return run("dress", {"--body", folder / "band.ply", folder / "band.obj", "-o",
                         folder / "dressed.obj", "--quality", "draft", "-q"});
  };
  pipeline::succeed("mesh-pattern",
                    {pattern, "-o", folder / "band.obj", "--edge-length", "30mm", "-q"});
  const auto dressed = dress();
  EXPECT_EQ(dressed.exit_code, 0) << dressed.err;
  EXPECT_EQ(folder.names(),
            (std::vector<std::string>{"band.body.json", "band.garment.json", "band.json",
                                      "band.obj", "band.ply", "dressed.obj"}));
  EXPECT_EQ(read_text(pattern), before);

  // The pattern does not pass for the garment's panels and seams.
  fs::remove(folder / "band.garment.json");
  const auto bare = dress();
  EXPECT_EQ(bare.exit_code, 1);
  EXPECT_HOLDS(bare.err, "band.garment.json: is missing: it holds the panels and seams of ");
}

TEST(MeshPattern, FilesOfAnEarlierVersionAreDressed) {
  const ScratchFolder folder;
  pipeline::succeed("make-mannequin", {"-o", folder / "body.ply", "--edge-length", "15mm", "-q"});
  pipeline::succeed("mesh-pattern", {fs::path(TOILE_SOURCE_DIR) / "samples/band.json", "-o",
                                     folder / "band.obj", "--edge-length", "30mm", "-q"});
  const auto dressed = [&](const std::string& name) {
    const auto done = run("dress", {"--body", folder / "body.ply", folder / "band.obj", "-o",
                                    folder / name, "--quality", "draft", "-q"});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(done.err, "");  // no joints would be a warning
    return read_text(folder / name);
  };
  const std::string now = dressed("now.obj");
  fs::rename(folder / "body.body.json", folder / "body.json");
  fs::rename(folder / "band.garment.json", folder / "band.json");
  EXPECT_EQ(dressed("then.obj"), now);
}

TEST(MeshPattern, TheRealPatternsAreMeshed) {
  TOILE_REAL_DATA(shirt, "patterns/garmentcode/shirt_mean.json");
  TOILE_REAL_DATA(dress, "patterns/garmentcode/dress_pencil.json");
  const ScratchFolder folder;
  const std::string out = (folder / "garment.obj").string();
  const auto shirt_run =
      run("mesh-pattern", {shirt.string(), "-o", out, "--edge-length", "10mm"}, 60);
  EXPECT_EQ(shirt_run.exit_code, 0);
  EXPECT_EQ(shirt_run.err.find("warning"), std::string::npos);
  EXPECT_EQ(read_garment(out).seams.size(), 18u);
  const auto dress_run = run("mesh-pattern", {dress.string(), "-o", out}, 60);
  EXPECT_EQ(dress_run.exit_code, 0);
  EXPECT_HOLDS(dress_run.err, "1.30 : 1");
  EXPECT_EQ(read_garment(out).seams.size(), 23u);
}

}  // namespace mesh_pattern_test
}  // namespace toile
