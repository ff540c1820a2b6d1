// dress: sews meshed garments around a body, one over another, and lets them come to rest.
#include "tools/dress/run.h"
#include "tools/dress/settings.h"
#include "tools/programs.h"

namespace toile {

namespace {

int work(const boost::program_options::variables_map& given, const CommonSettings& common) {
  const Verdict verdict = run_dress(read_dress_settings(given, common.output), common);
  return exit_code_of(verdict);
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
  program.work = work;
  return program;
}

}  // namespace toile
