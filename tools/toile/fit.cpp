// toile fit: from a body and a pattern to the verdict, all in one process.
#include <array>
#include <iostream>

#include "geometry/error.h"
#include "io/skeleton_file.h"
#include "tools/clean_body/run.h"
#include "tools/dress/run.h"
#include "tools/ease_map/run.h"
#include "tools/mesh_pattern/run.h"
#include "tools/programs.h"
#include "tools/render.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

/// What the folder holds in the end.
struct FitFiles {
  explicit FitFiles(const fs::path& folder)
      : body(folder / "body.ply"),
        skeleton(folder / "body.json"),
        garment(folder / "garment.obj"),
        garment_json(folder / "garment.json"),
        dressed(folder / "dressed.obj"),
        report(folder / "dressed.json"),
        ease(folder / "ease.html"),
        ease_picture(folder / "ease.png"),
        drape_picture(folder / "drape.png") {}

  std::vector<fs::path> all() const {
    return {body,   skeleton, garment,      garment_json, dressed,
            report, ease,     ease_picture, drape_picture};
  }

  fs::path body, skeleton, garment, garment_json, dressed, report, ease, ease_picture,
      drape_picture;
};

/// Makes the folder, and removes what an earlier run left in it. If this run fails, no file there
/// may pass for its own.
void make_ready(const fs::path& folder, const FitFiles& files) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw Error(folder.string(), "can't be made", failed.message());
  for (const fs::path& file : files.all()) {
    fs::remove(file, failed);
    if (failed) throw Error(file.string(), "can't be replaced", failed.message());
  }
}

DressSettings dress_settings(const po::variables_map& given, const FitFiles& files) {
  DressSettings settings;
  settings.body = files.body;
  settings.skeleton = files.skeleton;
  settings.fabrics = read_fabrics(given);
  LayerFiles layer;
  layer.garment = files.garment;
  layer.fabric = find_fabric(settings.fabrics.of_garments);
  layer.output = files.dressed;
  settings.layers = {layer};
  if (given.count("cache") != 0) settings.cache = distances_path(files.body);
  settings.method = relaxation_of(read_quality(given));
  return settings;
}

int work(const po::variables_map& given, const CommonSettings& common) {
  const FitFiles files(common.output);
  const fs::path body = given["body"].as<std::string>();
  const fs::path pattern = given["pattern"].as<std::string>();
  refuse_overwriting(files.all(), {body, skeleton_path(body), pattern});
  make_ready(common.output, files);
  MeshPatternSettings mesh;
  mesh.pattern = pattern;
  mesh.mesh.edge_length = read_edge_length(given);
  const DressSettings dress = dress_settings(given, files);
  const bool pictures = given["png"].as<bool>();

  const auto writing = [&](const fs::path& output) {
    CommonSettings settings = common;
    settings.output = output;
    return settings;
  };
  common.say("Cleaning the body:");
  run_clean_body({body, read_unit(given)}, writing(files.body));
  common.say("Meshing the pattern:");
  run_mesh_pattern(mesh, writing(files.garment));
  common.say("Dressing:");
  CommonSettings dressing = writing(files.dressed);
  dressing.report = files.report;
  const Verdict verdict = run_dress(dress, dressing);
  common.say("Measuring the ease:");
  EaseMapSettings ease;
  ease.garment = files.dressed;
  ease.dress_report = files.report;
  ease.body = files.body;
  if (pictures) ease.png = files.ease_picture;
  run_ease_map(ease, writing(files.ease));
  if (pictures) {
    RenderSettings render;
    render.body = files.body.string();
    render.garments = {files.dressed.string()};
    run_render(render, writing(files.drape_picture));
  }
  std::cout << to_string(verdict) << ": see " << files.ease.string() << " and "
            << files.report.string() << std::endl;
  return exit_code_of(verdict);
}

}  // namespace

CommandLineProgram fit_program() {
  CommandLineProgram program;
  program.name = "toile fit";
  program.summary =
      "dresses a body with a pattern, from both files to the ease map and the verdict";
  program.usage = "--body BODY PATTERN.json -o OUT/ [options]";
  program.options.add_options()("body", po::value<std::string>()->required(),
                                "a mesh of a standing person: .obj, .ply, .stl or .off")(
      "pattern", po::value<std::string>()->required(), "the sewing pattern; also as argument");
  add_unit_option(program.options);
  add_edge_length_option(program.options);
  add_fabric_option(program.options);
  program.options.add_options()("quality", po::value<std::string>(),
                                "how near to rest: draft, standard (the default) or fine")(
      "cache",
      "keep the body's distances in OUT/body.distances: later fits of this body take less time")(
      "png", po::bool_switch(), "write pictures, too: OUT/ease.png and OUT/drape.png");
  program.positional.add("pattern", 1);
  program.writes_folder = true;
  program.check = [](const po::variables_map& given) { read_quality(given); };
  program.work = work;
  return program;
}

}  // namespace toile
