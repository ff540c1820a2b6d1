// toile compare: runs side by side, and the best size.
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "io/output_file.h"
#include "tools/compare/table.h"
#include "tools/programs.h"
#include "tools/report.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

/// What is read of a folder, or beside a report, and its page.
std::vector<fs::path> files_of_report(const fs::path& report) {
  const fs::path folder = report.extension() == ".json" ? report.parent_path() : report;
  std::vector<fs::path> files = {report};
  for (const char* name : {"ease.json", "dressed.json", "report.json", "results.csv", "mesh.json",
                           "import.json", "body.report.json", "ease.html", "index.html"}) {
    files.push_back(folder / name);
  }
  return files;
}

int compare(const std::vector<fs::path>& reports, const std::optional<EaseTargets>& targets,
            const CommonSettings& common) {
  std::vector<ComparedRun> runs;
  for (const fs::path& report : reports) {
    for (ComparedRun& run : read_runs(report)) runs.push_back(std::move(run));
  }
  if (targets) {
    for (ComparedRun& run : runs) set_target(*targets, run);
  }
  const Comparison comparison = compare_runs(std::move(runs));
  OutputFiles files;
  write_file(files.at(common.output), common.output.extension() == ".csv"
                                          ? comparison_csv(comparison)
                                          : comparison_page(comparison, common.output));
  write_report(files, common, comparison_json(comparison));
  files.commit();
  for (const std::string& line : comparison_lines(comparison)) std::cout << line << '\n';
  std::cout << std::flush;
  common.say("wrote " + common.output.string());
  const auto has_best = [](const ComparedRow& row) { return row.best.has_value(); };
  return std::ranges::all_of(comparison.rows, has_best) ? exit_done : exit_negative;
}

}  // namespace

CommandLineProgram compare_program() {
  CommandLineProgram program;
  program.name = "toile compare";
  program.summary = "puts runs side by side, by body, size and fabric, and tells the best size";
  program.usage = "REPORTS... -o table.html|table.csv [--target NAME|FILE]";
  program.options.add_options()(
      "reports", po::value<std::vector<std::string>>()->required(),
      "folders of toile fit, try or batch, or reports of dress or ease-map; also as arguments")(
      "target", po::value<std::string>(),
      "the ease that is meant: close, fitted, semi-fitted, loose, or a JSON file of your own "
      "(default: that of the reports)");
  program.positional.add("reports", -1);
  program.output_extensions = {".html", ".htm", ".csv"};
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    std::vector<fs::path> reports;
    Job job;
    for (const std::string& report : given["reports"].as<std::vector<std::string>>()) {
      reports.emplace_back(report);
      for (const fs::path& file : files_of_report(report)) job.files.reads.push_back(file);
    }
    std::optional<EaseTargets> targets;
    if (given.count("target") != 0) {
      const auto target = given["target"].as<std::string>();
      targets = read_ease_targets(target);
      job.files.reads.emplace_back(target);
    }
    job.files.writes = {common.output};
    job.work = [reports, targets, &common] { return compare(reports, targets, common); };
    return job;
  };
  return program;
}

}  // namespace toile
