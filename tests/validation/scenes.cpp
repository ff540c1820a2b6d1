#include "tests/validation/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cloth/relaxation/relax.h"
#include "tests/cloth/panels.h"
#include "tests/support/held_nodes.h"
#include "tests/support/spring_motion.h"

namespace toile::test {

namespace {

/// Squares stood on their corners, halved along x. `columns` and `rows` of half diagonals, both
/// even.
PlanarMesh diamonds(double length, double width, int columns, int rows) {
  PlanarMesh mesh;
  std::vector<int> index((columns + 1) * (rows + 1), -1);
  const auto at = [&](int i, int j) -> int& { return index[j * (columns + 1) + i]; };
  for (int j = 0; j <= rows; ++j) {
    for (int i = j % 2; i <= columns; i += 2) {
      at(i, j) = static_cast<int>(mesh.points.size());
      mesh.points.emplace_back(length * i / columns, width * j / rows);
    }
  }
  for (int j = 0; j <= rows; ++j) {
    for (int i = j % 2; i + 2 <= columns; i += 2) {
      if (j < rows) mesh.triangles.push_back({at(i, j), at(i + 2, j), at(i + 1, j + 1)});
      if (j > 0) mesh.triangles.push_back({at(i, j), at(i + 1, j - 1), at(i + 2, j)});
    }
  }
  for (int j = 1; j < rows; j += 2) {
    mesh.triangles.push_back({at(0, j - 1), at(1, j), at(0, j + 1)});
    mesh.triangles.push_back({at(columns, j - 1), at(columns, j + 1), at(columns - 1, j)});
  }
  return mesh;
}

PlanarMesh free_mesh(double length, double width, double edge) {
  const int along = static_cast<int>(std::lround(length / edge));
  const int across = static_cast<int>(std::lround(width / edge));
  std::vector<Vec2> border;
  for (int i = 0; i < along; ++i) border.emplace_back(length * i / along, 0);
  for (int i = 0; i < across; ++i) border.emplace_back(length, width * i / across);
  for (int i = along; i > 0; --i) border.emplace_back(length * i / along, width);
  for (int i = across; i > 0; --i) border.emplace_back(0, width * i / across);
  return mesh_polygon(border, edge);
}

}  // namespace

std::string name_of(Cut cut) {
  return cut == Cut::structured ? "structured" : cut == Cut::turned ? "turned" : "unstructured";
}

PlanarMesh cut_rectangle(double length, double width, double edge, Cut cut) {
  if (cut == Cut::unstructured) return free_mesh(length, width, edge);
  if (cut == Cut::structured) {
    return grid(length, width, static_cast<int>(std::lround(length / edge)),
                static_cast<int>(std::lround(width / edge)));
  }
  const double pair = std::sqrt(2) * edge;
  return diamonds(length, width, 2 * static_cast<int>(std::lround(length / pair)),
                  2 * static_cast<int>(std::lround(width / pair)));
}

PlanarMesh mirrored(const PlanarMesh& right) {
  PlanarMesh mesh = right;
  std::vector<int> image;
  for (std::size_t p = 0; p < right.points.size(); ++p) {
    const Vec2& at = right.points[p];
    image.push_back(at.x() == 0 ? static_cast<int>(p) : static_cast<int>(mesh.points.size()));
    if (at.x() != 0) mesh.points.emplace_back(-at.x(), at.y());
  }
  for (const Triangle& t : right.triangles) {
    mesh.triangles.push_back({image[t[0]], image[t[2]], image[t[1]]});
  }
  return mesh;
}

void hold(GarmentModel& model, const std::function<bool(const Vec3&)>& held) {
  const int count = hold_nodes(model, held);
  ASSERT_GT(count, 0) << "nothing is held";
  ASSERT_LT(count, model.nodes / 2) << "the residual's median would be of what is held";
}

std::vector<Vec3> relaxed(const GarmentModel& model, double residual, int max_iterations) {
  RelaxOptions options;
  options.max_iterations = max_iterations;
  options.stop_median = residual;
  options.stop_rms = std::numeric_limits<double>::infinity();  // holds what is held
  std::vector<Vec3> x = model.start;
  const RelaxReport report = relax(model, options, x);
  EXPECT_TRUE(report.converged) << "median residual " << report.residual.median << " after "
                                << report.iterations << " iterations";
  return x;
}

std::vector<Vec3> sprung(const PanelMesh& garment, const GarmentModel& model,
                         const SpringRestOptions& options) {
  const auto [springs, mass] = HeldSprings(SpringSheet(garment, model), model);
  SpringMotion motion(springs, model.start, mass, options.drag, model.scene.gravity);
  const double dt = 0.9 * stable_step(springs, motion.inverse_mass, options.drag);
  double time = 0;
  for (int n = 0; time < options.seconds; ++n, time += dt) {
    motion.step(dt);
    if (n % 100 == 99 && motion.fastest() < options.speed) break;
  }
  EXPECT_LT(motion.fastest(), 100 * options.speed) << "is not at rest";
  return motion.x;
}

}  // namespace toile::test
