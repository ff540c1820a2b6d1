// The rows that the solver bends by, against the energy that the model's header states.
#include "cloth/model/bending_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numeric>
#include <random>

#include "cloth/model/compile.h"
#include "tests/cloth/bend_energy.h"
#include "tests/cloth/panels.h"

namespace toile {
namespace bending_matrix_test {

class BendRowsOf : public testing::Test {
 protected:
  BendRowsOf() {
    // Two unstructured panels sewn together, of different fabrics.
    std::vector<Vec2> border = {{0, 0},       {0.01, 0},     {0.02, 0},    {0.03, 0}, {0.03, 0.011},
                                {0.03, 0.02}, {0.018, 0.02}, {0.01, 0.02}, {0, 0.02}, {0, 0.011}};
    const PlanarMesh mesh = mesh_polygon(border, 0.01);
    test::add_panel(garment, "left", mesh, [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); });
    test::add_panel(garment, "right", mesh,
                    [](const Vec2& p) { return Vec3(p.x() + 0.05, p.y(), 0); });
    garment.panels[1].grain = 0.5;
    garment.panels[1].fabric = "lining";
    std::vector<int> left, right;
    for (const double y : {0.0, 0.011, 0.02}) {
      left.push_back(point(0, {0.03, y}));
      right.push_back(point(1, {0, y}));
    }
    garment.seams = {test::seam("middle", left, right)};
    scene.fabric.bending_warp = 4e-5;
    scene.fabrics["lining"].bending_weft = 2e-6;
    model = compile(garment, scene, garment.placed);
    points.resize(garment.flat.size());
    std::iota(points.begin(), points.end(), 0);
  }

  int point(int panel, const Vec2& at) const {
    for (int p = 0; p < garment.panels[panel].points; ++p) {
      const int of_panel = garment.panels[panel].first_point + p;
      if ((garment.flat[of_panel] - at).norm() < 1e-9) return of_panel;
    }
    ADD_FAILURE() << "no point at " << at.transpose();
    return 0;
  }

  /// The whole matrix, with `share` of what bends across seams.
  Eigen::MatrixXd matrix(const std::vector<int>& vertex, int vertices, double share) const {
    const BendMatrix rows = bend_matrix(model, vertex, vertices, true);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(vertices, vertices);
    for (const auto& [part, scale] : {std::pair(&rows.inside, 1.0), {&rows.seams, share}}) {
      for (int v = 0; v < vertices; ++v) {
        for (int i = part->first[v]; i < part->first[v + 1]; ++i) {
          matrix(v, v) += scale * part->stiffness[i];
          matrix(v, part->vertex[i]) -= scale * part->stiffness[i];
        }
      }
    }
    return matrix;
  }

  PanelMesh garment;
  Scene scene;
  GarmentModel model;
  std::vector<int> points;
};

TEST_F(BendRowsOf, SewnPanelsHaveTheirEnergy) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-0.01, 0.01);
  const int count = static_cast<int>(points.size());
  std::vector<Vec3> x(count);
  for (Vec3& p : x) p = Vec3(unit(random), unit(random), unit(random));
  const Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>> places(x[0].data(), 3, count);
  const double by_rows = 0.5 * (places * matrix(points, count, 1) * places.transpose()).trace();
  EXPECT_NEAR(by_rows, test::bend_energy(model, x), 1e-12 * by_rows);
}

TEST_F(BendRowsOf, AnOpenSeamIsNotFelt) {
  const int count = static_cast<int>(points.size());
  const int left = garment.panels[0].points;
  const Eigen::MatrixXd open = matrix(points, count, 0);
  EXPECT_TRUE(open.topRightCorner(left, count - left).isZero(0));
  EXPECT_FALSE(matrix(points, count, 1).topRightCorner(left, count - left).isZero(0));
}

// So steps are bounded, and closing a seam gives no energy away, however far it is closed.
TEST_F(BendRowsOf, AreSemidefiniteAndBoundedHoweverFarSeamsAreClosed) {
  const auto values_of = [](const Eigen::MatrixXd& matrix) {
    EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-12 * matrix.norm());
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
  };
  const Eigen::Map<const Eigen::VectorXd> bound(model.bend_diagonal.data(), model.nodes);
  const Eigen::VectorXd scale = bound.cwiseSqrt().cwiseInverse();
  for (const double share : {0.0, 0.3, 1.0}) {
    const auto of_points = values_of(matrix(points, static_cast<int>(points.size()), share));
    EXPECT_GT(of_points.minCoeff(), -1e-12 * of_points.maxCoeff()) << share;
    const Eigen::MatrixXd of_nodes = matrix(model.node_of_point, model.nodes, share);
    const auto scaled = values_of(scale.asDiagonal() * of_nodes * scale.asDiagonal());
    EXPECT_GT(scaled.minCoeff(), -1e-12) << share;
    EXPECT_LE(scaled.maxCoeff(), 1 + 1e-12) << share;
    // Not many times less than what would do.
    EXPECT_GT(scaled.maxCoeff(), 0.3) << share;
  }
}

}  // namespace bending_matrix_test
}  // namespace toile
