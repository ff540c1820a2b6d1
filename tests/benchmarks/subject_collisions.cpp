// Time of a step's collisions for a tube of cloth that lies on a body.
//   bench_subject_collisions [BODY] [THREADS]
#include "cloth/springs/subject_collisions.h"

#include <oneapi/tbb/global_control.h>

#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <numbers>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/intersections.h"
#include "geometry/surface_distance.h"
#include "io/mesh_file.h"

namespace {

using namespace toile;

constexpr double pi = std::numbers::pi;

/// `around` x `rows` cells, `off` metres outside the torso, from below the arms to the hips.
TriangleMesh tube(const SurfaceDistance& body, int around, int rows, double off) {
  TriangleMesh mesh;
  for (int r = 0; r <= rows; ++r) {
    const double y = 0.85 + 0.4 * r / rows;
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * pi * (i + 0.37 * r) / around;
      const Vec3 out(std::sin(angle), 0, std::cos(angle));
      Vec3 p = Vec3(0, y, 0.01);
      for (int k = 0; k < 200; ++k) {
        const double lacking = off - body.closest_point(p).distance;
        if (lacking < 1e-9) break;
        p += lacking * out;
      }
      mesh.points.push_back(p);
    }
  }
  for (int r = 0; r < rows; ++r) {
    for (int i = 0; i < around; ++i) {
      const int a = r * around + i;
      const int b = r * around + (i + 1) % around;
      mesh.triangles.push_back({a, b, a + around});
      mesh.triangles.push_back({b, b + around, a + around});
    }
  }
  return mesh;
}

void run(const char* name, const TriangleMesh& subject, const SurfaceDistance& body,
         const TriangleMesh& cloth, double friction, double press, const Vec3& slide) {
  constexpr double dt = 1e-4;
  std::vector<Vec3> x = cloth.points;
  std::vector<Vec3> v(x.size(), slide);
  const std::vector<double> inverse_mass(x.size(), 1 / 2e-5);
  SubjectCollisions collisions(subject, cloth.triangles);
  CollisionOptions options;
  options.friction = friction;
  std::vector<Vec3> inward;
  for (const Vec3& p : x) inward.push_back(-body.closest_point(p).normal);
  double seconds = 0;
  double processor = 0;
  double first = 0;
  CollisionCounts counts;
  constexpr int steps = 400;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      v[i] += dt * (Vec3(0, -9.81, 0) + press * inward[i]);
      // As if springs held the sheet's speed.
      v[i] += 0.02 * (slide - v[i]);
    }
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t used = std::clock();
    counts = collisions.respond(x, inverse_mass, dt, options, v);
    const double took =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    (step == 0 ? first : seconds) += took;
    if (step > 0) processor += static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += dt * v[i];
  }
  double least = 1;
  for (const Vec3& p : x) least = std::min(least, body.closest_point(p).distance);
  std::cout << name << ": " << 1000 * seconds / (steps - 1) << " ms a step, "
            << 1000 * processor / (steps - 1) << " of a processor (first " << 1000 * first
            << "), contacts " << counts.particle_facet << " particles, " << counts.vertex_triangle
            << " vertices, " << counts.edge_edge << " edges; nearest node " << 1000 * least
            << " mm, intersections " << intersections(subject, {x, cloth.triangles}).size() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  const TriangleMesh mesh = argc > 1 ? fan_triangles(read_mesh(argv[1])) : make_mannequin().surface;
  const std::size_t threads = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 2;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const SurfaceDistance body(mesh);
  const TriangleMesh cloth = tube(body, 100, 80, 0.0025);
  std::cout << mesh.triangles.size() << " facets, " << cloth.points.size() << " nodes, "
            << cloth.triangles.size() << " triangles, " << threads << " threads, dt 1e-4 s\n";
  run("at rest   ", mesh, body, cloth, 0.4, 30, Vec3::Zero());
  run("no friction", mesh, body, cloth, 0, 30, Vec3::Zero());
  run("sliding   ", mesh, body, cloth, 0, 30, Vec3(0, -1, 0));
  const TriangleMesh far = tube(body, 100, 80, 0.03);
  run("3 cm away ", mesh, body, far, 0.4, 0, Vec3::Zero());
}
