// toile fit: from a body and a pattern to the verdict, all in one process.
#include <iostream>

#include "pattern/import/half_pieces.h"
#include "tools/fit/chain.h"
#include "tools/programs.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

ExitCode fit(const FitSettings& settings, const FitFiles& files, const CommonSettings& common) {
  const fs::path& pattern = settings.pattern.pattern;
  check_pattern_file(
      pattern, "find them: toile find-seams " + shell_word(pattern.string()) + " -o sewn.json");
  remove_earlier(files.all());
  const FitEnd end = fit_pattern(settings, files, fit_body(settings, files, common), common);
  std::cout << to_string(end.dress.verdict) << (end.keeps_spec ? "" : ", out of spec") << ": see "
            << files.ease.string() << " and " << files.report.string() << std::endl;
  return exit_code_of(end);
}

Job prepare_fit(const po::variables_map& given, const CommonSettings& common) {
  const FitFiles files(common.output);
  FitSettings settings;
  const fs::path body = given["body"].as<std::string>();
  for (const char* option : {"unit", "height", "up", "front", "points"}) {
    if (given.count("from") == 0 || given[option].empty() || given[option].defaulted()) continue;
    throw UsageError("--" + std::string(option), "is for a body that is cleaned",
                     "leave it out: with --from the body is taken as pose-body wrote it");
  }
  read_body_options(given, settings.body);
  read_fit_options(given, body, files, settings);
  settings.pattern.pattern = given["pattern"].as<std::string>();
  Job job;
  job.files = files_of(settings, files);
  job.files.reads.push_back(settings.pattern.pattern);
  job.work = [settings, files, &common] { return fit(settings, files, common); };
  return job;
}

}  // namespace

CommandLineProgram fit_program() {
  CommandLineProgram program;
  program.name = "toile fit";
  program.summary =
      "dresses a body with a pattern, from both files to the ease map and the verdict";
  program.usage = "--body BODY PATTERN.json -o OUT/ [options]";
  program.options.add_options()("body", po::value<std::string>()->required(),
                                "a mesh or scan of a standing person; with --from, a posed body")(
      "pattern", po::value<std::string>()->required(), "the sewing pattern; also as argument");
  add_body_options(program.options);
  add_fit_options(program.options);
  program.positional.add("pattern", 1);
  program.writes_folder = true;
  program.check = [](const po::variables_map& given) {
    CleanBodySettings unused;
    read_body_options(given, unused);
    check_method_options(given);
    check_pom_options(given);
  };
  program.prepare = prepare_fit;
  return program;
}

}  // namespace toile
