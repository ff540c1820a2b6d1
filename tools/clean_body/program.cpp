// clean-body: a scan or mesh of a person becomes a closed body in metres, with its skeleton.
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

}  // namespace

CommandLineProgram clean_body_program() {
  CommandLineProgram program;
  program.name = "clean-body";
  program.summary = "makes a mesh of a standing person a closed body in metres, with its skeleton";
  program.usage = "IN -o body.ply [--unit m|dm|cm|mm|in]";
  program.options.add_options()("input", po::value<std::string>()->required(),
                                "the mesh to read: .obj, .ply, .stl or .off");
  add_unit_option(program.options);
  program.positional.add("input", 1);
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    const CleanBodySettings settings{given["input"].as<std::string>(), read_unit(given)};
    check_mesh_extension(common.output);
    Job job;
    job.files.reads = {settings.input};
    if (has_own_joints(settings.input, common.output)) {
      job.files.reads.push_back(skeleton_path(settings.input));
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
