#include "geometry/body/measure_errors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "geometry/parallel.h"

namespace toile {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Metres, or degrees: what a careful measurer is off by.
double of_measurer(const Measure& measure) {
  constexpr double large_girth = 0.5;  // metres
  if (measure.is_angle) return 0.5;
  if (measure.is_girth) return *measure.value > large_girth ? 0.009 : 0.004;
  return measure.name.find("height") != std::string::npos ? 0.004 : 0.005;
}

TriangleMesh leaning(TriangleMesh body, double angle) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vec3::UnitX()).toRotationMatrix();
  for (Vec3& point : body.points) point = turn * point;
  return body;
}

TriangleMesh noisy(TriangleMesh body) {
  constexpr double deviation = 0.0005;  // metres, of each coordinate
  const double most = deviation * std::sqrt(3.0);
  std::mt19937_64 random(1);
  const auto draw = [&] {
    return most *
           (2.0 * static_cast<double>(random() >> 11U) / static_cast<double>(1ULL << 53U) - 1.0);
  };
  for (Vec3& point : body.points) {
    for (int k = 0; k < 3; ++k) point[k] += draw();
  }
  return body;
}

}  // namespace

void estimate_errors(const TriangleMesh& body, const std::string& name,
                     std::vector<Measure>& measures) {
  std::array<std::vector<Measure>, 3> others;
  parallel_for(others.size(), [&](std::size_t i) {
    const TriangleMesh other = i == 2 ? noisy(body) : leaning(body, i == 0 ? degree : -degree);
    others[i] = measure_body(find_landmarks(other, name));
  });
  for (Measure& measure : measures) {
    if (!measure.value) continue;
    double moves = 0;
    for (const std::vector<Measure>& other : others) {
      const Measure* same = find_measure(other, measure.name);
      const bool is_there = same != nullptr && same->value;
      const double lost = measure.is_angle ? 2 : 0.02;
      moves = std::max(moves, is_there ? std::abs(*same->value - *measure.value) : lost);
    }
    measure.plus_minus = of_measurer(measure) + moves;
  }
}

}  // namespace toile
