// dress: sews a meshed garment around a body and lets it come to rest.

#include "cloth/dress.h"

#include <unistd.h>

#include <boost/timer/progress_display.hpp>
#include <chrono>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cloth/judge.h"
#include "geometry/body/skeleton.h"
#include "geometry/error.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "pattern/garment_file.h"
#include "tools/closed_body.h"
#include "tools/program.h"

namespace toile {

namespace {

namespace po = boost::program_options;
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Strain (99th percentile, off the seams) that no woven is worn at.
constexpr double suspicious_strain = 0.1;

struct Settings {
  fs::path garment;
  fs::path garment_json;
  fs::path body;
  fs::path skeleton;
  std::optional<fs::path> frames;
  Fabric fabric;
  std::optional<double> strain_limit;
  DressOptions options;
};

Settings read_settings(const po::variables_map& given) {
  Settings settings;
  settings.garment = given["garment"].as<std::string>();
  settings.body = given["body"].as<std::string>();
  if (given.count("garment-json")) settings.garment_json = given["garment-json"].as<std::string>();
  settings.skeleton = given.count("skeleton") ? fs::path(given["skeleton"].as<std::string>())
                                              : skeleton_path(settings.body);
  if (given.count("frames")) settings.frames = given["frames"].as<std::string>();
  settings.fabric = find_fabric(given["fabric"].as<std::string>());
  if (given.count("strain-limit")) {
    const double limit = given["strain-limit"].as<double>();
    if (!(limit >= 0 && limit < 1)) {
      throw Error("--strain-limit", "is not a fraction", "0.01 holds warp and weft near 1 %");
    }
    settings.strain_limit = limit;
  }
  const double residual = given["residual"].as<double>();
  if (!(residual > 0 && residual < 1)) {
    throw Error("--residual", "is not between 0 and 1", "0.05 is the default");
  }
  settings.options.stop_median = residual;
  settings.options.stop_rms = 10 * residual;
  return settings;
}

/// Drives the progress bar, and writes the states on the way as OBJ files.
class Watch {
 public:
  Watch(const std::optional<fs::path>& folder, bool show_progress) : folder_(folder) {
    if (folder_) {
      std::error_code failed;
      fs::create_directories(*folder_, failed);
      if (failed) throw Error(folder_->string(), "can't hold frames", failed.message());
    }
    if (show_progress) bar_.emplace(100, std::cerr, "", "", "");
  }

