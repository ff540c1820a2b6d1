#include "tools/fit/chain.h"

#include <algorithm>
#include <iterator>

#include "geometry/error.h"
#include "io/skeleton_file.h"
#include "pattern/check/check_pattern.h"
#include "pattern/check/left_out.h"
#include "pattern/file/garment_file.h"
#include "pattern/file/pattern_file.h"
#include "tools/dress/kept_distances.h"
#include "tools/ease_map/pdf.h"
#include "tools/ease_map/run.h"
#include "tools/render/run.h"
#include "tools/report.h"

namespace toile {

namespace fs = std::filesystem;
namespace po = boost::program_options;

namespace {

constexpr int most_drapes = 9;

/// The coarsest mesh of --repeat has edges longer by this share. The spread over meshes of 10, 10,
/// 15, 15 and 25 mm held nine of ten of 93 eases of 22 random garments. That of 10 and 15 mm alone
/// held eight, that of five starts at 10 mm five. Double was not tried.
constexpr double coarser = 1.5;

}  // namespace

FitFiles::FitFiles(const fs::path& out, const std::string& before)
    : folder(out),
      body(out / "body.ply"),
      skeleton(skeleton_path(body)),
      body_report(out / "body.report.json"),
      garment(out / (before + "garment.obj")),
      garment_json(garment_json_path(garment)),
      mesh_report(out / (before + "mesh.json")),
      dressed(out / (before + "dressed.obj")),
      report(out / (before + "dressed.json")),
      ease(out / "ease.html"),
      ease_report(out / "ease.json"),
      ease_picture(out / "ease.png"),
      ease_pdf(out / "ease.pdf"),
      drape_picture(out / "drape.png"),
      dressed_glb(out / "dressed.glb"),
      body_obj(out / "body.obj"),
      points(out / "pom.csv"),
      points_report(out / "pom.json") {}

std::vector<fs::path> FitFiles::all() const {
  return {body,          skeleton,    body_report, garment,     garment_json, mesh_report,
          dressed,       report,      ease,        ease_report, ease_picture, ease_pdf,
          drape_picture, dressed_glb, body_obj,    points,      points_report};
}

FitFiles FitFiles::repeat(int number) const {
  return FitFiles(folder, "repeat-" + std::to_string(number) + "-");
}

std::vector<fs::path> FitFiles::of_drape() const {
  return {garment, garment_json, mesh_report, dressed, report};
}

void add_fit_options(po::options_description& options) {
  add_edge_length_option(options);
  add_drape_options(options, figures_quality);
  options.add_options()("cache",
                        "keep the body's distances in OUT/body.distances, with --from beside both "
                        "bodies: later fits take less time")(
      "repeat", po::value<int>()->default_value(1),
      "drape so many times, 3 to 9, on meshes up to 2.5 times as coarse: errors are of the spread")(
      "target", po::value<std::string>(),
      "the ease that is meant: close, fitted, semi-fitted, loose, or a JSON file of your own")(
      "png", po::bool_switch(), "write pictures, too: OUT/ease.png and OUT/drape.png")(
      "pdf", po::bool_switch(), "write the page as OUT/ease.pdf, A4; needs Chromium");
  add_pom_options(options);
}

void read_fit_options(const po::variables_map& given, const fs::path& body, const FitFiles& files,
                      FitSettings& settings) {
  settings.body.inputs = {body};
  settings.pattern.mesh.edge_length = read_edge_length(given);
  settings.pictures = given["png"].as<bool>();
  settings.pdf = given["pdf"].as<bool>();
  if (settings.pdf) check_printer();
  settings.drapes = given["repeat"].as<int>();
  if (settings.drapes != 1 && (settings.drapes < 3 || settings.drapes > most_drapes)) {
    throw UsageError("--repeat", "is " + std::to_string(settings.drapes),
                     "give 3 to 9, or leave it out");
  }
  if (given.count("target") != 0) {
    settings.targets = read_ease_targets(given["target"].as<std::string>());
  }
  DressSettings& dress = settings.dress;
  // A posed body has the triangles of the standing one, and is dressed as it is.
  dress.body = given.count("from") != 0 ? body : files.body;
  // What cleaning writes, not what an earlier version left beside it.
  dress.skeleton = given.count("from") != 0 ? skeleton_beside(body) : files.skeleton;
  dress.fabrics = read_fabrics(given);
  LayerFiles layer;
  layer.garment = files.garment;
  layer.fabric = find_fabric(dress.fabrics.of_garments);
  layer.output = files.dressed;
  layer.places = read_places(given);
  dress.layers = {layer};
  if (given.count("cache") != 0) dress.cache = distances_path(dress.body);
  read_drape_settings(given, dress);
  read_pom_options(given, settings.points);
}

ProgramFiles files_of(const FitSettings& settings, const FitFiles& files) {
  ProgramFiles all;
  all.reads = settings.dress.fabrics.files;
  all.reads.push_back(settings.body.inputs.front());
  all.reads.push_back(skeleton_beside(settings.body.inputs.front()));
  if (settings.points.spec) all.reads.push_back(*settings.points.spec);
  all.writes = files.all();
  for (int k = 2; k <= settings.drapes; ++k) {
    std::ranges::copy(files.repeat(k).of_drape(), std::back_inserter(all.writes));
  }
  all.keeps = kept_distances_of(settings.dress.body);
  if (const auto& standing = settings.dress.standing) {
    all.reads.push_back(*standing);
    all.reads.push_back(skeleton_beside(*standing));
    std::ranges::copy(kept_distances_of(*standing), std::back_inserter(all.keeps));
  }
  return all;
}

void remove_earlier(const std::vector<fs::path>& files) {
  std::error_code failed;
  for (const fs::path& file : files) {
    fs::remove(file, failed);
    if (failed) throw Error(file.string(), "can't be replaced", failed.message());
  }
}

void check_pattern_file(const fs::path& file, const std::string& remedy) {
  std::vector<Remark> remarks;  // mesh-pattern says them
  const Pattern pattern = without_left_out(read_pattern(file, remarks), remarks);
  check_pattern(pattern, remarks);
  if (pattern.panels.size() > 1 && pattern.stitches.empty()) {
    throw Error(file.string(), "has panels and no seams", remedy);
  }
}

CommonSettings step_of(const CommonSettings& common, const char* program, const fs::path& output,
                       const fs::path& report) {
  CommonSettings step = common;
  step.program = program;
  step.start = std::chrono::steady_clock::now();
  step.output = output;
  step.report = report;
  return step;
}

CleanBodyResult fit_body(const FitSettings& settings, const FitFiles& files,
                         const CommonSettings& common) {
  if (settings.dress.standing) return {};
  common.say("Cleaning the body:");
  return run_clean_body(settings.body,
                        step_of(common, "clean-body", files.body, files.body_report));
}

namespace {

/// Drapes the garment again, each time on a coarser mesh. Those that end with the same verdict tell
/// the errors of the ease map; of the others it gets a warning.
void drape_again(const FitSettings& settings, const DressSettings& dressing, Verdict verdict,
                 const FitFiles& files, const CommonSettings& common, EaseMapSettings& ease) {
  for (int k = 2; k <= most_drapes; ++k) {
    remove_earlier(files.repeat(k).of_drape());
  }
  for (int k = 2; k <= settings.drapes; ++k) {
    common.say("Draping again, " + std::to_string(k) + " of " + std::to_string(settings.drapes) +
               ":");
    const FitFiles other = files.repeat(k);
    MeshPatternSettings pattern = settings.pattern;
    pattern.mesh.edge_length *= 1 + coarser * (k - 1) / (settings.drapes - 1);
    std::string why;
    try {
      run_mesh_pattern(pattern, step_of(common, "mesh-pattern", other.garment, other.mesh_report));
      DressSettings again = dressing;
      again.layers.front().garment = other.garment;
      again.layers.front().output = other.dressed;
      const DressEnd end = run_dress(again, step_of(common, "dress", other.dressed, other.report));
      if (end.verdict != verdict) why = std::string("it is ") + to_string(end.verdict);
    } catch (const Error& error) {
      why = error.what();
    }
    if (why.empty()) {
      ease.repeats.push_back(other.dressed);
    } else {
      const Warning warning{"repeat_left_out", "",
                            "drape " + std::to_string(k) + " tells no error: " + why};
      CommonSettings::warn(warning.text);
      ease.earlier_warnings.push_back(warning);
    }
  }
  // One other drape tells no spread.
  if (ease.repeats.size() < 2) ease.repeats.clear();
}

}  // namespace

FitEnd fit_pattern(const FitSettings& settings, const FitFiles& files, const CleanBodyResult& body,
                   const CommonSettings& common) {
  common.say("Meshing the pattern:");
  const std::vector<std::string> of_meshing = run_mesh_pattern(
      settings.pattern, step_of(common, "mesh-pattern", files.garment, files.mesh_report));
  MeasurePatternEnd measured;
  if (settings.points.spec) {
    common.say("Measuring the pattern:");
    MeasurePatternSettings points = settings.points;
    points.pattern = settings.pattern.pattern;
    points.says_remarks = false;  // meshing has said them
    measured = run_measure_pattern(
        points, step_of(common, "measure-pattern", files.points, files.points_report));
  }
  common.say("Dressing:");
  DressSettings dressing = settings.dress;
  dressing.earlier_warnings = warnings_of("body", body.warnings);
  std::ranges::move(warnings_of("pattern", of_meshing),
                    std::back_inserter(dressing.earlier_warnings));
  if (measured.off_spec) {
    dressing.earlier_warnings.push_back({"out_of_spec", "", *measured.off_spec});
  }
  const DressEnd end = run_dress(dressing, step_of(common, "dress", files.dressed, files.report));
  EaseMapSettings ease;
  drape_again(settings, dressing, end.verdict, files, common, ease);
  common.say("Measuring the ease:");
  ease.garment = files.dressed;
  ease.garment_name = settings.pattern.pattern.stem().string();
  ease.points = std::move(measured.points);
  ease.size = settings.points.size;
  ease.body_name = settings.body.inputs.front().stem().string();
  ease.dress_report = files.report;
  ease.meshed = files.garment;
  ease.body = settings.dress.body;
  ease.targets = settings.targets;
  ease.glb = files.dressed_glb;
  ease.body_obj = files.body_obj;
  if (settings.pictures) ease.png = files.ease_picture;
  if (settings.pdf) ease.pdf = files.ease_pdf;
  run_ease_map(ease, step_of(common, "ease-map", files.ease, files.ease_report));
  if (settings.pictures) {
    RenderSettings render;
    render.body = settings.dress.body.string();
    render.garments = {files.dressed.string()};
    CommonSettings drawing = common;
    drawing.output = files.drape_picture;
    run_render(render, drawing);
  }
  return {end, body.is_usable, !measured.off_spec};
}

ExitCode exit_code_of(const FitEnd& end) {
  return end.body_is_usable && end.keeps_spec ? exit_code_of(end.dress) : exit_negative;
}

}  // namespace toile
