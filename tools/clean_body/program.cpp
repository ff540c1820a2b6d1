// clean-body: a scan or mesh of a person becomes a closed body in metres, with its skeleton.
#include "geometry/error.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "tools/clean_body/run.h"
#include "tools/programs.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

/// Whether the joints beside the input came with it. Where the output would have the same joints
/// and is there, they are what an earlier run wrote with it.
bool has_own_joints(const fs::path& input, const fs::path& output) {
  const fs::path joints = skeleton_path(input);
  std::error_code unreachable;
  if (!fs::exists(joints, unreachable)) return false;
  return !fs::exists(output, unreachable) || !same_file(joints, skeleton_path(output));
}

using FileNames = std::vector<std::string>;

std::optional<AxisDirection> read_direction(const po::variables_map& given, const char* option) {
  if (given.count(option) == 0) return std::nullopt;
  const std::optional<AxisDirection> direction = axis_direction(given[option].as<std::string>());
  if (!direction) {
    throw po::error("--" + std::string(option) + " is one of x, -x, y, -y, z, -z");
  }
  return direction;
}

std::vector<fs::path> read_paths(const po::variables_map& given, const char* option) {
  if (given.count(option) == 0) return {};
  const FileNames texts = given[option].as<FileNames>();
  return {texts.begin(), texts.end()};
}

void check_options(const po::variables_map& given) {
  const auto up = read_direction(given, "up");
  const auto front = read_direction(given, "front");
  if (up && front && up->axis == front->axis) {
    throw po::error("--up and --front are along the same axis");
  }
  const std::size_t poses = read_paths(given, "pose").size();
  if (poses > 0 && poses != read_paths(given, "input").size()) {
    throw po::error("--pose is given for each input, or for none");
  }
}

double read_scan_edge(const std::string& text) {
  const double edge = parse_length(text, "--edge-length");
  if (edge < 0.003 || edge > 0.02) {
    throw Error("--edge-length", "'" + text + "' is out of range", "use 3mm to 20mm");
  }
  return edge;
}

}  // namespace

CommandLineProgram clean_body_program() {
  CommandLineProgram program;
  program.name = "clean-body";
  program.summary =
      "makes a mesh or scan of a standing person a closed body in metres, with its skeleton";
  program.usage = "IN... -o body.ply [--unit m|dm|cm|mm|in] [--up AXIS] [--front AXIS]";
  program.options.add_options()(
      "input", po::value<FileNames>()->required(),
      "the mesh to read: .obj, .ply, .stl or .off; or the points of a scan: .ply, .obj, .off, "
      ".xyz, .pts, .asc, .txt or .csv; several files are one scan");
  add_unit_option(program.options);
  program.options.add_options()(
      "up", po::value<std::string>(),
      "to where the body stands in the file: x, y, z, or --up=-z; found when not given")(
      "front", po::value<std::string>(), "to where it faces in the file; found when not given")(
      "points", po::bool_switch(), "take a mesh's points as a scan and ignore its faces")(
      "pose", po::value<FileNames>()->composing(),
      "four rows of four numbers that bring a scan's file to the frame of all; once for each "
      "file, in their order")("edge-length", po::value<std::string>(),
                              "of a scan's surface, about: 3mm to 20mm, 7mm when not given");
  program.positional.add("input", -1);
  program.check = check_options;
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    CleanBodySettings settings;
    settings.inputs = read_paths(given, "input");
    settings.metres_per_unit = read_unit(given);
    settings.poses = read_paths(given, "pose");
    settings.as_points = given["points"].as<bool>();
    settings.up = read_direction(given, "up");
    settings.front = read_direction(given, "front");
    if (given.count("edge-length") > 0) {
      settings.edge_length = read_scan_edge(given["edge-length"].as<std::string>());
    }
    check_mesh_extension(common.output);
    Job job;
    job.files.reads = settings.inputs;
    job.files.reads.insert(job.files.reads.end(), settings.poses.begin(), settings.poses.end());
    if (has_own_joints(settings.inputs.front(), common.output)) {
      job.files.reads.push_back(skeleton_path(settings.inputs.front()));
    }
    job.files.writes = {common.output, skeleton_path(common.output)};
    job.work = [settings, &common] {
      run_clean_body(settings, common);
      return exit_done;
    };
    return job;
  };
  return program;
}

}  // namespace toile
