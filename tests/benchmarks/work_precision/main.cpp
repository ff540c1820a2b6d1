// Speed against error: each method over its own knobs, against the same method converged.
//   bench_work_precision [-o FOLDER] [--fast] [--plot docs/images/work_precision.svg]
#include <algorithm>
#include <boost/program_options.hpp>
#include <fstream>
#include <iostream>

#include "io/output_file.h"
#include "tests/benchmarks/ended.h"
#include "tests/benchmarks/work_precision/held_sheets.h"
#include "tests/benchmarks/work_precision/page.h"
#include "tests/benchmarks/work_precision/study.h"

namespace {

using namespace toile;
using namespace toile::precision;
namespace fs = std::filesystem;

struct Settings {
  fs::path folder = "work-precision";
  fs::path plot;
  bool fast = false;
  std::string only;  ///< presets, terms, sheets or garments; empty: all

  bool wants(const char* part) const { return only.empty() || only == part; }
};

/// By scene, then from coarse to fine.
void arrange(std::vector<Row>& rows) {
  std::vector<std::string> scenes;
  for (const Row& row : rows) {
    if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) {
      scenes.push_back(row.scene);
    }
  }
  const auto key = [&](const Row& row) {
    return std::pair(std::find(scenes.begin(), scenes.end(), row.scene), -row.edge_mm);
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const Row& a, const Row& b) { return key(a) < key(b); });
}

class Benchmark {
 public:
  explicit Benchmark(const Settings& settings);
  Results run();

 private:
  void sheets();
  void garment(const WornGarment& garment, double edge_mm, const Plan& plan);
  void garments();
  void terms();
  void write();
  void add(const std::vector<Row>& rows);

  const Settings& settings_;
  Wardrobe wardrobe_;
  Results results_;
};

void Benchmark::add(const std::vector<Row>& rows) {
  results_.rows.insert(results_.rows.end(), rows.begin(), rows.end());
  arrange(results_.rows);
  write();
}

/// All knobs at the mesh in the middle; at the others the presets, to see what the mesh does.
void Benchmark::sheets() {
  const bool fast = settings_.fast;
  for (const int nodes : fast ? std::vector{17} : std::vector{9, 17, 25}) {
    add(study(*hanging_cloth(nodes), {.all_knobs = nodes == 17, .fast = fast}));
  }
  for (const int elements : fast ? std::vector{8} : std::vector{8, 16, 24}) {
    add(study(*cantilever(elements), {.all_knobs = elements == 16, .fast = fast}));
  }
}

void Benchmark::garment(const WornGarment& garment, double edge_mm, const Plan& plan) {
  const auto scene = wardrobe_.get(garment, edge_mm);
  if (scene) {
    add(study(*scene, plan));
  } else {
    std::cerr << garment.scene << " is left out: its data is not in ../shared/data or TOILE_DATA\n";
  }
}

/// Finer meshes than 25 mm take the paper's method minutes a run.
void Benchmark::garments() {
  if (settings_.fast) {
    for (const WornGarment& each : {tshirt, pencil_dress}) garment(each, 40, {.fast = true});
    return;
  }
  garment(tshirt, 25, {});
  garment(pencil_dress, 25, {.all_knobs = false});
  for (const WornGarment& each : {tshirt, pencil_dress}) {
    garment(each, 35, {.all_knobs = false});
    garment(each, 10, {.paper = false, .all_knobs = false});
  }
}

void Benchmark::terms() {
  for (const WornGarment& each : {tshirt, pencil_dress}) {
    const auto rows = study_terms(wardrobe_, each, results_.presets_mm);
    results_.terms.insert(results_.terms.end(), rows.begin(), rows.end());
    write();
  }
}

/// After each scene: a long run that is cut short has shown something.
void Benchmark::write() {
  write_file(settings_.folder / "work_precision.csv", csv_of(results_.rows));
  write_file(settings_.folder / "terms.csv", csv_of(results_.terms));
  write_file(settings_.folder / "work_precision.svg", headline_plot(results_));
  write_file(settings_.folder / "index.html", page_of(results_));
}

std::string load() {
  std::string text = "unknown";
  std::ifstream("/proc/loadavg") >> text;
  return text;
}

Benchmark::Benchmark(const Settings& settings) : settings_(settings) {
  results_.load = load();
  results_.presets_mm = settings.fast ? 35 : 15;
}

Results Benchmark::run() {
  write();
  const Plan presets = {.paper = false, .all_knobs = false, .fast = settings_.fast};
  if (settings_.wants("presets")) {
    for (const WornGarment& each : {tshirt, gathered_skirt, elastic_skirt, shirt}) {
      garment(each, results_.presets_mm, presets);
    }
    // The paper's method does not close the pencil dress's seams on coarser meshes.
    const bool whole = settings_.only.empty() && !settings_.fast;
    garment(pencil_dress, results_.presets_mm, whole ? Plan{.few_of_paper = true} : presets);
  }
  if (settings_.wants("terms")) terms();
  if (settings_.wants("sheets")) sheets();
  if (settings_.wants("garments")) garments();
  return results_;
}

int measured(int argc, char** argv) {
  namespace po = boost::program_options;
  Settings settings;
  po::options_description options("bench_work_precision");
  options.add_options()("help", "this")("output,o", po::value(&settings.folder),
                                        "folder of what is written; default: work-precision")(
      "plot", po::value(&settings.plot),
      "the headline plot once more, such as docs/images/NAME.svg")(
      "fast", "coarse and little of all: to see that it runs")(
      "only", po::value(&settings.only), "a part of it: presets, terms, sheets or garments");
  po::variables_map given;
  po::store(po::parse_command_line(argc, argv, options), given);
  po::notify(given);
  if (given.count("help")) {
    std::cout << options;
    return 0;
  }
  settings.fast = given.count("fast") != 0;
  const std::vector<std::string> parts = {"", "presets", "terms", "sheets", "garments"};
  if (std::find(parts.begin(), parts.end(), settings.only) == parts.end()) {
    throw po::error("--only is presets, terms, sheets or garments");
  }
  fs::create_directories(settings.folder);
  check_writable(settings.folder / "index.html");
  if (!settings.plot.empty()) check_writable(settings.plot);
  const Results results = Benchmark(settings).run();
  if (!settings.plot.empty()) write_file(settings.plot, headline_plot(results));
  if (settings.wants("presets")) std::cout << presets_table(results) << expectations(results);
  std::cout << "written: " << fs::absolute(settings.folder / "index.html").string()
            << ", work_precision.csv, terms.csv and work_precision.svg beside it\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return toile::ended("bench_work_precision", [&] { return measured(argc, argv); });
}
