// The energy of what bends in a model, from what its header says of it.
#pragma once

#include <array>
#include <vector>

#include "cloth/model/garment_model.h"

namespace toile::test {

/// J, with the material points at `points`.
inline double bend_energy(const GarmentModel& model, const std::vector<Vec3>& points) {
  double energy = 0;
  for (const BendTriangle& triangle : model.bend_triangles) {
    std::array<Vec3, 3> jumps = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    for (int i = 0; i < 3; ++i) {
      if (triangle.hinges[i] < 0) continue;
      const BendHinge& hinge = model.bend[triangle.hinges[i]];
      for (int k = 0; k < 4; ++k) jumps[i] += hinge.weights[k] * points[hinge.points[k]];
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        energy += 0.5 * triangle.stiffness(i, j) * jumps[i].dot(jumps[j]);
      }
    }
  }
  return energy;
}

}  // namespace toile::test
