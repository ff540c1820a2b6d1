// toile fit: from a body and a pattern to the verdict, all in one process.
#include <array>
#include <iostream>

#include "geometry/error.h"
#include "io/skeleton_file.h"
#include "tools/clean_body/run.h"
#include "tools/dress/kept_distances.h"
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

/// Removes what an earlier run left. If this run fails, no file there may pass for its own.
void remove_earlier(const FitFiles& files) {
  std::error_code failed;
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

/// What the command line asks for.
struct FitSettings {
  CleanBodySettings body;
  MeshPatternSettings pattern;
  DressSettings dress;
  bool pictures = false;
};

ExitCode fit(const FitSettings& settings, const FitFiles& files, const CommonSettings& common) {
  const auto writing = [&](const fs::path& output) {
    CommonSettings of_step = common;
    of_step.output = output;
    return of_step;
  };
  remove_earlier(files);
  common.say("Cleaning the body:");
  run_clean_body(settings.body, writing(files.body));
  common.say("Meshing the pattern:");
  run_mesh_pattern(settings.pattern, writing(files.garment));
  common.say("Dressing:");
  CommonSettings dressing = writing(files.dressed);
  dressing.report = files.report;
  const Verdict verdict = run_dress(settings.dress, dressing);
  common.say("Measuring the ease:");
  EaseMapSettings ease;
  ease.garment = files.dressed;
  ease.dress_report = files.report;
  ease.body = files.body;
  if (settings.pictures) ease.png = files.ease_picture;
  run_ease_map(ease, writing(files.ease));
  if (settings.pictures) {
    RenderSettings render;
    render.body = files.body.string();
    render.garments = {files.dressed.string()};
    run_render(render, writing(files.drape_picture));
  }
  std::cout << to_string(verdict) << ": see " << files.ease.string() << " and "
            << files.report.string() << std::endl;
  return exit_code_of(verdict);
}

Job prepare_fit(const po::variables_map& given, const CommonSettings& common) {
  const FitFiles files(common.output);
  FitSettings settings;
  settings.body.inputs = {given["body"].as<std::string>()};
  settings.body.metres_per_unit = read_unit(given);
  settings.pattern.pattern = given["pattern"].as<std::string>();
  settings.pattern.mesh.edge_length = read_edge_length(given);
  settings.dress = dress_settings(given, files);
  settings.pictures = given["png"].as<bool>();
  Job job;
  job.files.reads = settings.dress.fabrics.files;
  job.files.reads.push_back(settings.body.inputs.front());
  job.files.reads.push_back(skeleton_path(settings.body.inputs.front()));
  job.files.reads.push_back(settings.pattern.pattern);
  job.files.writes = files.all();
  const fs::path distances = distances_path(files.body);
  job.files.keeps = {distances, raised_distances_path(distances)};
  job.work = [settings, files, &common] { return fit(settings, files, common); };
  return job;
}

}  // namespace

CommandLineProgram fit_program() {
  CommandLineProgram program;
  program.name = "toile fit";
  program.summary =
      "dresses a body with a pattern, from both files to the ease map and the verdict";
  program.usage = "--body BODY PATTERN.json -o OUT/ [options]";
  program.options.add_options()("body", po::value<std::string>()->required(),
                                "a mesh or scan of a standing person")(
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
  program.prepare = prepare_fit;
  return program;
}

}  // namespace toile
