// pose-body: brings a standing body into a pose, with its joints.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "cloth/scene/closed_body.h"
#include "geometry/body/flaws.h"
#include "geometry/body/limb_girths.h"
#include "geometry/body/pose_body.h"
#include "geometry/error.h"
#include "geometry/surface_distance.h"
#include "io/floor_height.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "io/text.h"
#include "tools/pose_option.h"
#include "tools/programs.h"
#include "tools/report.h"

namespace toile {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;
using Json = nlohmann::ordered_json;

struct PoseBodySettings {
  fs::path body;
  fs::path skeleton;
  std::string pose;
};

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

Json report_json(const PoseBodySettings& settings, const PosedBody& posed,
                 const std::vector<LimbGirth>& girths, const std::vector<std::string>& warnings) {
  double height = 0;
  for (const Vec3& point : posed.surface.points) height = std::max(height, point.y());
  Json limbs = Json::object();
  for (const LimbGirth& girth : girths) {
    limbs[girth.name] = {{"standing_cm", 100 * girth.standing}, {"posed_cm", 100 * girth.posed}};
  }
  return {{"read", {{"file", valid_utf8(settings.body.string())}}},
          {"pose", valid_utf8(settings.pose)},
          {"body",
           {{"points", posed.surface.points.size()},
            {"triangles", posed.surface.triangles.size()},
            {"height_m", height}}},
          {"self_intersections",
           {{"found", posed.crossings.pairs_before},
            {"left", posed.crossings.pairs_left},
            {"largest_move_mm", 1000 * posed.crossings.largest_move}}},
          {"girths", limbs},
          {"warnings", warnings_json(warnings_of("body", warnings))}};
}

std::string crossing_warning(const Crossings& crossings) {
  std::string part = name_of(crossings.part);
  std::replace(part.begin(), part.end(), '_', ' ');
  return "the pose folds the body into itself: " + std::to_string(crossings.pairs) +
         (crossings.pairs == 1 ? " pair" : " pairs") + " of triangles cross, " +
         floor_heights(crossings.low, crossings.high) +
         (part.empty() ? "" : ", most at the " + part) + "; move the limbs apart";
}

int run_pose_body(const PoseBodySettings& settings, const CommonSettings& common) {
  if (!is_skeleton_file(settings.skeleton)) {
    throw Error(settings.skeleton.string(), "holds no joints, without which no body can be posed",
                "let clean-body write them, or name them with --skeleton");
  }
  const Pose pose = pose_of(settings.pose, PosedFigure::body);
  const TriangleMesh body = read_closed_body(settings.body);
  double low = std::numeric_limits<double>::max();
  for (const Vec3& point : body.points) low = std::min(low, point.y());
  if (std::abs(low) > 0.02) {
    throw Error(settings.body.string(), "does not stand on y = 0", "let clean-body put it there");
  }
  const Skeleton skeleton = read_skeleton_of(SurfaceDistance(body), settings.skeleton);
  const PosedBody posed = pose_body(body, skeleton, pose, settings.body.string());

  std::vector<std::string> warnings;
  if (posed.crossings.pairs_left > 0) {
    const auto crossings = crossings_of(posed.surface, posed.skeleton);
    if (crossings) warnings.push_back(crossing_warning(*crossings));
  } else if (posed.crossings.pairs_before > 0) {
    common.say(formatted("creases opened, by up to %.0f mm", 1000 * posed.crossings.largest_move));
  }
  std::vector<LimbGirth> girths;
  if (common.report) {
    girths = limb_girths(body, skeleton, posed.surface, posed.skeleton);
  }
  for (const std::string& warning : warnings) CommonSettings::warn(warning);

  OutputFiles files;
  write_mesh(files.at(common.output), posed.surface);
  write_skeleton(files.at(skeleton_path(common.output)), posed.skeleton);
  write_report(files, common, report_json(settings, posed, girths, warnings));
  files.commit();
  return posed.crossings.pairs_left > 0 ? exit_negative : exit_done;
}

Job prepare_pose_body(const po::variables_map& given, const CommonSettings& common) {
  PoseBodySettings settings;
  settings.body = given["body"].as<std::string>();
  settings.pose = given["pose"].as<std::string>();
  settings.skeleton = given.count("skeleton") > 0 ? fs::path(given["skeleton"].as<std::string>())
                                                  : skeleton_beside(settings.body);
  check_mesh_extension(common.output);
  Job job;
  job.files.reads = {settings.body, settings.skeleton};
  if (is_pose_file(settings.pose)) job.files.reads.emplace_back(settings.pose);
  job.files.writes = {common.output, skeleton_path(common.output)};
  job.work = [settings, &common] { return run_pose_body(settings, common); };
  return job;
}

}  // namespace

CommandLineProgram pose_body_program() {
  CommandLineProgram program;
  program.name = "pose-body";
  program.summary = "brings a standing body into a pose, with its joints";
  program.usage =
      "body.ply --pose standing|walking|sitting|reaching|FILE.json -o posed.ply [options]";
  program.options.add_options()("body", po::value<std::string>()->required(),
                                "the standing body, as clean-body writes it")(
      "pose", po::value<std::string>()->required(),
      "standing, walking, sitting, reaching, or a file that gives joints' angles")(
      "skeleton", po::value<std::string>(),
      "the body's joints; body.body.json beside it when not given");
  program.positional.add("body", 1);
  program.prepare = prepare_pose_body;
  return program;
}

}  // namespace toile
