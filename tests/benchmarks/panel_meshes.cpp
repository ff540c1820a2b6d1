// How well panels are meshed, as a table. By hand:
//
//   cmake --build build/release --target bench_panel_meshes
//   build/release/tests/bench_panel_meshes EDGE_MM samples ../shared/data/patterns/garmentcode
//
// Each argument is a row: a folder of pattern files, or a file. The smallest angle is that of all
// triangles farther than three edges from corners of an outline below 50 degrees. A pattern counts
// as even when 99 % of its edges have 0.6 to 1.5 of the wanted length. The last rows are squares of
// ten thousand points and of a million triangles; their time is the processor's.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <map>
#include <numbers>

#include "geometry/angles.h"
#include "geometry/error.h"
#include "geometry/half_edges.h"
#include "geometry/triangulate.h"
#include "io/output_file.h"
#include "pattern/check/check_pattern.h"
#include "pattern/check/left_out.h"
#include "pattern/file/pattern_file.h"
#include "pattern/mesh/mesh_panels.h"

namespace {

using namespace toile;
namespace fs = std::filesystem;

constexpr double sharp_corner = to_radians(50);
constexpr double wanted_angle = to_radians(25);

struct Quality {
  double smallest_angle = std::numbers::pi;  // radians, away from sharp corners
  int below = 0;                             // triangles there with a smaller angle than wanted
  double even = 0;                           // share of edges
  double seconds = 0;
};

double angle_at(const PanelMesh& garment, const Triangle& t, int k) {
  const Vec2 u = garment.flat[t[(k + 1) % 3]] - garment.flat[t[k]];
  const Vec2 v = garment.flat[t[(k + 2) % 3]] - garment.flat[t[k]];
  return std::atan2(std::abs(u.x() * v.y() - u.y() * v.x()), u.dot(v));
}

Quality quality_of(const PanelMesh& garment) {
  Quality quality;
  std::vector<double> around(garment.flat.size(), 0);
  for (const Triangle& t : garment.triangles) {
    for (int k = 0; k < 3; ++k) around[t[k]] += angle_at(garment, t, k);
  }
  const std::vector<int> panel = panel_of_points(garment);
  std::vector<int> corners;
  for (std::size_t p = 0; p < around.size(); ++p) {
    if (around[p] < sharp_corner) corners.push_back(static_cast<int>(p));
  }
  for (const Triangle& t : garment.triangles) {
    const Vec2 middle = (garment.flat[t[0]] + garment.flat[t[1]] + garment.flat[t[2]]) / 3;
    const bool near = std::any_of(corners.begin(), corners.end(), [&](int c) {
      return panel[c] == panel[t[0]] && (garment.flat[c] - middle).norm() < 3 * garment.edge_length;
    });
    if (near) continue;
    const double angle = smallest_angle(garment.flat[t[0]], garment.flat[t[1]], garment.flat[t[2]]);
    quality.smallest_angle = std::min(quality.smallest_angle, angle);
    quality.below += angle < wanted_angle ? 1 : 0;
  }
  std::vector<std::array<int, 2>> edges;
  for (const Triangle& t : garment.triangles) {
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      edges.push_back({a, b});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) {
    const double length = (garment.flat[a] - garment.flat[b]).norm() / garment.edge_length;
    quality.even += length > 0.6 && length < 1.5 ? 1 : 0;
  }
  quality.even /= static_cast<double>(edges.size());
  return quality;
}

Quality mesh(const Pattern& pattern, double edge_length, PanelMesh& garment) {
  std::vector<Remark> remarks;
  const std::clock_t start = std::clock();
  garment = mesh_panels(pattern, {edge_length, -1}, remarks);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  Quality quality = quality_of(garment);
  quality.seconds = seconds;
  return quality;
}

void print_folder(const std::string& argument, double edge_length) {
  std::vector<fs::path> files;
  if (fs::is_directory(argument)) {
    for (const auto& entry : fs::directory_iterator(argument)) {
      if (entry.path().extension() == ".json") files.push_back(entry.path());
    }
  } else {
    files.emplace_back(argument);
  }
  std::sort(files.begin(), files.end());
  std::vector<double> angles;
  std::vector<double> evens;
  int fine = 0;
  int even = 0;
  for (const fs::path& file : files) {
    try {
      std::vector<Remark> remarks;
      const Pattern pattern = without_left_out(read_pattern(file, remarks), remarks);
      check_pattern(pattern, remarks);
      PanelMesh garment;
      const Quality quality = mesh(pattern, edge_length, garment);
      angles.push_back(to_degrees(quality.smallest_angle));
      evens.push_back(quality.even);
      fine += quality.below == 0 ? 1 : 0;
      even += quality.even >= 0.99 ? 1 : 0;
    } catch (const Error& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
  }
  if (angles.empty()) return;
  const auto median = [](std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  };
  std::printf("| %s | %zu | %d | %.1f | %.1f | %d | %.1f %% | %.1f %% |\n",
              fs::path(argument).filename().c_str(), angles.size(), fine, median(angles),
              *std::min_element(angles.begin(), angles.end()), even, 100 * median(evens),
              100 * *std::min_element(evens.begin(), evens.end()));
}

void print_square(double side, double edge_length) {
  const std::string size = std::to_string(100 * side);
  std::string text = R"({"pattern": {"panels": {"square": {"vertices": [[0,0],[)";
  text.append(size).append(",0],[").append(size).append(",").append(size).append("],[0,");
  text.append(size).append(R"(]], "edges": [{"endpoints": [0,1]}, {"endpoints": [1,2]},)");
  text.append(R"({"endpoints": [2,3]}, {"endpoints": [3,0]}]}}, "stitches": []}, "properties": )");
  text.append(R"({"units_in_meter": 100}})");
  std::vector<Remark> remarks;
  PanelMesh garment;
  const Quality quality = mesh(parse_pattern(text, "square", remarks), edge_length, garment);
  std::printf("\n%zu points, %zu triangles: %.2f s, smallest angle %.1f degrees\n",
              garment.flat.size(), garment.triangles.size(), quality.seconds,
              to_degrees(quality.smallest_angle));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: bench_panel_meshes EDGE_MM FOLDER...\n");
    return 1;
  }
  const double edge_length = std::atof(argv[1]) / 1000;
  std::printf("| patterns | meshed | no angle below 25 | median angle | least | even | ");
  std::printf("median share of edges | least |\n|---|---|---|---|---|---|---|---|\n");
  for (int i = 2; i < argc; ++i) print_folder(argv[i], edge_length);
  print_square(0.9, 0.01);
  print_square(6.6, 0.01);
  return 0;
}
