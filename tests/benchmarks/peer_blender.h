// Blender's cloth on a garment of ours, judged by our tests.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cloth/judge/verdict.h"
#include "io/mesh_file.h"
#include "io/obj.h"
#include "pattern/file/garment_file.h"
#include "tests/benchmarks/prepare.h"

namespace toile::pipeline {

struct PeerMeasurements {
  Run run;
  double strain_p99 = 0;  ///< off the seams, a fraction
  double gap_mm = 0;      ///< widest at a seam
  int body = 0;           ///< pairs of triangles that intersect
  int self = 0;
};

inline std::optional<fs::path> find_in_path(const std::string& name) {
  const char* folders = std::getenv("PATH");
  std::istringstream stream(folders != nullptr ? folders : "");
  for (std::string folder; std::getline(stream, folder, ':');) {
    if (!folder.empty() && fs::exists(fs::path(folder) / name)) return fs::path(folder) / name;
  }
  return std::nullopt;
}

/// Joins each pair of seam points in its middle. A peer whose seams stay a little open is so not
/// charged with two sides that cross each other.
inline DressedGarment welded(const PanelMesh& garment, const std::vector<Vec3>& points) {
  std::vector<int> root(points.size());
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = static_cast<int>(i);
  const auto find = [&](int i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) root[find(seam.a[i])] = find(seam.b[i]);
  }
  std::vector<int> node_of_root(points.size(), -1);
  std::vector<int> uses;
  std::vector<Vec3> nodes;
  std::vector<int> node(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    int& n = node_of_root[find(static_cast<int>(i))];
    if (n < 0) {
      n = static_cast<int>(nodes.size());
      nodes.push_back(Vec3::Zero());
      uses.push_back(0);
    }
    nodes[n] += points[i];
    ++uses[n];
    node[i] = n;
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n] /= uses[n];
  std::vector<Triangle> triangles;
  for (const Triangle& t : garment.triangles) {
    triangles.push_back({node[t[0]], node[t[1]], node[t[2]]});
  }
  return as_dressed(garment, std::move(nodes), std::move(triangles));
}

/// Runs peers/blender_cloth.py on `threads` threads, the panels raised by `lift` metres. Throws
/// when it fails or takes too long.
inline PeerMeasurements run_blender(const fs::path& blender, const fs::path& garment_file,
                                    const fs::path& body_file, const fs::path& output, double lift,
                                    int threads, int seconds) {
  const fs::path script = fs::path(TOILE_SOURCE_DIR) / "tests/benchmarks/peers/blender_cloth.py";
  const fs::path json = garment_json_path(garment_file);
  PeerMeasurements figures;
  figures.run =
      run(blender.string(),
          {"-b", "-t", std::to_string(threads), "-P", script.string(), "--", garment_file.string(),
           json.string(), body_file.string(), output.string(), "--lift", std::to_string(lift)},
          seconds);
  if (figures.run.exit_code != 0) throw std::runtime_error("blender: " + complaint(figures.run));
  const PanelMesh garment = read_garment(garment_file);
  const std::vector<Vec3> points = read_obj(output).points;
  const TriangleMesh body = fan_triangles(read_mesh(body_file));
  const GarmentMeasurements as_is =
      measure_garment(garment, as_dressed(garment, points, garment.triangles));
  const Judgement judgement = judge(garment, welded(garment, points), body, nullptr, {});
  figures.strain_p99 = as_is.strain_off_seams.p99;
  figures.gap_mm = 1000 * as_is.seams.max_gap;
  figures.body = judgement.body_intersections;
  figures.self = judgement.self_intersections;
  return figures;
}

}  // namespace toile::pipeline
