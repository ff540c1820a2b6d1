// One table of what dressing costs and how good it is: whole processes, files to files.
//   bench_dress_table [--garments tshirt ...] [--edges 25 10 ...] [--runs 3] [--paper] [--blender]
#include <algorithm>
#include <boost/program_options.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "io/output_file.h"
#include "tests/benchmarks/ended.h"
#include "tests/benchmarks/peer_blender.h"
#include "tests/benchmarks/prepare.h"
#include "tests/support/run_program.h"

namespace {

using namespace toile;
using namespace toile::pipeline;
using Json = nlohmann::json;

constexpr const char* none = "–";

struct Garment {
  std::string name;
  std::string pattern;  ///< of the samples, or of the real data
  std::string body;     ///< standing, walking or mean_all
};

const std::vector<Garment> garments = {
    {"tshirt", "tshirt.json", "standing"},
    {"walking_dress", "walking_dress.json", "walking"},
    {"trousers", "trousers.json", "standing"},
    {"shirt_mean", "patterns/garmentcode/shirt_mean.json", "mean_all"},
    {"dress_pencil", "patterns/garmentcode/dress_pencil.json", "mean_all"},
};

struct Settings {
  std::vector<std::string> garments;
  std::vector<double> edges_mm;
  int runs = 1;
  int threads = 1;
  int limit = 3600;  ///< seconds after which a run is killed
  bool paper = false;
  std::optional<fs::path> blender;
};

/// Columns in the order of their first use; a row may lack some.
class Table {
 public:
  void begin_row() { rows_.emplace_back(); }
  std::size_t rows() const { return rows_.size(); }
  void set(std::size_t row, const std::string& column, const std::string& text) {
    if (std::find(columns_.begin(), columns_.end(), column) == columns_.end()) {
      columns_.push_back(column);
    }
    rows_[row][column] = text;
  }
  std::string text(const char* before, const char* between, const char* after, bool rule) const {
    std::string all = line(columns_, before, between, after);
    if (rule) {
      all += line(std::vector<std::string>(columns_.size(), "---"), before, between, after);
    }
    for (const auto& row : rows_) {
      std::vector<std::string> cells;
      for (const std::string& column : columns_) {
        const auto found = row.find(column);
        cells.push_back(found == row.end() ? none : found->second);
        // No cell ends early, whatever a message holds.
        std::replace(cells.back().begin(), cells.back().end(), rule ? '|' : ',', ';');
      }
      all += line(cells, before, between, after);
    }
    return all;
  }

 private:
  static std::string line(const std::vector<std::string>& cells, const char* before,
                          const char* between, const char* after) {
    std::string text = before;
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i > 0 ? between : "") + cells[i];
    return text + after + "\n";
  }

  std::vector<std::string> columns_;
  std::vector<std::map<std::string, std::string>> rows_;
};

std::string fixed(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

/// A row that is dressed: where its files are.
struct Case {
  std::string garment;
  double edge_mm = 0;
  fs::path mesh;
  fs::path body;
  double seconds = 0;  ///< 0: it failed
  double lift = 0;     ///< metres that the panels were raised by at the start
};

std::vector<std::string> dress_arguments(const Case& at, const fs::path& output,
                                         const Settings& settings) {
  return {"--body",
          at.body.string(),
          at.mesh.string(),
          "-o",
          output.string(),
          "--report",
          fs::path(output).replace_extension("json").string(),
          "--threads",
          std::to_string(settings.threads),
          "-q"};
}

/// Of the whole process's time; what no stage accounts for is "other".
void set_shares(Table& table, std::size_t row, const Json& report, double seconds) {
  std::vector<std::pair<std::string, double>> shares = {
      {"read", 0},   {"grid", 0}, {"position", 0}, {"sew", 0},
      {"settle", 0}, {"rest", 0}, {"judge", 0},    {"other", 0}};
  const auto share = [&](const std::string& name) -> double& {
    return std::find_if(shares.begin(), shares.end(),
                        [&](const auto& entry) { return entry.first == name; })
        ->second;
  };
  const Json& others = report.at("other_seconds");
  share("read") = others.value("read", 0.0);
  share("grid") = others.value("body_grid", 0.0);
  share("judge") = others.value("write_and_judge", 0.0);
  for (const Json& stage : report.at("stages")) {
    const std::string name = stage.at("name");
    // Of either method: the paper's wraps, sews and drapes on the garment's own mesh.
    static const std::map<std::string, std::string> columns = {
        {"position", "position"}, {"close_seams", "sew"},
        {"untangle", "sew"},      {"shrink", "sew"},
        {"wrap", "sew"},          {"sew", "sew"},
        {"settle", "settle"},     {"drape", "rest"},
        {"rest", "rest"},         {"release_attachments", "rest"}};
    if (const auto column = columns.find(name); column != columns.end()) {
      share(column->second) += stage.at("seconds").get<double>();
    }
  }
  double sum = 0;
  for (const auto& [name, part] : shares) sum += part;
  share("other") = seconds - sum;
  for (const auto& [name, part] : shares) {
    table.set(row, name + " %", fixed(100 * part / seconds, 0));
  }
}

void set_quality(Table& table, std::size_t row, const Json& report) {
  const Json& residual = report.at("residual");
  table.set(row, "residual median", fixed(residual.at("median"), 4));
  table.set(row, "residual rms", fixed(residual.at("rms"), 3));
  const auto percent = [&](const char* column, double value) {
    table.set(row, column, fixed(value, 2));
  };
  percent("strain p99 %", 100 * report.at("strain_off_seams").at("p99").get<double>());
  percent("area %", report.at("area_change_percent").at("max_panel"));
  percent("perimeter %", report.at("perimeter_change_percent").at("max_panel"));
  const auto two = [&](const char* column, const char* key, const char* a, const char* b) {
    const Json& both = report.at(key);
    table.set(row, column,
              std::to_string(both.at(a).get<int>()) + "/" + std::to_string(both.at(b).get<int>()));
  };
  two("seams sewn/open", "seams", "sewn", "open");
  two("intersections body/self", "intersections", "body", "self");
  table.set(row, "verdict", report.at("verdict"));
}

/// Which of the runs took the median time.
std::size_t median_of(const std::vector<Run>& runs) {
  std::vector<std::size_t> order(runs.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return runs[a].seconds < runs[b].seconds; });
  return order[(order.size() - 1) / 2];
}

