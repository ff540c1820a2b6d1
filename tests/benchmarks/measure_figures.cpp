// Prints how true and how steady landmarks and measures are, as tables:
//   bench_measure_figures [FOLDER WITH bodies/ AND ../references/]
#include <sys/resource.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <numbers>
#include <string>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/body/measures.h"
#include "geometry/decimate.h"
#include "io/measure_names.h"
#include "io/mesh_file.h"
#include "tests/support/noise.h"

namespace {

namespace fs = std::filesystem;
using namespace toile;

double seconds_used() {
  rusage used = {};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec);
}

/// Each triangle as four.
TriangleMesh split(const TriangleMesh& mesh) {
  TriangleMesh fine{mesh.points, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [found, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<int>(fine.points.size()));
    if (is_new) fine.points.push_back((mesh.points[a] + mesh.points[b]) / 2);
    return found->second;
  };
  for (const Triangle& t : mesh.triangles) {
    const int a = middle(t[0], t[1]);
    const int b = middle(t[1], t[2]);
    const int c = middle(t[2], t[0]);
    fine.triangles.insert(fine.triangles.end(),
                          {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
  }
  return fine;
}

TriangleMesh turned(TriangleMesh mesh, double degrees) {
  const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, Vec3::UnitY());
  for (Vec3& p : mesh.points) p = turn * p;
  return mesh;
}

/// Millimetres by which each landmark moves; `back` brings the changed body's points back.
void print_moves(const std::string& what, const Landmarks& before, const TriangleMesh& changed,
                 const std::function<Vec3(const Vec3&)>& back) {
  const Landmarks after = given_landmarks(find_landmarks(changed, what));
  std::vector<std::pair<double, std::string>> moves;
  for (const Landmark& landmark : before) {
    if (!landmark.place) continue;
    const auto place = place_of(after, landmark.name);
    moves.emplace_back(place ? 1000 * (back(*place) - *landmark.place).norm() : 999, landmark.name);
  }
  std::sort(moves.rbegin(), moves.rend());
  std::printf("  %-24s", what.c_str());
  for (std::size_t i = 0; i < 5 && i < moves.size(); ++i) {
    std::printf(" %6.2f %s", moves[i].first, moves[i].second.c_str());
  }
  std::printf("\n");
}

void print_steadiness(const std::string& name, const TriangleMesh& body) {
  const Landmarks before = given_landmarks(find_landmarks(body, name));
  std::printf("\nLandmarks of %s: the five that move most, mm\n", name.c_str());
  const auto same = [](const Vec3& p) { return p; };
  for (const double degrees : {7.0, 33.0, 120.0, 180.0}) {
    print_moves(
        "turned by " + std::to_string(static_cast<int>(degrees)), before, turned(body, degrees),
        [degrees](const Vec3& p) {
          return Vec3(Eigen::AngleAxisd(-degrees * std::numbers::pi / 180, Vec3::UnitY()) * p);
        });
  }
  print_moves("half the triangles", before, decimate(body, body.triangles.size() / 2), same);
  print_moves("split triangles", before, split(body), same);
  for (const unsigned seed : {1U, 2U, 3U}) {
    print_moves("1 mm noise, seed " + std::to_string(seed), before, test::noisy(body, seed), same);
  }
}

double mean_of(const std::vector<Measure>& measures, const std::string& name) {
  double sum = 0;
  int n = 0;
  for (const std::string side : {"", "left_", "right_"}) {
    const Measure* measure = find_measure(measures, side + name);
    if (measure == nullptr || !measure->value) continue;
    sum += *measure->value * (measure->is_angle ? 1 : 100);
    ++n;
  }
  return n > 0 ? sum / n : std::nan("");
}

void print_garmentcode(const fs::path& bodies, const std::string& name) {
  std::ifstream yaml(bodies / (name + ".yaml"));
  const TriangleMesh body = fan_triangles(read_mesh(bodies / (name + ".obj")));
  const double start = seconds_used();
  const std::vector<Measure> measures = measure_body(find_landmarks(body, name));
  std::printf("\n%s: %zu points, %.2f s of processor time\n", name.c_str(), body.points.size(),
              seconds_used() - start);
  std::printf("  %-22s %9s %9s %9s\n", "GarmentCode's", "theirs", "ours", "mm");
  std::map<std::string, double> theirs;
  for (std::string line; std::getline(yaml, line);) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) {
      theirs[line.substr(line.find_first_not_of(' '), colon - line.find_first_not_of(' '))] =
          std::stod(line.substr(colon + 2));
    }
  }
  for (const ForeignMeasure& foreign : foreign_measures(DraftingProgram::garmentcode)) {
    double ours = 0;
    for (const MeasureTerm& term : foreign.terms) {
      ours += term.factor * mean_of(measures, std::string(term.name));
    }
    const std::string key(foreign.name);
    std::printf("  %-22s %9.2f %9.2f %9.1f\n", key.c_str(), theirs[key], ours,
                10 * (ours - theirs[key]));
  }
}

void print_mannequin() {
  MannequinOptions options;
  options.edge_length = 0.006;
  const Mannequin mannequin = make_mannequin(options);
  const BodyShape shape = find_landmarks(mannequin.surface, "mannequin");
  const std::vector<Measure> measures = measure_body(shape);
  std::printf("\nMannequin, edges of 6 mm: its sections, cm, and what is measured\n");
  for (const MannequinGirth& girth : mannequin.girths) {
    std::string name = girth.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    std::replace(name.begin(), name.end(), '-', '_');
    std::printf("  %-12s target %7.2f  same section %7.2f  measured %7.2f\n", name.c_str(),
                100 * girth.target,
                100 * girth_around(mannequin.surface, girth.centre, girth.normal),
                mean_of(measures, name));
  }
}

}  // namespace

int main(int count, char** arguments) {
  const fs::path data = count > 1 ? arguments[1] : "../shared/data";
  print_mannequin();
  MannequinOptions options;
  const TriangleMesh mannequin = make_mannequin(options).surface;
  print_steadiness("mannequin", mannequin);
  options.edge_length = 0.015;
  const Landmarks fine = given_landmarks(find_landmarks(mannequin, "mannequin"));
  print_moves("edges of 15 mm for 9", fine, make_mannequin(options).surface,
              [](const Vec3& p) { return p; });
  options.edge_length = 0.005;
  print_moves("edges of 5 mm for 9", fine, make_mannequin(options).surface,
              [](const Vec3& p) { return p; });
  for (const std::string name : {"mean_all", "mean_male"}) {
    const fs::path bodies = data / "bodies";
    if (!fs::exists(bodies / (name + ".obj"))) {
      std::printf("\n%s is not in %s\n", name.c_str(), bodies.c_str());
      continue;
    }
    print_garmentcode(bodies, name);
    print_steadiness(name, fan_triangles(read_mesh(bodies / (name + ".obj"))));
  }
  return 0;
}
