// toile batch: many garments, one table.
#include <algorithm>
#include <thread>

#include "geometry/error.h"
#include "tools/batch/files.h"
#include "tools/batch/run.h"
#include "tools/mesh_pattern/run.h"
#include "tools/programs.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

int cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

Job prepare(const po::variables_map& given, const CommonSettings& common) {
  BatchSettings settings;
  const fs::path garments = given["manifest"].as<std::string>();
  BatchDefaults defaults;
  if (given.count("body") != 0) defaults.body = given["body"].as<std::string>();
  read_edge_length(given);
  defaults.edge_length = given["edge-length"].as<std::string>();
  if (given.count("fabric") != 0) defaults.fabric = given["fabric"].as<std::string>();
  if (given.count("options") != 0) defaults.options = given["options"].as<std::string>();
  std::error_code unreachable;
  settings.batch = fs::is_directory(garments, unreachable) ? batch_of_folder(garments, defaults)
                                                           : read_manifest(garments, defaults);
  settings.output = common.output;
  const int jobs = given.count("jobs") != 0 ? given["jobs"].as<int>() : cores();
  settings.jobs = static_cast<std::size_t>(jobs);
  settings.limits.threads = common.threads > 0 ? common.threads : std::max(1, cores() / jobs);
  if (given.count("timeout") != 0) {
    settings.limits.seconds = parse_time(given["timeout"].as<std::string>(), "--timeout");
  }
  if (given.count("memory") != 0) {
    settings.limits.memory = parse_memory(given["memory"].as<std::string>(), "--memory");
    constexpr std::uint64_t min_memory = 100'000'000;  // bytes; 60 MB do not even load a program
    if (*settings.limits.memory < min_memory) {
      throw UsageError("--memory", "is less than a program needs to start", "give 100MB or more");
    }
  }
  settings.limits.pictures = !given["no-pictures"].as<bool>();
  settings.resume = given["resume"].as<bool>();
  refuse_inputs_in(settings);
  const BatchFiles files(settings.output);
  Job job;
  job.files.reads = {garments};
  job.files.writes = {files.results, files.sheet, files.summary};
  job.work = [settings, &common] { return run_batch(settings, common); };
  return job;
}

}  // namespace

CommandLineProgram batch_program() {
  CommandLineProgram program;
  program.name = "toile batch";
  program.summary = "dresses many garments and writes one table and one page of pictures";
  program.usage =
      "MANIFEST.csv -o OUT/ [options]\n"
      "       toile batch --body BODY FOLDER -o OUT/ [options]";
  program.options.add_options()(
      "manifest", po::value<std::string>()->required(),
      "a table with the column pattern, and if wanted name, body, edge_length, fabric and options; "
      "or a folder of patterns; also as argument")(
      "body", po::value<std::string>(),
      "a mesh or scan of a standing person, for garments that name none");
  add_edge_length_option(program.options);
  program.options.add_options()(
      "fabric", po::value<std::string>(),
      "of garments that name none: as the column, FABRIC or NAME=FABRIC;NAME=FABRIC")(
      "options", po::value<std::string>(),
      "options of dress for garments that name none, such as \"--quality draft\"")(
      "jobs,j", po::value<int>(),
      "garments at once; default: as many as the machine has cores; --threads is of each")(
      "timeout", po::value<std::string>(),
      "seconds that a garment may take until it is dressed; default: no limit")(
      "memory", po::value<std::string>(),
      "memory that a garment's programs may ask for, such as 4GB; default: no limit")(
      "no-pictures", po::bool_switch(),
      "write figures alone: no page and no pictures of a garment")(
      "resume", po::bool_switch(),
      "keep what an earlier run has done in OUT, where neither inputs, options nor programs "
      "changed");
  program.positional.add("manifest", 1);
  program.writes_folder = true;
  program.check = [](const po::variables_map& given) {
    if (given.count("jobs") != 0 &&
        (given["jobs"].as<int>() < 1 || given["jobs"].as<int>() > 1024)) {
      throw po::error("-j is 1 to 1024");
    }
  };
  program.prepare = prepare;
  return program;
}

}  // namespace toile
