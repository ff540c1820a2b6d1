#include "tests/benchmarks/work_precision/case.h"

#include <sys/resource.h>

#include <chrono>

namespace toile::precision {

namespace {

double wall_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double processor_now() {
  rusage used = {};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

}  // namespace

std::string end_of(const Outcome& outcome) {
  if (!outcome.sewn) return "not sewn";
  return outcome.converged ? "at rest" : "not at rest";
}

Stopwatch::Stopwatch() : wall_(wall_now()), processor_(processor_now()) {}

void Stopwatch::stop(Outcome& outcome) const {
  outcome.wall = wall_now() - wall_;
  outcome.processor = processor_now() - processor_;
}

std::vector<Vec3> material_points(const PanelMesh& garment, const std::vector<Vec3>& nodes,
                                  const std::vector<Triangle>& triangles) {
  std::vector<Vec3> points(garment.flat.size(), Vec3::Zero());
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) points[garment.triangles[t][k]] = nodes[triangles[t][k]];
  }
  return points;
}

}  // namespace toile::precision
