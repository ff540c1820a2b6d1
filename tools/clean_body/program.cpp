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
  const fs::path joints = skeleton_beside(input);
  std::error_code unreachable;
  if (!fs::exists(joints, unreachable)) return false;
  return !fs::exists(output, unreachable) || !same_file(joints, skeleton_path(output));
}

using FileNames = std::vector<std::string>;

std::vector<fs::path> read_paths(const po::variables_map& given, const char* option) {
  if (given.count(option) == 0) return {};
  const FileNames texts = given[option].as<FileNames>();
  return {texts.begin(), texts.end()};
}

void check_options(const po::variables_map& given) {
  CleanBodySettings unused;
  read_body_options(given, unused);
  const std::size_t poses = read_paths(given, "pose").size();
  if (poses > 0 && poses != read_paths(given, "input").size()) {
    throw po::error("--pose is given for each input, or for none");
  }
}

double read_scan_edge(const std::string& text) {
  const double edge = parse_length(text, "--edge-length");
  if (edge < 0.003 || edge > 0.02) {
    throw UsageError("--edge-length", "'" + text + "' is out of range", "use 3mm to 20mm");
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
  add_body_options(program.options);
  program.options.add_options()(
      "pose", po::value<FileNames>()->composing(),
      "a file of a 4 by 4 matrix that moves a scan into the common frame; once for each scan, in "
      "their order")("edge-length", po::value<std::string>(),
                     "of a scan's surface, about: 3mm to 20mm, 7mm when not given");
  program.positional.add("input", -1);
  program.check = check_options;
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    CleanBodySettings settings;
    settings.inputs = read_paths(given, "input");
    read_body_options(given, settings);
    settings.poses = read_paths(given, "pose");
    if (given.count("edge-length") > 0) {
      settings.edge_length = read_scan_edge(given["edge-length"].as<std::string>());
    }
    check_mesh_extension(common.output);
    Job job;
    job.files.reads = settings.inputs;
    job.files.reads.insert(job.files.reads.end(), settings.poses.begin(), settings.poses.end());
    if (has_own_joints(settings.inputs.front(), common.output)) {
      job.files.reads.push_back(skeleton_beside(settings.inputs.front()));
    }
    job.files.writes = {common.output, skeleton_path(common.output)};
    job.work = [settings, &common] {
      return run_clean_body(settings, common).is_usable ? exit_done : exit_negative;
    };
    return job;
  };
  return program;
}

}  // namespace toile
