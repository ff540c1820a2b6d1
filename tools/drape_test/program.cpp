// drape-test: how a fabric hangs over the plate of a drape tester.
#include <algorithm>

#include "io/text.h"
#include "tools/drape_test/run.h"
#include "tools/programs.h"

namespace toile {
namespace {

namespace po = boost::program_options;

Job prepare_drape_test(const po::variables_map& given, const CommonSettings& common) {
  DrapeTestSettings settings;
  const std::string fabric = given["fabric"].as<std::string>();
  settings.fabric = find_fabric(fabric);
  settings.starts = given["starts"].as<int>();
  if (settings.starts < 1 || settings.starts > 100) {
    throw UsageError("--starts", "is out of range", "give 1 to 100");
  }
  const auto length = [&](const char* option) {
    return parse_length(given[option].as<std::string>(), std::string("--") + option);
  };
  settings.sizes.plate = 0.5 * length("plate");
  settings.sizes.sheet = 0.5 * length("sheet");
  settings.sizes.spacing = length("edge-length");
  if (settings.sizes.plate < 0.01 || settings.sizes.sheet > 0.5) {
    throw UsageError("--plate", "is no tester's", "give 2 cm and more, and a sheet up to 1 m");
  }
  const double over = settings.sizes.sheet - settings.sizes.plate;
  if (over < 2 * settings.sizes.spacing) {
    throw UsageError("--sheet", "hangs over the plate by less than two edges",
                     "give a larger sheet, or a shorter --edge-length");
  }
  if (settings.sizes.spacing < 0.001) {
    throw UsageError("--edge-length", "is too short", "give 1 mm or more");
  }
  Job job;
  const std::vector<std::string> known = fabric_names();
  if (std::ranges::find(known, fabric) == known.end()) job.files.reads = {fabric};
  job.files.writes = {common.output};
  job.work = [settings, &common] { return run_drape_test(settings, common); };
  return job;
}

}  // namespace

CommandLineProgram drape_test_program() {
  CommandLineProgram program;
  program.name = "drape-test";
  program.summary = "lets a round sheet of a fabric hang over a plate: drape coefficient and nodes";
  program.usage = "FABRIC -o picture.png [options]";
  program.options.add_options()("fabric", po::value<std::string>()->required(),
                                "a fabric known by name, or a JSON file; also as argument")(
      "starts", po::value<int>()->default_value(5),
      "sheets that start with another ripple each: their spread is the error")(
      "plate", po::value<std::string>()->default_value("18cm"), "diameter of the plates")(
      "sheet", po::value<std::string>()->default_value("30cm"), "diameter of the sheet")(
      "edge-length", po::value<std::string>()->default_value("5mm"), "of the sheet's triangles");
  program.positional.add("fabric", 1);
  program.output_extensions = {".png"};
  program.prepare = prepare_drape_test;
  return program;
}

}  // namespace toile
