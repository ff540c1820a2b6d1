#include "cloth/model/nested_meshes.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "cloth/judge/measures.h"
#include "cloth/model/compile.h"
#include "geometry/intersections.h"
#include "pattern/mesh/nesting.h"
#include "tests/cloth/panels.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace nested_meshes_test {

PanelMesh bag(int subdivisions) {
  std::vector<Remark> remarks;
  return mesh_panels(samples::parse(samples::bag), {0.01, subdivisions}, remarks);
}

TEST(Levels, CoarserMeshesAreMeshesOfTheSameGarment) {
  const PanelMesh finest = bag(2);
  ASSERT_EQ(finest.subdivisions, 2);
  PanelMesh mesh = finest;
  while (mesh.subdivisions > 0) {
    const PanelMesh coarse = coarsen(mesh);
    EXPECT_EQ(coarse.subdivisions, mesh.subdivisions - 1);
    EXPECT_EQ(coarse.edge_length, 2 * mesh.edge_length);
    EXPECT_EQ(4 * coarse.triangles.size(), mesh.triangles.size());
    EXPECT_EQ(nesting_problem(coarse), std::nullopt);
    EXPECT_EQ(samples::sewn_fault(coarse, 0), "");
    ASSERT_EQ(coarse.panels.size(), finest.panels.size());
    int point = 0, triangle = 0;
    for (const MeshedPanel& panel : coarse.panels) {
      EXPECT_EQ(panel.first_point, point);
      EXPECT_EQ(panel.first_triangle, triangle);
      for (int t = triangle; t < triangle + panel.triangles; ++t) {
        for (const int p : coarse.triangles[t]) {
          EXPECT_GE(p, point);
          EXPECT_LT(p, point + panel.points);
        }
      }
      point += panel.points;
      triangle += panel.triangles;
    }
    EXPECT_EQ(static_cast<std::size_t>(point), coarse.flat.size());
    EXPECT_EQ(static_cast<std::size_t>(triangle), coarse.triangles.size());
    // Its corners lie on the pattern's outline; only the curved bottom's chords cost area.
    const std::vector<double> areas = panel_areas(coarse);
    const std::vector<double> fine_areas = panel_areas(mesh);
    for (std::size_t p = 0; p < areas.size(); ++p) {
      EXPECT_NEAR(areas[p], fine_areas[p], 2e-3 * fine_areas[p]);
    }
    mesh = coarse;
  }
}

TEST(Levels, CoarsePointsAreFinePoints) {
  const PanelMesh fine = bag(1);
  const PanelMesh coarse = coarsen(fine);
  for (std::size_t t = 0; t < coarse.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const int p = coarse.triangles[t][i];
      const int child = fine.triangles[4 * t + i][i];
      EXPECT_EQ(coarse.flat[p], fine.flat[child]);
      EXPECT_EQ(coarse.placed[p], fine.placed[child]);
    }
  }
}

TEST(Levels, SeamSidesKeepEqualNumbersOfPoints) {
  PanelMesh mesh = bag(2);
  while (mesh.subdivisions > 0) {
    const PanelMesh coarse = coarsen(mesh);
    ASSERT_EQ(coarse.seams.size(), mesh.seams.size());
    for (std::size_t s = 0; s < coarse.seams.size(); ++s) {
      const MeshedSeam& fine_seam = mesh.seams[s];
      const MeshedSeam& seam = coarse.seams[s];
      EXPECT_EQ(seam.a.size(), seam.b.size());
      EXPECT_EQ(2 * seam.a.size() - 1, fine_seam.a.size());
      EXPECT_EQ(seam.name, fine_seam.name);
      // Every other point of the finer seam, so both ends too.
      for (std::size_t i = 0; i < seam.a.size(); ++i) {
        EXPECT_EQ(coarse.flat[seam.a[i]], mesh.flat[fine_seam.a[2 * i]]);
        EXPECT_EQ(coarse.flat[seam.b[i]], mesh.flat[fine_seam.b[2 * i]]);
      }
    }
    mesh = coarse;
  }
}

