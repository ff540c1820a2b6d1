#include "geometry/body/sheet.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "geometry/error.h"

namespace toile {

void refuse_sheet(const std::vector<Vec3>& points, const std::string& name) {
  // The mannequin has 0.15 to 0.17, its front half alone 0.08, a wall with 5 mm of noise 0.01.
  // Half lets wavy walls through, double leaves persons little room.
  constexpr double thinnest = 0.03;
  const auto count = static_cast<double>(points.size());
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / count;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) spread += (p - mean) * (p - mean).transpose() / count;
  const Vec3 squares = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues();
  const double share = std::sqrt(std::max(squares[0], 0.0) / std::max(squares[2], 1e-300));
  if (!(share < thinnest)) return;
  throw Error(
      name,
      "is a flat sheet, " + number_text(100 * share, 2) + " % as thick as it is long: no body",
      "give the surface of a whole body");
}

}  // namespace toile