/// The median with the body's distances kept by an earlier run of the same.
void cached_column(Table& table, std::size_t row, const Case& at, const Settings& settings) {
  std::vector<std::string> arguments =
      dress_arguments(at, fs::path(at.mesh).replace_extension("cached.obj"), settings);
  arguments.push_back("--cache");
  std::vector<Run> runs;
  for (int i = 0; i <= settings.runs; ++i) {
    runs.push_back(run("dress", arguments, settings.limit));
    const Run& done = runs.back();
    if (done.exit_code != 0 && done.exit_code != 3) {
      table.set(row, "s with --cache", "failed: " + complaint(done));
      return;
    }
  }
  runs.erase(runs.begin());  // it had to compute them
  table.set(row, "s with --cache", fixed(runs[median_of(runs)].seconds, 2));
}

/// Runs dress as often as asked; the run of median time stands for all.
void dress_row(Table& table, std::size_t row, Case& at, const Settings& settings) {
  const fs::path output = fs::path(at.mesh).replace_extension("dressed.obj");
  std::vector<Run> runs;
  for (int i = 0; i < settings.runs; ++i) {
    const fs::path numbered = fs::path(at.mesh).replace_extension(std::to_string(i) + ".obj");
    runs.push_back(run("dress", dress_arguments(at, numbered, settings), settings.limit));
    const Run& done = runs.back();
    if (done.exit_code != 0 && done.exit_code != 3) {
      table.set(row, "verdict", "failed: " + complaint(done));
      return;
    }
  }
  const std::size_t median = median_of(runs);
  const Json report =
      Json::parse(read_file(fs::path(at.mesh).replace_extension(std::to_string(median) + ".json")));
  at.seconds = runs[median].seconds;
  at.lift = report.at("scene").at("lift_mm").get<double>() / 1000;
  table.set(row, "nodes", std::to_string(report.at("garment").at("nodes").get<int>()));
  table.set(row, "seconds", fixed(at.seconds, 2));
  table.set(row, "processor s", fixed(runs[median].processor_seconds, 2));
  table.set(row, "peak MiB", fixed(runs[median].peak_MiB, 0));
  cached_column(table, row, at, settings);
  set_shares(table, row, report, at.seconds);
  set_quality(table, row, report);
}

void paper_row(Table& table, std::size_t row, const Case& at, const Settings& settings) {
  const fs::path output = fs::path(at.mesh).replace_extension("paper.obj");
  std::vector<std::string> arguments = dress_arguments(at, output, settings);
  arguments.insert(arguments.end(), {"--method", "paper"});
  const Run done = run("dress", arguments, settings.limit);
  if (done.exit_code != 0 && done.exit_code != 3) {
    table.set(row, "paper s", complaint(done));
    return;
  }
  table.set(row, "paper s", fixed(done.seconds, 1));
  table.set(row, "paper processor s", fixed(done.processor_seconds, 1));
  if (at.seconds > 0) table.set(row, "paper/ours", fixed(done.seconds / at.seconds, 1));
}

void blender_row(Table& table, std::size_t row, const Case& at, const Settings& settings) {
  const fs::path output = fs::path(at.mesh).replace_extension("blender.obj");
  try {
    const PeerMeasurements peer = run_blender(*settings.blender, at.mesh, at.body, output, at.lift,
                                              settings.threads, settings.limit);
    table.set(row, "Blender s", fixed(peer.run.seconds, 1));
    table.set(row, "Blender processor s", fixed(peer.run.processor_seconds, 1));
    if (at.seconds > 0) table.set(row, "Blender/ours", fixed(peer.run.seconds / at.seconds, 1));
    table.set(row, "Blender strain p99 %", fixed(100 * peer.strain_p99, 2));
    table.set(row, "Blender seam gap mm", fixed(peer.gap_mm, 2));
    table.set(row, "Blender body/self",
              std::to_string(peer.body) + "/" + std::to_string(peer.self));
  } catch (const std::exception& error) {
    const std::string what = error.what();
    table.set(row, "Blender s", "failed: " + what.substr(0, what.find('\n')));
  }
}

