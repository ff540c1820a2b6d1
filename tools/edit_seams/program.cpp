// edit-seams: the seams of a pattern, drawn by hand.
#include "geometry/error.h"
#include "tools/edit_seams/run.h"
#include "tools/mesh_pattern/run.h"
#include "tools/programs.h"

namespace toile {

namespace po = boost::program_options;

CommandLineProgram edit_seams_program() {
  CommandLineProgram program;
  program.name = "edit-seams";
  program.summary = "shows the panels flat, to draw, correct and try their seams in a browser";
  program.usage = "PATTERN.json -o page.html | PATTERN.json --serve [--body BODY] -o sewn.json";
  program.options.add_options()("pattern", po::value<std::string>()->required(),
                                "the pattern; also as argument")(
      "proposals", po::value<std::string>(), "seams to accept or reject: the report of find-seams")(
      "serve", po::bool_switch(),
      "serve the page to browsers of this machine; saving then writes -o")(
      "body", po::value<std::string>(), "with --serve: the body that the page can dress")(
      "port", po::value<int>()->default_value(0),
      "with --serve: 1024 to 65535; 0: any that is free")(
      "edge-length", po::value<std::string>()->default_value("25mm"),
      "with --body: length of triangle edges");
  program.positional.add("pattern", 1);
  program.check = [](const po::variables_map& given) {
    const bool serves = given["serve"].as<bool>();
    const int port = given["port"].as<int>();
    if (!serves && given.count("body") != 0) throw po::error("--body needs --serve");
    if (given.count("body") == 0 && !given["edge-length"].defaulted()) {
      throw po::error("--edge-length needs --body");
    }
    if (!serves && port != 0) throw po::error("--port needs --serve");
    if (port != 0 && (port < 1024 || port > 65535)) throw po::error("--port is not 1024 to 65535");
  };
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    EditSeamsSettings settings;
    settings.pattern = given["pattern"].as<std::string>();
    settings.serve = given["serve"].as<bool>();
    settings.port = given["port"].as<int>();
    settings.edge_length = read_edge_length(given);
    const std::string wanted = settings.serve ? ".json" : ".html";
    if (common.output.extension() != wanted) {
      throw Error(common.output.string(), "does not end in " + wanted,
                  settings.serve ? "with --serve, -o is the pattern that the page saves"
                                 : "without --serve, -o is the page");
    }
    Job job;
    job.files.reads = {settings.pattern};
    if (given.count("proposals") != 0) {
      settings.proposals = given["proposals"].as<std::string>();
      job.files.reads.push_back(*settings.proposals);
    }
    if (given.count("body") != 0) {
      settings.body = given["body"].as<std::string>();
      job.files.reads.push_back(*settings.body);
    }
    job.files.writes = {common.output};
    job.work = [settings, &common] {
      run_edit_seams(settings, common);
      return exit_done;
    };
    return job;
  };
  return program;
}

}  // namespace toile