  ~Watch() {
    if (bar_) *bar_ += 100 - bar_->count();
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  void operator()(const DressFrame& frame) {
    if (bar_) {
      const auto percent = static_cast<unsigned long>(100 * frame.progress);
      if (percent > bar_->count()) *bar_ += percent - bar_->count();
    }
    if (!folder_) return;
    std::ostringstream name;
    name << std::setw(4) << std::setfill('0') << count_++ << '-' << frame.stage << ".obj";
    write_dressed(*folder_ / name.str(),
                  as_dressed(frame.mesh, frame.points, frame.mesh.triangles));
  }

 private:
  std::optional<fs::path> folder_;
  std::optional<boost::timer::progress_display> bar_;
  int count_ = 0;
};

Json strain_json(const StrainFigures& strain) {
  return {{"max", strain.max}, {"p99", strain.p99}, {"rms", strain.rms}};
}

Json residual_json(const Residual& residual) {
  return {{"median", residual.median}, {"rms", residual.rms}, {"max", residual.max}};
}

Json report_of(const PanelMesh& garment, const std::string& fabric, const DressResult& result,
               const Judgement& judgement, double seconds) {
  const GarmentFigures& figures = judgement.garment;
  Json report;
  report["garment"] = {{"vertices", result.nodes.size()},
                       {"material_points", garment.flat.size()},
                       {"triangles", garment.triangles.size()},
                       {"panels", garment.panels.size()},
                       {"seams", garment.seams.size()}};
  for (const auto& [term, count] : result.terms) {
    report["scene"]["terms"][term] = count;
  }
  report["scene"]["fabric"] = fabric;
  report["scene"]["body_offset_mm"] = 1000 * result.body_offset;
  report["scene"]["points_inside_at_start"] = result.placement.points_inside;
  report["scene"]["seam_pairs_inside_at_start"] = result.placement.seams_inside;
  report["scene"]["lift_mm"] = 1000 * result.placement.lift;
  for (const auto& [part, distance] : result.placement.drawn_out) {
    report["scene"]["drawn_out_mm"][part] = 1000 * distance;
  }
  for (const PositionedPanel& panel : result.placement.positioned) {
    Json json = {{"panel", panel.panel}, {"rolled", panel.rolled}};
    json[panel.rolled ? "radius_mm" : "distance_mm"] = 1000 * panel.distance;
    if (panel.rolled) {
      json["gap_mm"] = 1000 * panel.gap;
      json["drawn_out_mm"] = 1000 * panel.drawn_out;
      json["points_too_near"] = panel.points_too_near;
    }
    report["scene"]["positioned"].push_back(json);
  }
  report["method"] = "relaxation";
  for (const StageReport& stage : result.stages) {
    report["stages"].push_back({{"name", stage.name},
                                {"attempt", stage.attempt},
                                {"open", stage.open},
                                {"vertices", stage.vertices},
                                {"steps", stage.steps},
                                {"searches", stage.searches},
                                {"seconds", stage.seconds},
                                {"converged", stage.converged},
                                {"residual", residual_json(stage.residual)}});
  }
  report["seconds"] = seconds;
  report["converged"] = result.converged;
  report["residual"] = residual_json(result.residual);
  report["strain"] = strain_json(figures.strain);
  report["strain_off_seams"] = strain_json(figures.strain_off_seams);
  report["area_change_percent"] = {{"total", figures.area_total_percent},
                                   {"max_panel", figures.area_max_panel_percent},
                                   {"max_during", result.during.area_percent}};
  report["perimeter_change_percent"] = {
      {"max_panel", figures.perimeter_max_panel_percent},
      {"max_during", result.during.perimeter_percent},
      {"triangles_max_panel", figures.triangle_perimeter_max_panel_percent}};
  report["seams"] = {{"sewn", figures.seams.sewn},
                     {"open", figures.seams.open},
                     {"max_gap_mm", figures.seams.max_gap_mm}};
  report["wraps"] = Json::array();
  for (const WrapFigure& wrap : judgement.wraps) {
    report["wraps"].push_back({{"part", wrap.part},
                               {"fraction", wrap.fraction},
                               {"from_m", wrap.from},
                               {"to_m", wrap.to}});
  }
  report["borders"] = figures.borders;
  report["intersections"] = {{"body", judgement.body_intersections},
                             {"self", judgement.self_intersections},
                             {"check", "exact"}};
  report["verdict"] = judgement.verdict;
  for (const OpenSeam& seam : figures.seams.open_seams) {
    report["unsewable_seams"].push_back({{"name", seam.name}, {"missing_cm", seam.missing_cm}});
  }
  return report;
}

void say_terms(const DressResult& result, const CommonSettings& common) {
  std::string line = "terms:";
  for (const auto& [term, count] : result.terms) {
    line += " " + term + " " + std::to_string(count) + ",";
  }
  line.back() = '.';
  common.say(line);
}

void say_positions(const Placement& placement, const CommonSettings& common) {
  for (const PositionedPanel& panel : placement.positioned) {
    std::ostringstream line;
    line << std::fixed << std::setprecision(1) << "panel " << panel.panel;
    if (panel.rolled) {
      line << " is rolled, radius " << 100 * panel.distance << " cm, gap " << 100 * panel.gap
           << " cm";
    } else {
      line << " stands " << 100 * panel.distance << " cm from the bones";
    }
    common.say(line.str());
  }
}

std::string percent(double fraction) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << 100 * fraction << " %";
  return text.str();
}

void say_result(const DressResult& result, const Judgement& judgement,
                const CommonSettings& common) {
  const GarmentFigures& figures = judgement.garment;
  std::ostringstream residual;
  residual << std::setprecision(2) << result.residual.median << " median, " << result.residual.rms
           << " rms";
  common.say("seams: " + std::to_string(figures.seams.sewn) + " sewn, " +
             std::to_string(figures.seams.open) +
             " open; intersections: " + std::to_string(judgement.body_intersections) +
             " with the body, " + std::to_string(judgement.self_intersections) + " with itself");
  common.say("strain off the seams: " + percent(figures.strain_off_seams.p99) +
             " (99th percentile); residual in node weights: " + residual.str());
  for (const WrapFigure& wrap : judgement.wraps) {
    common.say("wraps " + wrap.part + ": " + percent(wrap.fraction));
  }
  if (result.placement.points_inside > 0) {
    CommonSettings::warn(
        std::to_string(result.placement.points_inside) +
        " points of the panels start inside the body: place the panels clear of it");
  }
  if (figures.strain_off_seams.p99 > suspicious_strain) {
    CommonSettings::warn("the cloth is strained by " + percent(figures.strain_off_seams.p99) +
                         " in places: the garment is too small for this body, or caught on it");
  }
  common.say("verdict: " + judgement.verdict);
}

int work(const po::variables_map& given, const CommonSettings& common) {
  const auto start = Clock::now();
  const Settings settings = read_settings(given);
  PanelMesh garment = read_garment(settings.garment, settings.garment_json);
  const TriangleMesh body = read_closed_body(settings.body);
  std::optional<Skeleton> skeleton;
  if (fs::exists(settings.skeleton) || given.count("skeleton")) {
    skeleton = read_skeleton(settings.skeleton);
  } else {
    CommonSettings::warn(
        settings.skeleton.string() +
        " is missing: what the garment wraps is not measured; clean-body makes it");
  }
  const double read_seconds = seconds_since(start);

  const auto grid_start = Clock::now();
  const DistanceGrid grid{BodyDistance(body)};
  const double grid_seconds = seconds_since(grid_start);

  // What is judged needs to know where the panels stood as much as what is dressed.
  garment.placed = position_panels(garment, grid, skeleton ? &*skeleton : nullptr).placed;

  Scene scene;
  scene.fabric = settings.fabric;
  scene.body = &grid;
  scene.skeleton = skeleton ? &*skeleton : nullptr;
  scene.strain_limit = settings.strain_limit;
  const DressResult result = [&] {
    Watch watch(settings.frames, !common.quiet && isatty(STDERR_FILENO) != 0);
    return dress(garment, scene, settings.options, [&](const DressFrame& frame) { watch(frame); });
  }();
  say_positions(result.placement, common);
  say_terms(result, common);

  const auto judge_start = Clock::now();
  write_dressed(common.output, as_dressed(garment, result.nodes, result.triangles));
  // Judged as anybody will read it, not as it is in memory.
  const Judgement judgement = judge(garment, read_dressed(common.output), body,
                                    skeleton ? &*skeleton : nullptr, result.converged);
  Json report = report_of(garment, settings.fabric.name, result, judgement, seconds_since(start));
  report["other_seconds"] = {{"read", read_seconds},
                             {"body_grid", grid_seconds},
                             {"write_and_judge", seconds_since(judge_start)}};
  if (common.report) write_file(*common.report, report.dump(2) + "\n");
  say_result(result, judgement, common);
  return judgement.verdict == "sewn" ? exit_done : exit_negative;
}

}  // namespace

}  // namespace toile

int main(int argc, char** argv) {
  using boost::program_options::value;
  using std::string;
  toile::CommandLineProgram program;
  program.name = "dress";
  program.summary = "sews a meshed garment around a body and lets it come to rest";
  program.usage = "--body body.ply garment.obj -o dressed.obj [options]";
  program.options.add_options()("body", value<string>()->required(),
                                "the body, as clean-body writes it")(
      "garment", value<string>()->required(), "the garment, as mesh-pattern writes it")(
      "garment-json", value<string>(), "its panels and seams; default: garment.json beside it")(
      "skeleton", value<string>(), "the body's joints; default: body.json beside the body")(
      "fabric", value<string>()->default_value("default"),
      "a fabric's name, or a JSON file with its quantities")(
      "strain-limit", value<double>(),
      "stiffen warp and weft beyond this strain, a fraction: 0.01 is 1 %")(
      "residual", value<double>()->default_value(0.05, "0.05"),
      "at rest when half of the nodes have less force left than this share of a node's weight, and "
      "their rms is below ten times it")(
      "frames", value<string>(), "write the states on the way as OBJ files into this folder");
  program.positional.add("garment", 1);
  program.work = toile::work;
  return toile::run_program(argc, argv, program);
}
