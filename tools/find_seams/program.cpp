// find-seams: from panels without seams to a pattern that is sewn together.
#include "geometry/error.h"
#include "pattern/seams/find_seams.h"
#include "tools/find_seams/run.h"
#include "tools/programs.h"

namespace toile {

namespace po = boost::program_options;

namespace {

std::vector<std::string> texts_of(const po::variables_map& given, const char* option) {
  return given.count(option) > 0 ? given[option].as<std::vector<std::string>>()
                                 : std::vector<std::string>{};
}

}  // namespace

void add_seam_options(po::options_description& options) {
  options.add_options()("sew", po::value<std::vector<std::string>>()->composing(),
                        "sew these two edges, \"PANEL:EDGE PANEL:EDGE\"; may be given again")(
      "with", po::value<std::vector<std::string>>()->composing(),
      "take in this panel, a pocket, say; `all`: every one; may be given again")(
      "min-confidence", po::value<double>()->default_value(decided_confidence, "0.7"),
      "0 to 1: a less certain seam is listed as undecided and not sewn")(
      "time-limit", po::value<double>(),
      "seconds after which the best seams so far are taken; they are less certain");
}

void read_seam_options(const po::variables_map& given, FindSeamsSettings& settings) {
  settings.sewn = texts_of(given, "sew");
  settings.with = texts_of(given, "with");
  settings.min_confidence = given["min-confidence"].as<double>();
  if (!(settings.min_confidence >= 0 && settings.min_confidence <= 1)) {
    throw UsageError("--min-confidence", "is not between 0 and 1", "0.7 is the default");
  }
  if (given.count("time-limit") == 0) return;
  settings.time_limit = given["time-limit"].as<double>();
  if (!(settings.time_limit > 0)) {
    throw UsageError("--time-limit", "is not above 0 seconds", "leave it out for no limit");
  }
}

CommandLineProgram find_seams_program() {
  CommandLineProgram program;
  program.name = "find-seams";
  program.summary = "finds which edges of a pattern's panels are sewn together";
  program.usage = "PATTERN.json -o sewn.json [--report seams.json] [--sew \"front:3 back:1\"]";
  program.options.add_options()("keep", po::bool_switch(),
                                "keep the stitches that the pattern has, and find the others");
  add_seam_options(program.options);
  program.options.add_options()("without", po::value<std::vector<std::string>>()->composing(),
                                "leave out this panel; may be given again")(
      "use-places", po::bool_switch(),
      "let the placed panels decide which of equal panels is sewn where")(
      "pattern", po::value<std::string>()->required(), "the pattern; also as argument");
  program.positional.add("pattern", 1);
  program.output_extensions = {".json"};
  program.check = [](const po::variables_map& given) {
    if (given["use-places"].as<bool>() && (given["keep"].as<bool>() || given.count("sew") != 0)) {
      throw po::error("--use-places has nothing to decide where seams are given: --keep, --sew");
    }
  };
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    FindSeamsSettings settings;
    settings.pattern = given["pattern"].as<std::string>();
    settings.keep = given["keep"].as<bool>();
    settings.by_place = given["use-places"].as<bool>();
    read_seam_options(given, settings);
    settings.without = texts_of(given, "without");
    Job job;
    job.files.reads = {settings.pattern};
    job.files.writes = {common.output};
    job.work = [settings, &common] {
      return run_find_seams(settings, common).undecided.empty() ? exit_done : exit_negative;
    };
    return job;
  };
  return program;
}

}  // namespace toile
