#include "geometry/body/skin_weights.h"

#include <Eigen/SparseCholesky>
#include <algorithm>

#include "geometry/error.h"
#include "geometry/laplacian.h"

namespace toile {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

}  // namespace

SkinWeights skin_weights(const TriangleMesh& body, const std::vector<int>& cores) {
  const auto n = static_cast<Eigen::Index>(body.points.size());
  SkinWeights weights = SkinWeights::Zero(n, bone_count);
  std::vector<int> row_of(body.points.size(), -1);
  int free = 0;
  for (std::size_t i = 0; i < cores.size(); ++i) {
    if (cores[i] == SkinCores::no_bone) {
      row_of[i] = free++;
    } else {
      weights(static_cast<Eigen::Index>(i), cores[i]) = 1;
    }
  }
  if (free == 0) return weights;

  const Sparse energy = cotangent_laplacian(body);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd known = Eigen::MatrixXd::Zero(free, bone_count);
  for (int column = 0; column < energy.outerSize(); ++column) {
    for (Sparse::InnerIterator at(energy, column); at; ++at) {
      const int row = row_of[at.row()];
      if (row < 0) continue;
      if (row_of[column] >= 0) {
        entries.emplace_back(row, row_of[column], at.value());
      } else {
        known(row, cores[column]) -= at.value();
      }
    }
  }
  Sparse system(free, free);
  system.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Sparse> solver(system);
  if (solver.info() != Eigen::Success) {
    throw Error("skin", "the weights of the bones can't be solved for", "let clean-body repair it");
  }
  const Eigen::MatrixXd found = solver.solve(known);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (row_of[i] < 0) continue;
    const Eigen::ArrayXd harmonic = found.row(row_of[i]).array().max(0).min(1);
    const Eigen::RowVectorXd smooth = (harmonic.square() * (3 - 2 * harmonic)).matrix();
    const double sum = smooth.sum();
    if (!(sum > 0)) {
      throw Error("skin", "a part of it hangs on no bone", "let clean-body remove it");
    }
    weights.row(i) = smooth / sum;
  }
  return weights;
}

}  // namespace toile
