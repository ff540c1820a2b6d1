// Scans as points: PLY, OBJ and tables, from the bytes to what is kept of them, and poses of scans.
#include <cmath>

#include "geometry/scan/floor_slope.h"
#include "geometry/scan/scan_parts.h"
#include "io/point_file.h"
#include "tests/fuzz/fuzz.h"

int main(int argc, char** argv) {
  using namespace toile;
  const std::filesystem::path folder =
      std::filesystem::path(TOILE_SOURCE_DIR) / "tests/fuzz/points";
  std::vector<std::filesystem::path> seeds;
  for (const char* name : {"ascii.ply", "little.ply", "big.ply", "points.obj", "faces.obj",
                           "table.xyz", "scanner.pts", "commas.asc", "pose.txt"}) {
    seeds.push_back(folder / name);
  }
  const std::vector<std::string> words = {"ply",
                                          "format ascii 1.0",
                                          "format binary_little_endian 1.0",
                                          "format binary_big_endian 1.0",
                                          "element vertex 4294967296",
                                          "element vertex -1",
                                          "element face 1000000000",
                                          "element edge 3",
                                          "property double x",
                                          "property list uchar int vertex_indices",
                                          "property list int int vertex_index",
                                          "property list float float x",
                                          "property uchar nx",
                                          "end_header",
                                          "v 1 2",
                                          "v nan inf 1e999",
                                          "vn 0 0 0",
                                          "f -1 -2 -3",
                                          "f 1//1 2//9 3",
                                          "f 99999999999 1 2",
                                          "l 1 2",
                                          "1e308 1e308 1e308",
                                          "0 0 0 0 0 1",
                                          "9999999999",
                                          "-1",
                                          "1 2",
                                          ";;;",
                                          "//",
                                          "\\",
                                          "\r",
                                          std::string(3, '\0'),
                                          "\xff\xfe"};
  const std::string program = argv[0];
  return fuzz::run(argc, argv, seeds, words, [&](const std::string& text) {
    std::string end = text.size() % 2 == 0 ? ".xyz" : ".pts";
    if (text.starts_with("ply")) end = ".ply";
    if (text.starts_with("o ") || text.find("v ") < 20) end = ".obj";
    const fuzz::ScratchFile file(program + end, text);
    if (text.size() < 60) {
      read_scan_pose(file.path);
      return;
    }
    const BodyFile body = read_body_file(file.path);
    floor_slope(body.soup.points, {});
    sort_scan(body.soup.points, {});
  });
}