std::string load() {
  std::string text = "unknown";
  std::ifstream("/proc/loadavg") >> text;
  return text;
}

/// Meshes every garment at every edge length; those whose data is absent are left out, saying so.
std::vector<Case> mesh_all(const Settings& settings, const fs::path& folder) {
  Bodies bodies(folder);
  std::vector<Case> cases;
  for (const Garment& garment : garments) {
    const auto& wanted = settings.garments;
    if (std::find(wanted.begin(), wanted.end(), garment.name) == wanted.end()) continue;
    const auto pattern = pattern_for(garment.body, garment.pattern);
    const auto body = pattern ? bodies.get(garment.body) : std::nullopt;
    if (!body) {
      std::cerr << garment.name
                << " is left out: its data is not in ../shared/data or TOILE_DATA\n";
      continue;
    }
    for (const double edge : settings.edges_mm) {
      const std::string name = garment.name + "-" + std::to_string(cases.size());
      Case at{garment.name, edge, folder / (name + ".obj"), *body};
      std::ostringstream length;
      length << edge << "mm";
      run_or_throw("mesh-pattern", {pattern->string(), "-o", at.mesh.string(), "--edge-length",
                                    length.str(), "-q"});
      cases.push_back(at);
    }
  }
  return cases;
}

/// Our own runs come first: a child's peak memory is never less than what this process has, and
/// judging a peer's drape takes some.
std::string measure(const Settings& settings, const fs::path& csv) {
  const ScratchFolder scratch;
  std::vector<Case> cases = mesh_all(settings, scratch.path());
  Table table;
  const std::string load_before = load();
  for (std::size_t row = 0; row < cases.size(); ++row) {
    Case& at = cases[row];
    table.begin_row();
    table.set(row, "garment", at.garment);
    std::ostringstream edge;
    edge << at.edge_mm;
    table.set(row, "edge mm", edge.str());
    std::cerr << at.garment << ", " << edge.str() << " mm\n";
    dress_row(table, row, at, settings);
  }
  const std::string load_after = load();
  for (std::size_t row = 0; row < cases.size() && settings.paper; ++row) {
    std::cerr << cases[row].garment << " by the paper's method\n";
    paper_row(table, row, cases[row], settings);
  }
  for (std::size_t row = 0; row < cases.size() && settings.blender; ++row) {
    std::cerr << cases[row].garment << " by Blender\n";
    blender_row(table, row, cases[row], settings);
  }
  if (!csv.empty()) write_file(csv, table.text("", ",", "", false));
  return table.text("| ", " | ", " |", true) + "\n" + std::to_string(settings.threads) +
         " threads, " + std::to_string(std::thread::hardware_concurrency()) +
         " processors; median of " + std::to_string(settings.runs) +
         " runs; load of the machine before " + load_before + ", after " + load_after + ".\n";
}

int measured(int argc, char** argv) {
  namespace po = boost::program_options;
  Settings settings;
  for (const Garment& garment : garments) settings.garments.push_back(garment.name);
  settings.edges_mm = {25, 10};
  settings.threads = static_cast<int>(std::thread::hardware_concurrency());
  fs::path csv;
  const auto values = [](auto* target) { return po::value(target)->multitoken(); };
  po::options_description options("bench_dress_table");
  options.add_options()("help", "this")("garments", values(&settings.garments),
                                        "of tshirt walking_dress trousers shirt_mean dress_pencil")(
      "edges", values(&settings.edges_mm), "edge lengths, mm; default: 25 10")(
      "runs", po::value(&settings.runs), "of each; the median counts; default: 1")(
      "threads", po::value(&settings.threads), "default: all processors")(
      "limit", po::value(&settings.limit), "seconds for a run; default: 3600")(
      "paper", "compare with --method paper on the same meshes")(
      "blender", "compare with Blender's cloth on the same meshes, where blender is installed")(
      "output,o", po::value(&csv), "the same table as CSV");
  po::variables_map given;
  po::store(po::parse_command_line(argc, argv, options), given);
  po::notify(given);
  if (given.count("help")) {
    std::cout << options;
    return 0;
  }
  for (const std::string& name : settings.garments) {
    if (std::none_of(garments.begin(), garments.end(),
                     [&](const Garment& garment) { return garment.name == name; })) {
      throw po::error("no garment is called " + name);
    }
  }
  if (settings.runs < 1 || settings.threads < 1 || settings.limit < 1) {
    throw po::error("--runs, --threads and --limit are 1 or more");
  }
  settings.paper = given.count("paper") != 0;
  if (given.count("blender")) {
    settings.blender = find_in_path("blender");
    if (!settings.blender) std::cerr << "blender is not installed: left out\n";
  }
  std::cout << measure(settings, csv);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return toile::ended("bench_dress_table", [&] { return measured(argc, argv); });
}
