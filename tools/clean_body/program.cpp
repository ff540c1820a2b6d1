// clean-body: a scan or mesh of a person becomes a closed body in metres, with its skeleton.
#include "tools/clean_body/run.h"
#include "tools/programs.h"

namespace toile {

namespace po = boost::program_options;

CommandLineProgram clean_body_program() {
  CommandLineProgram program;
  program.name = "clean-body";
  program.summary = "makes a mesh of a standing person a closed body in metres, with its skeleton";
  program.usage = "IN -o body.ply [--unit m|dm|cm|mm|in]";
  program.options.add_options()("input", po::value<std::string>()->required(),
                                "the mesh to read: .obj, .ply, .stl or .off");
  add_unit_option(program.options);
  program.positional.add("input", 1);
  program.work = [](const po::variables_map& given, const CommonSettings& common) {
    run_clean_body({given["input"].as<std::string>(), read_unit(given)}, common);
    return exit_done;
  };
  return program;
}

}  // namespace toile
