#include "cloth/relaxation/block_stiffness.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <memory>

#include "cloth/model/compile.h"
#include "cloth/model/stretch.h"
#include "tests/cloth/panels.h"

namespace toile {
namespace block_stiffness_test {

Eigen::Matrix3d matrix(const StiffnessBlock& s) {
  return Eigen::Matrix3d{{s[0], s[1], s[2]}, {s[1], s[3], s[4]}, {s[2], s[4], s[5]}};
}

/// A sheet whose yarns differ everywhere, and are not parallel to the axes.
struct Sheet {
  explicit Sheet(double stretch_stiffness = 2000, double shear_stiffness = 200) {
    Scene scene;
    scene.fabric.stretch_warp = stretch_stiffness;
    scene.fabric.stretch_weft = std::min(stretch_stiffness, scene.fabric.stretch_weft);
    scene.fabric.shear = shear_stiffness;
    PanelMesh garment = test::flat_panel(test::grid(0.08, 0.06, 4, 3));
    garment.panels[0].grain = 0.4;
    model = compile(garment, scene, garment.placed);
    blocks = std::make_unique<BlockStiffness>(model);
  }

  Eigen::VectorXd forces(const std::vector<Vec3>& x) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(3 * model.nodes);
    for (std::size_t t = 0; t < model.stretch.size(); ++t) {
      const auto& [a, b, c] = model.node_triangles[t];
      const auto on = stretch_forces(model.stretch[t], {}, x[a], x[b], x[c]);
      sum.segment<3>(3 * a) += on[0];
      sum.segment<3>(3 * b) += on[1];
      sum.segment<3>(3 * c) += on[2];
    }
    return sum;
  }

  /// Minus the derivative of the forces by the positions, N/m.
  Eigen::MatrixXd hessian(std::vector<Vec3> x) const {
    constexpr double h = 1e-6;
    Eigen::MatrixXd result(3 * model.nodes, 3 * model.nodes);
    for (int i = 0; i < result.cols(); ++i) {
      double& place = x[i / 3][i % 3];
      const double was = place;
      place = was + h;
      const Eigen::VectorXd above = forces(x);
      place = was - h;
      result.col(i) = (forces(x) - above) / (2 * h);
      place = was;
    }
    return 0.5 * (result + result.transpose());
  }

  GarmentModel model;
  std::unique_ptr<BlockStiffness> blocks;
};

// Then a step is as long as the forces allow, and no longer, whichever direction the cloth has.
TEST(BlockStiffness, BoundsTheStiffnessOfClothThatIsBentPulledAndSheared) {
  struct Case {
    double stretch_stiffness, shear_stiffness, pulled, along, sheared;
  };
  for (const auto& [stretch_stiffness, shear_stiffness, pulled, along, sheared] :
       {Case{2000, 200, 1, 1, 0.1}, Case{2000, 200, 1.1, 1, 0.1}, Case{0.01, 3000, 1, 3, -2}}) {
    Sheet sheet(stretch_stiffness, shear_stiffness);
    std::vector<Vec3> x = sheet.model.start;
    for (Vec3& p : x) {
      p = pulled *
          Vec3(along * (p.x() + sheared * p.y()), p.y(), 0.01 * std::sin(60 * p.x()) + 0.2 * p.y());
    }
    sheet.blocks->update(as_vec4(x));
    Eigen::MatrixXd bound = Eigen::MatrixXd::Zero(3 * sheet.model.nodes, 3 * sheet.model.nodes);
    for (int n = 0; n < sheet.model.nodes; ++n) {
      bound.block<3, 3>(3 * n, 3 * n) = matrix(sheet.blocks->of_nodes()[n]);
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> shares(sheet.hessian(x), bound,
                                                                           Eigen::EigenvaluesOnly);
    EXPECT_LE(shares.eigenvalues().maxCoeff(), 1 + 1e-6) << pulled << ' ' << sheared;
    EXPECT_GT(shares.eigenvalues().maxCoeff(), 0.5) << pulled << ' ' << sheared;
  }
}

TEST(BlockStiffness, IsOnlyTheTensionSquareToAFlatSheet) {
  Sheet sheet;
  std::vector<Vec3> x = sheet.model.start;
  sheet.blocks->update(as_vec4(x));
  for (int n = 0; n < sheet.model.nodes; ++n) {
    const Eigen::Matrix3d at = matrix(sheet.blocks->of_nodes()[n]);
    EXPECT_NEAR(at(2, 2), 0, 1e-9);
    // In the plane of the cloth the bound is not smaller than the isotropic one.
    const double in_plane = at(0, 0) + at(1, 1);
    EXPECT_GT(in_plane, sheet.model.stretch_diagonal[n]);
  }
  for (Vec3& p : x) p *= 1.02;
  sheet.blocks->update(as_vec4(x));
  for (int n = 0; n < sheet.model.nodes; ++n) {
    const double across = matrix(sheet.blocks->of_nodes()[n])(2, 2);
    EXPECT_GT(across, 0.005 * sheet.model.stretch_diagonal[n]);
    EXPECT_LT(across, 0.02 * sheet.model.stretch_diagonal[n]);
  }
}

TEST(BlockStiffness, TakesAForceWhereTheStiffnessLetsIt) {
  StiffnessBlock s = {5, 1, -0.5, 4, 0.3, 6};
  const Vec3 force(0.3, -0.2, 0.7);
  const Vec3 displacement = as_vec3(solve_block(s, 2, as_vec4(force)));
  const Eigen::Matrix3d held = matrix(s) + 2 * Eigen::Matrix3d::Identity();
  EXPECT_LT((held * displacement - force).norm(), 1e-15);
  // A zero matrix gives no displacement.
  EXPECT_EQ(as_vec3(solve_block({}, 0, as_vec4(force))), Vec3::Zero());
}

TEST(SolveBlocks, GivesTheBitsOfOneAtATime) {
  const std::vector<StiffnessBlock> blocks = {
      {3, 0.1, 0.2, 4, 0.3, 5}, {2, -1, 0.5, 2, 0.1, 7}, {0, 0, 0, 0, 0, 0}};
  const Vec4s forces = {Vec4{0.3, -0.2, 0.7, 0}, Vec4{1, 2, 3, 0}, Vec4{0.1, 0.2, 0.3, 0}};
  for (const double more : {0.0, 0.7}) {  // with 0 the third is singular
    const Places at(0, 3);
    Vec4 solved[4];
    store_rows(solve_blocks(blocks, at, repeated(more), at.of(forces)), solved, {0, 1, 2, 3});
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      EXPECT_EQ(as_vec3(solved[i]), as_vec3(solve_block(blocks[i], more, forces[i])));
    }
  }
}

}  // namespace block_stiffness_test
}  // namespace toile