TEST(Levels, RefiningKeepsTheSurface) {
  const PanelMesh fine = bag(1);
  const PanelMesh coarse = coarsen(fine);
  const GarmentModel coarse_program = compile(coarse, {}, coarse.placed);
  const GarmentModel fine_program = compile(fine, {}, fine.placed);
  // A crumpled bag.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Vec3> x = coarse_program.start;
  for (Vec3& p : x) p += 0.002 * Vec3(unit(random), unit(random), unit(random));
  const TriangleMesh before{x, coarse_program.node_triangles};
  ASSERT_TRUE(self_intersections(before).empty());

  const std::vector<Vec3> finer = refine_positions(coarse, coarse_program.node_of_point, x, fine,
                                                   fine_program.node_of_point, fine_program.nodes);
  ASSERT_EQ(finer.size(), static_cast<std::size_t>(fine_program.nodes));
  const TriangleMesh after{finer, fine_program.node_triangles};
  std::vector<int> set(finer.size(), 0);
  for (std::size_t t = 0; t < before.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const Vec3& a = x[before.triangles[t][i]];
      const Vec3& b = x[before.triangles[t][(i + 1) % 3]];
      const int corner = after.triangles[4 * t + i][i];
      const int middle = after.triangles[4 * t + 3][i];
      EXPECT_EQ(finer[corner], a);
      EXPECT_LT((finer[middle] - 0.5 * (a + b)).norm(), 1e-15);
      set[corner] = set[middle] = 1;
    }
  }
  EXPECT_EQ(std::count(set.begin(), set.end(), 1), fine_program.nodes);
  EXPECT_TRUE(self_intersections(after).empty());
}

TEST(Levels, SeamsLeftOpenAreOpenOnEveryLevel) {
  PanelMesh finest = bag(2);
  std::vector<PanelMesh> meshes = {finest, coarsen(finest), coarsen(coarsen(finest))};
  const MeshedSeam& seam = meshes.back().seams.front();
  ASSERT_GT(seam.a.size(), 3U);
  std::vector<char> unsewn(meshes.back().flat.size(), 0);
  for (const std::size_t i : {0, 1}) unsewn[seam.a[i]] = unsewn[seam.b[i]] = 1;
  leave_open(meshes, unsewn);
  // Open from the seam's start to before the third point of the coarsest mesh.
  std::size_t open = 2;
  for (std::size_t depth = 3; depth-- > 0; open *= 2) {
    const MeshedSeam& here = meshes[depth].seams.front();
    const GarmentModel model = compile(meshes[depth], {}, meshes[depth].placed);
    for (std::size_t i = 0; i < here.a.size(); ++i) {
      EXPECT_EQ(model.node_of_point[here.a[i]] != model.node_of_point[here.b[i]], i < open)
          << depth << ' ' << i;
    }
  }
}

TEST(Levels, MovedPanelsAreMovedOnEveryLevel) {
  PanelMesh fine = bag(1);
  const PanelMesh coarse = coarsen(fine);
  const auto moved = [](const PanelMesh& garment) {
    std::vector<Vec3> placed = garment.placed;
    for (const MeshedPanel& panel : garment.panels) {
      const Vec3 displacement(0.1, panel.first_point > 0 ? -0.2 : 0.3, 0);
      for (int p = panel.first_point; p < panel.first_point + panel.points; ++p)
        placed[p] += displacement;
    }
    return placed;
  };
  const std::vector<Vec3> wanted = moved(fine);
  const std::vector<Vec3> placed = refine_placed(coarse, moved(coarse), fine);
  // On the curved bottom too, where middles of edges do not lie.
  for (std::size_t p = 0; p < placed.size(); ++p) {
    ASSERT_LT((placed[p] - wanted[p]).norm(), 1e-15) << p;
  }
}

}  // namespace nested_meshes_test
}  // namespace toile
