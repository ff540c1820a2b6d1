// dress: sews meshed garments around a body, one over another, and lets them come to rest.
#include "tools/dress/run.h"
#include "tools/dress/settings.h"
#include "tools/programs.h"

namespace toile {

namespace {

Job prepare(const boost::program_options::variables_map& given, const CommonSettings& common) {
  const DressSettings settings = read_dress_settings(given, common.output);
  return {files_of(settings),
          [settings, &common] { return exit_code_of(run_dress(settings, common)); }};
}

}  // namespace

CommandLineProgram dress_program() {
  CommandLineProgram program;
  program.name = "dress";
  program.summary = "sews meshed garments around a body and lets them come to rest";
  program.usage =
      "--body body.ply garment.obj -o dressed.obj [options]\n"
      "       dress --scene outfit.json -o outfit.obj [options]";
  add_dress_options(program.options);
  program.positional.add("garment", 1);
  program.output_extensions = {".obj"};
  program.check = check_dress_options;
  program.prepare = prepare;
  return program;
}

}  // namespace toile
