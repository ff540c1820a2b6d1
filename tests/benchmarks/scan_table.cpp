// Prints how true the surfaces are that are made of simulated scans, and how their girths repeat:
//   bench_scan_table [FOLDER WITH bodies/] [POINTS NOISE_MM [SCANS]]
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "geometry/body/clean_body.h"
#include "geometry/body/mannequin/mannequin.h"
#include "geometry/body/measures.h"
#include "geometry/scan/reconstruct_scan.h"
#include "io/mesh_file.h"
#include "tests/support/scanner.h"

namespace {

using namespace toile;

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double most_memory_mb() {
  rusage used = {};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024;
}

struct Body {
  std::string name;
  TriangleMesh mesh;
};

/// The body as it stands on the floor, in metres.
TriangleMesh standing(const PolygonSoup& soup, const CleanOptions& options = {}) {
  const CleanBody body = clean_body(soup, "body", options);
  if (!body.skeleton) std::printf("no skeleton: %s\n", body.report.no_skeleton.c_str());
  return body.mesh;
}

void print_row(const Body& body, int points, double noise_mm) {
  test::Scanner scanner;
  scanner.points = points;
  scanner.noise = noise_mm / 1000;
  const test::Scan scan = test::scan_body(body.mesh, scanner);
  const Clock::time_point start = Clock::now();
  const ReconstructedScan made = reconstruct_scan(scan.cloud, "scan");
  const double seconds = since(start);
  const double reach = std::max(0.008, 2.5 * made.report.spacing);
  const test::Agreement a = test::agreement(made.mesh, body.mesh, scan, reach);
  std::printf(
      "| %s | %d | %.0f | %.1f | %.1f | %.2f | %.2f | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | "
      "%.0f |\n",
      body.name.c_str(), points, noise_mm, 1000 * made.report.spacing, 1000 * made.report.noise,
      100 * a.seen_2mm, 100 * a.seen_5mm, 1000 * a.seen_worst, 100 * a.unseen, 100 * a.unseen_10mm,
      1000 * a.unseen_worst, 1000 * made.report.error_rms, seconds, most_memory_mb());
  std::fflush(stdout);
}

bool is_girth(std::string name) {
  for (const std::string side : {"left_", "right_"}) {
    if (name.find(side) == 0) name = name.substr(side.size());
  }
  for (const char* girth : {"bust", "underbust", "waist", "abdomen", "hip", "neck", "upper_thigh",
                            "mid_thigh", "knee", "calf", "ankle", "upper_arm", "elbow", "wrist"}) {
    if (name == girth) return true;
  }
  return false;
}

/// Some scans of one body: half of the widest spread of a girth, and of the mean from the truth.
void print_girths(const Body& body, int points, double noise_mm, unsigned scans) {
  const auto girths = [](const TriangleMesh& mesh) {
    std::map<std::string, double> values;
    for (const Measure& m : measure_body(find_landmarks(mesh, "body"))) {
      if (is_girth(m.name) && m.value) values[m.name] = *m.value;
    }
    return values;
  };
  const std::map<std::string, double> truth = girths(body.mesh);
  std::map<std::string, std::vector<double>> taken;
  for (unsigned seed = 1; seed <= scans; ++seed) {
    test::Scanner scanner;
    scanner.points = points;
    scanner.noise = noise_mm / 1000;
    scanner.seed = seed;
    const ReconstructedScan made =
        reconstruct_scan(test::scan_body(body.mesh, scanner).cloud, "scan");
    PolygonSoup soup;
    soup.points = made.mesh.points;
    for (const Triangle& t : made.mesh.triangles) soup.polygons.push_back({t[0], t[1], t[2]});
    CleanOptions options;
    options.metres_per_unit = 1;
    if (made.report.floor_found) options.up = made.report.up;
    for (const auto& [name, value] : girths(standing(soup, options))) taken[name].push_back(value);
  }
  for (const auto& [name, values] : taken) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    double mean = 0;
    for (const double value : values) mean += value / static_cast<double>(values.size());
    const auto is = truth.find(name);
    std::printf("| %s | %s | %zu | %.1f | %.1f | %+.1f |\n", body.name.c_str(), name.c_str(),
                values.size(), 1000 * mean, 500 * (*high - *low),
                is == truth.end() ? NAN : 1000 * (mean - is->second));
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Body> bodies = {{"mannequin", make_mannequin().surface}};
  for (const char* name : {"mean_all", "mean_male"}) {
    if (argc < 2) break;
    const std::filesystem::path file =
        std::filesystem::path(argv[1]) / "bodies" / (std::string(name) + ".obj");
    if (std::filesystem::exists(file)) bodies.push_back({name, standing(read_mesh(file))});
  }
  std::printf(
      "| body | points | noise mm | spacing mm | noise found mm | seen within 2 mm %% | "
      "within 5 mm %% | worst mm | unseen %% | unseen within 10 mm %% | worst mm | rms to points "
      "mm | "
      "seconds | MiB |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  const bool is_one = argc > 3;
  const int some = is_one ? std::atoi(argv[2]) : 100000;
  const double noise_mm = is_one ? std::atof(argv[3]) : 1;
  for (const Body& body : bodies) {
    if (is_one) print_row(body, some, noise_mm);
    for (const int points : {20000, 100000, 500000, 2000000}) {
      for (const double noise : {1.0, 2.0, 3.0}) {
        if (!is_one) print_row(body, points, noise);
      }
    }
  }
  const auto scans = static_cast<unsigned>(argc > 4 ? std::atoi(argv[4]) : 10);
  if (scans == 0) return 0;
  std::printf(
      "\n| body | girth | scans | mean mm | half spread mm | from the truth mm |\n"
      "|---|---|---|---|---|---|\n");
  for (const Body& body : bodies) print_girths(body, some, noise_mm, scans);
  return 0;
}
