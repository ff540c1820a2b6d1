// Prints how far landmarks and measures move under noise, as a table:
//   bench_landmark_noise SEEDS FOLDER BODY...
// Each body is a clean one in metres that stands along y, or "mannequin". One kind of noise moves
// its points along their normals by 1 mm; the other is that of scans with 1 mm of noise. Scans are
// kept in FOLDER; without scans it is "-".
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/body/measures.h"
#include "geometry/scan/reconstruct_scan.h"
#include "io/mesh_file.h"
#include "tests/support/noise.h"
#include "tests/support/scanner.h"

namespace {

namespace fs = std::filesystem;
using namespace toile;

TriangleMesh scanned(const TriangleMesh& body, unsigned seed, const fs::path& kept) {
  if (fs::exists(kept)) return fan_triangles(read_mesh(kept));
  test::Scanner scanner;
  scanner.points = 100000;
  scanner.seed = seed;
  const TriangleMesh made = reconstruct_scan(test::scan_body(body, scanner).cloud, "scan").mesh;
  fs::create_directories(kept.parent_path());
  write_mesh(OutputPath(kept), made);
  return made;
}

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// What one body and one kind of noise give, by name.
struct Figures {
  Landmarks truth;
  std::map<std::string, double> lengths;             // of measures, metres
  std::map<std::string, std::vector<Vec3>> places;   // of each seed
  std::map<std::string, std::vector<double>> taken;  // of each seed
  std::map<std::string, int> lost;                   // seeds without the landmark
};

bool is_girth(std::string name) {
  for (const std::string side : {"left_", "right_"}) {
    if (name.starts_with(side)) name = name.substr(side.size());
  }
  for (const char* girth : {"bust", "underbust", "waist", "abdomen", "hip", "neck", "upper_thigh",
                            "mid_thigh", "knee", "calf", "ankle", "upper_arm", "elbow", "wrist"}) {
    if (name == girth) return true;
  }
  return false;
}

bool is_length(const Measure& measure) { return !measure.is_angle; }

void add(const TriangleMesh& mesh, Figures& figures) {
  const BodyShape shape = find_landmarks(mesh, "changed");
  const Landmarks found = given_landmarks(shape);
  for (const Landmark& landmark : figures.truth) {
    if (!landmark.place) continue;
    if (const auto place = place_of(found, landmark.name)) {
      figures.places[landmark.name].push_back(*place);
    } else {
      ++figures.lost[landmark.name];
    }
  }
  for (const Measure& m : measure_body(shape)) {
    if (is_length(m) && m.value) figures.taken[m.name].push_back(*m.value);
  }
}

void print(const std::string& body, const char* noise, const Figures& figures) {
  std::vector<double> all;
  for (const Landmark& landmark : figures.truth) {
    const auto found = figures.places.find(landmark.name);
    if (found == figures.places.end()) continue;
    Vec3 mean = Vec3::Zero();
    const std::vector<Vec3>& places = found->second;
    for (const Vec3& p : places) mean += p / static_cast<double>(places.size());
    std::vector<double> moved;
    std::vector<double> off;
    for (const Vec3& p : places) {
      moved.push_back(1000 * (p - mean).norm());
      off.push_back(1000 * (p - *landmark.place).norm());
      all.push_back(off.back());
    }
    const Vec3 bias = 1000 * (mean - *landmark.place);
    const auto lost = figures.lost.find(landmark.name);
    std::printf("| %s | %s | %s | %.1f | %.1f | %.1f | %.1f | %+.1f %+.1f %+.1f | %d |\n",
                body.c_str(), noise, landmark.name.c_str(), median_of(off),
                *std::max_element(off.begin(), off.end()), median_of(moved),
                *std::max_element(moved.begin(), moved.end()), bias.x(), bias.y(), bias.z(),
                lost == figures.lost.end() ? 0 : lost->second);
  }
  const double beyond = static_cast<double>(
      std::count_if(all.begin(), all.end(), [](double off) { return off > 5; }));
  std::printf("| %s | %s | all | %.1f | %.1f | %.1f %% are beyond 5 mm | | | |\n", body.c_str(),
              noise, median_of(all), *std::max_element(all.begin(), all.end()),
              100 * beyond / static_cast<double>(all.size()));
  for (const auto& [name, values] : figures.taken) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    double mean = 0;
    for (const double value : values) mean += value / static_cast<double>(values.size());
    const auto truth = figures.lengths.find(name);
    if (truth == figures.lengths.end()) continue;
    std::printf("| %s | %s | %s %s | %.1f | half spread %.1f | from the truth %+.1f | | | |\n",
                body.c_str(), noise, is_girth(name) ? "girth" : "length", name.c_str(), 1000 * mean,
                500 * (*high - *low), 1000 * (mean - truth->second));
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: bench_landmark_noise SEEDS FOLDER BODY...\n");
    return 2;
  }
  const auto seeds = static_cast<unsigned>(std::atoi(argv[1]));
  std::printf(
      "| body | noise | landmark | median mm | worst mm | median about the mean mm | worst mm | "
      "mean's x y z mm | lost |\n|---|---|---|---|---|---|---|---|---|\n");
  for (int i = 3; i < argc; ++i) {
    const fs::path file = argv[i];
    const std::string name = file.stem().string();
    const bool is_made = std::string(argv[i]) == "mannequin";
    if (!is_made && !fs::exists(file)) {
      std::printf("| %s | is not there |\n", name.c_str());
      continue;
    }
    const TriangleMesh body = is_made ? make_mannequin().surface : fan_triangles(read_mesh(file));
    const BodyShape shape = find_landmarks(body, name);
    Figures of_body;
    of_body.truth = given_landmarks(shape);
    for (const Measure& m : measure_body(shape)) {
      if (is_length(m) && m.value) of_body.lengths[m.name] = *m.value;
    }
    Figures of_points = of_body;
    Figures of_scans = of_body;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
      add(test::noisy(body, seed), of_points);
      if (std::string(argv[2]) == "-") continue;
      add(scanned(body, seed, fs::path(argv[2]) / (name + "-" + std::to_string(seed) + ".ply")),
          of_scans);
    }
    print(name, "points", of_points);
    if (std::string(argv[2]) != "-") print(name, "scans", of_scans);
  }
  return 0;
}
