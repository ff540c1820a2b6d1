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
using namespace toile;
// scan_dev BODY POINTS NOISE SEED_FROM SEED_TO OUT
int main(int, char** argv) {
  const std::string name = argv[1];
  TriangleMesh body;
  if (name == "mannequin")
    body = make_mannequin().surface;
  else {
    body = clean_body(read_mesh("/work/shared/data/bodies/" + name + ".obj"), "body", {}).mesh;
  }
  const auto values = [](const TriangleMesh& mesh) {
    std::map<std::string, double> v;
    const BodyShape shape = find_landmarks(mesh, "body");
    for (const Measure& m : measure_body(shape))
      if (m.value) v[m.name] = *m.value;
    const Landmarks marks = given_landmarks(shape);
    for (const Landmark& l : marks)
      if (l.place) {
        v["@" + l.name] = l.place->y();
        v["@" + l.name + ".x"] = l.place->x();
      }
    return v;
  };
  const auto truth = values(body);
  write_mesh(std::string(argv[6]) + "_truth.ply", body);
  for (int seed = std::atoi(argv[4]); seed <= std::atoi(argv[5]); ++seed) {
    test::Scanner scanner;
    scanner.points = std::atoi(argv[2]);
    scanner.noise = std::atof(argv[3]) / 1000;
    scanner.seed = seed;
    const test::Scan scan = test::scan_body(body, scanner);
    auto t0 = std::chrono::steady_clock::now();
    const ReconstructedScan made = reconstruct_scan(scan.cloud, "scan");
    double secs = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
    PolygonSoup soup;
    soup.points = made.mesh.points;
    for (const Triangle& t : made.mesh.triangles) soup.polygons.push_back({t[0], t[1], t[2]});
    CleanOptions options;
    options.metres_per_unit = 1;
    options.up = AxisDirection{1, 1};
    options.front = AxisDirection{2, 1};
    const CleanBody cleaned = clean_body(soup, "body", options);
    if (!cleaned.skeleton) std::printf("no skeleton: %s\n", cleaned.report.no_skeleton.c_str());
    write_mesh(std::string(argv[6]) + "_" + std::to_string(seed) + ".ply", made.mesh);
    const auto v = values(made.mesh);
    std::printf("seed %d, %.1f s:", seed, secs);
    for (const char* n :
         {"@crotch", "left_upper_thigh", "right_upper_thigh", "left_mid_thigh", "right_mid_thigh",
          "hip", "@left_armpit", "@right_armpit", "left_upper_arm", "right_upper_arm", "bust"}) {
      const auto a = v.find(n);
      const auto b = truth.find(n);
      if (a != v.end() && b != truth.end())
        std::printf(" %s %+.1f", n, 1000 * (a->second - b->second));
    }
    std::printf("\n");
    if (std::getenv("AGREE")) {
      const double reach = std::max(0.008, 2.5 * made.report.spacing);
      const test::Agreement a = test::agreement(made.mesh, body, scan, reach);
      std::printf("  seen %.2f %.2f worst %.1f unseen %.2f: %.1f worst %.1f\n", 100 * a.seen_2mm,
                  100 * a.seen_5mm, 1000 * a.seen_worst, 100 * a.unseen, 100 * a.unseen_10mm,
                  1000 * a.unseen_worst);
      // where
      const ScanCells cells(scan.truth, reach);
      std::vector<std::vector<int>> in(cells.cells());
      for (size_t i = 0; i < scan.truth.size(); ++i) in[cells.cell_of()[i]].push_back(i);
      const SurfaceDistance to_made(made.mesh), to_body(body);
      for (int way = 0; way < 2; ++way) {
        std::map<std::array<int, 3>, std::array<double, 3>> bins;
        for (const Vec3& p : test::spread_points(way ? made.mesh : body, 40000)) {
          const SurfacePoint o = (way ? to_body : to_made).closest_point(p);
          const double off = std::abs(o.distance);
          const Vec3 t = way ? o.point : p;
          bool seen = false;
          cells.near(t, 1, [&](int c) {
            for (int i : in[c]) seen = seen || (scan.truth[i] - t).norm() < reach;
          });
          if (off < (seen ? 0.005 : 0.01)) continue;
          auto& b = bins[{int(std::floor(t.x() / 0.1)), int(std::floor(t.y() / 0.1)),
                          int(std::floor(t.z() / 0.1))}];
          b[seen ? 0 : 1] += 1;
          b[2] = std::max(b[2], off);
        }
        for (auto& [k, b] : bins)
          if (b[0] + b[1] > 4)
            std::printf("    %s x %.1f y %.1f z %.1f: seen %.0f unseen %.0f of 40000, worst %.1f\n",
                        way ? "made" : "true", k[0] * .1, k[1] * .1, k[2] * .1, b[0], b[1],
                        1000 * b[2]);
      }
    }
    std::fflush(stdout);
  }
}
