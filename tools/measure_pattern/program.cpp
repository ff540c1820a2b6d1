// measure-pattern: points of measure of the flat garment, beside a specification.
#include "tools/measure_pattern/run.h"
#include "tools/programs.h"

namespace toile {

namespace po = boost::program_options;

CommandLineProgram measure_pattern_program() {
  CommandLineProgram program;
  program.name = "measure-pattern";
  program.summary = "takes a garment's points of measure from its flat panels, beside a spec";
  program.usage = "PATTERN.json -o pom.csv [--pom spec.csv] [options]";
  program.options.add_options()("pattern", po::value<std::string>()->required(),
                                "the pattern; also as argument");
  add_pom_options(program.options);
  program.positional.add("pattern", 1);
  program.output_extensions = {".csv"};
  program.check = [](const boost::program_options::variables_map& given) {
    check_pom_options(given);
  };
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    MeasurePatternSettings settings;
    settings.pattern = given["pattern"].as<std::string>();
    read_pom_options(given, settings);
    Job job;
    job.files.reads = {settings.pattern};
    if (settings.spec) job.files.reads.push_back(*settings.spec);
    job.files.writes = {common.output};
    job.work = [settings, &common] {
      return run_measure_pattern(settings, common).off_spec ? exit_negative : exit_done;
    };
    return job;
  };
  return program;
}

}  // namespace toile
