#include "cloth/dress.h"

#include <gtest/gtest.h>

#include <set>

#include "geometry/distance_grid.h"
#include "tests/pattern/samples.h"
#include "tests/support/shapes.h"

namespace toile {
namespace {

/// Two squares of 20 cm that are sewn along one side, above a box.
PanelMesh two_squares() {
  const std::string square = "[0,0],[20,0],[20,20],[0,20]";
  std::vector<Remark> remarks;
  const Pattern pattern = samples::parse(
      samples::file(samples::polygon("left", square) + "," + samples::polygon("right", square),
                    R"([{"panel": "left", "edge": 1}, {"panel": "right", "edge": 3}])"));
  check_pattern(pattern, remarks);
  PanelMesh mesh = mesh_panels(pattern, {.edge_length = 0.01}, remarks);
  for (const MeshedPanel& panel : mesh.panels) {
    const double shift = panel.name == "left" ? -0.205 : 0.005;
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      mesh.placed[p] = Vec3(mesh.flat[p].x() + shift, 0.01, 0.1 - mesh.flat[p].y());
    }
  }
  return mesh;
}

TEST(Dress, ProgressGoesFromNothingToAllAndNeverBack) {
  const PanelMesh garment = two_squares();
  ASSERT_GT(garment.subdivisions, 0);
  const DistanceGrid body{BodyDistance(test::box({-0.3, -0.1, -0.2}, {0.3, 0, 0.2}))};
  Scene scene;
  scene.body = &body;
  std::set<std::string> stages;
  std::set<const PanelMesh*> meshes;
  std::vector<double> progress;
  DressOptions options;
  options.max_iterations = 400;
  const DressResult result = dress(garment, scene, options, [&](const DressFrame& frame) {
    stages.insert(frame.stage);
    meshes.insert(&frame.mesh);
    progress.push_back(frame.progress);
  });
  EXPECT_EQ(stages, (std::set<std::string>{"position", "wrap", "sew", "drape"}));
  EXPECT_GT(meshes.size(), 1U);
  EXPECT_EQ(progress.front(), 0);
  EXPECT_EQ(progress.back(), 1);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  // Not all of it at once.
  for (std::size_t i = 1; i < progress.size(); ++i) {
    EXPECT_LT(progress[i] - progress[i - 1], 0.5) << i;
  }
}

}  // namespace
}  // namespace toile
