// toile fit: from a body and a pattern to the verdict, all in one process.
#include <algorithm>
#include <iostream>
#include <iterator>

#include "geometry/error.h"
#include "io/skeleton_file.h"
#include "pattern/check/check_pattern.h"
#include "pattern/check/left_out.h"
#include "pattern/file/garment_file.h"
#include "pattern/file/pattern_file.h"
#include "tools/clean_body/run.h"
#include "tools/dress/kept_distances.h"
#include "tools/dress/run.h"
#include "tools/ease_map/run.h"
#include "tools/mesh_pattern/run.h"
#include "tools/programs.h"
#include "tools/render/run.h"
#include "tools/report.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

/// What the folder holds in the end.
struct FitFiles {
  explicit FitFiles(const fs::path& folder)
      : body(folder / "body.ply"),
        skeleton(skeleton_path(body)),
        body_report(folder / "body.report.json"),
        garment(folder / "garment.obj"),
        garment_json(garment_json_path(garment)),
        mesh_report(folder / "mesh.json"),
        dressed(folder / "dressed.obj"),
        report(folder / "dressed.json"),
        ease(folder / "ease.html"),
        ease_report(folder / "ease.json"),
        ease_picture(folder / "ease.png"),
        drape_picture(folder / "drape.png") {}

  std::vector<fs::path> all() const {
    return {body,    skeleton, body_report, garment,     garment_json, mesh_report,
            dressed, report,   ease,        ease_report, ease_picture, drape_picture};
  }

  fs::path body, skeleton, body_report;
  fs::path garment, garment_json, mesh_report;
  fs::path dressed, report;
  fs::path ease, ease_report, ease_picture, drape_picture;
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
  // A posed body has the triangles of the standing one, and is dressed as it is.
  settings.body = given.count("from") != 0 ? fs::path(given["body"].as<std::string>()) : files.body;
  // What cleaning writes, not what an earlier version left beside it.
  settings.skeleton = given.count("from") != 0 ? skeleton_beside(settings.body) : files.skeleton;
  settings.fabrics = read_fabrics(given);
  LayerFiles layer;
  layer.garment = files.garment;
  layer.fabric = find_fabric(settings.fabrics.of_garments);
  layer.output = files.dressed;
  layer.places = read_places(given);
  settings.layers = {layer};
  if (given.count("cache") != 0) settings.cache = distances_path(settings.body);
  read_drape_settings(given, settings);
  return settings;
}

/// What the command line asks for.
struct FitSettings {
  CleanBodySettings body;
  MeshPatternSettings pattern;
  DressSettings dress;
  bool pictures = false;
};

/// Throws Error for a pattern that can't be meshed, before anything is cleaned or removed.
void check_pattern_file(const fs::path& file) {
  std::vector<Remark> remarks;  // mesh-pattern says them
  check_pattern(without_left_out(read_pattern(file, remarks), remarks), remarks);
}

ExitCode fit(const FitSettings& settings, const FitFiles& files, const CommonSettings& common) {
  const auto step = [&](const char* program, const fs::path& output, const fs::path& report) {
    CommonSettings of_step = common;
    of_step.program = program;
    of_step.start = std::chrono::steady_clock::now();
    of_step.output = output;
    of_step.report = report;
    return of_step;
  };
  check_pattern_file(settings.pattern.pattern);
  remove_earlier(files);
  CleanBodyResult body;
  if (!settings.dress.standing) {
    common.say("Cleaning the body:");
    body = run_clean_body(settings.body, step("clean-body", files.body, files.body_report));
  }
  common.say("Meshing the pattern:");
  const std::vector<std::string> of_meshing =
      run_mesh_pattern(settings.pattern, step("mesh-pattern", files.garment, files.mesh_report));
  common.say("Dressing:");
  DressSettings dressing = settings.dress;
  dressing.earlier_warnings = warnings_of("body", body.warnings);
  std::ranges::move(warnings_of("pattern", of_meshing),
                    std::back_inserter(dressing.earlier_warnings));
  const DressEnd end = run_dress(dressing, step("dress", files.dressed, files.report));
  common.say("Measuring the ease:");
  EaseMapSettings ease;
  ease.garment = files.dressed;
  ease.dress_report = files.report;
  ease.body = settings.dress.body;
  if (settings.pictures) ease.png = files.ease_picture;
  run_ease_map(ease, step("ease-map", files.ease, files.ease_report));
  if (settings.pictures) {
    RenderSettings render;
    render.body = settings.dress.body.string();
    render.garments = {files.dressed.string()};
    CommonSettings drawing = common;
    drawing.output = files.drape_picture;
    run_render(render, drawing);
  }
  std::cout << to_string(end.verdict) << ": see " << files.ease.string() << " and "
            << files.report.string() << std::endl;
  return body.is_usable ? exit_code_of(end) : exit_negative;
}

Job prepare_fit(const po::variables_map& given, const CommonSettings& common) {
  const FitFiles files(common.output);
  FitSettings settings;
  settings.body.inputs = {given["body"].as<std::string>()};
  for (const char* option : {"unit", "height", "up", "front", "points"}) {
    if (given.count("from") == 0 || given[option].empty() || given[option].defaulted()) continue;
    throw UsageError("--" + std::string(option), "is for a body that is cleaned",
                     "leave it out: with --from the body is taken as pose-body wrote it");
  }
  read_body_options(given, settings.body);
  settings.pattern.pattern = given["pattern"].as<std::string>();
  settings.pattern.mesh.edge_length = read_edge_length(given);
  settings.dress = dress_settings(given, files);
  settings.pictures = given["png"].as<bool>();
  Job job;
  job.files.reads = settings.dress.fabrics.files;
  job.files.reads.push_back(settings.body.inputs.front());
  job.files.reads.push_back(skeleton_beside(settings.body.inputs.front()));
  job.files.reads.push_back(settings.pattern.pattern);
  if (settings.dress.standing) {
    job.files.reads.push_back(*settings.dress.standing);
    job.files.reads.push_back(skeleton_beside(*settings.dress.standing));
  }
  job.files.writes = files.all();
  job.files.keeps = kept_distances_of(settings.dress.body);
  if (settings.dress.standing) {
    const std::vector<fs::path> kept = kept_distances_of(*settings.dress.standing);
    job.files.keeps.insert(job.files.keeps.end(), kept.begin(), kept.end());
  }
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
                                "a mesh or scan of a standing person; with --from, a posed body")(
      "pattern", po::value<std::string>()->required(), "the sewing pattern; also as argument");
  add_body_options(program.options);
  add_edge_length_option(program.options);
  add_drape_options(program.options);
  program.options.add_options()("cache",
                                "keep the body's distances in OUT/body.distances, with --from "
                                "beside both bodies: later fits take less "
                                "time")("png", po::bool_switch(),
                                        "write pictures, too: OUT/ease.png and OUT/drape.png");
  program.positional.add("pattern", 1);
  program.writes_folder = true;
  program.check = [](const po::variables_map& given) {
    CleanBodySettings unused;
    read_body_options(given, unused);
    check_method_options(given);
  };
  program.prepare = prepare_fit;
  return program;
}

}  // namespace toile
