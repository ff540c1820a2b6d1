// Sheets without springs, stepped as the mass-spring cloth is: what collisions alone do to them.
#pragma once

#include <vector>

#include "cloth/springs/subject_collisions.h"
#include "geometry/types.h"

namespace toile::test {

/// A rectangle in the plane y = `height`, `columns` x `rows` cells of side `cell`, its middle over
/// the origin; facing up.
inline TriangleMesh level_sheet(int columns, int rows, double cell, double height) {
  TriangleMesh mesh;
  for (int r = 0; r <= rows; ++r) {
    for (int c = 0; c <= columns; ++c) {
      mesh.points.emplace_back((c - columns / 2.0) * cell, height, (r - rows / 2.0) * cell);
    }
  }
  const auto at = [&](int c, int r) { return r * (columns + 1) + c; };
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      mesh.triangles.push_back({at(c, r), at(c, r + 1), at(c + 1, r)});
      mesh.triangles.push_back({at(c + 1, r), at(c, r + 1), at(c + 1, r + 1)});
    }
  }
  return mesh;
}

/// Nodes of equal mass without springs over a subject.
struct LooseCloth {
  std::vector<Vec3> x;
  std::vector<Vec3> v;
  std::vector<double> inverse_mass;
  SubjectCollisions collisions;
  CollisionOptions options;
  CollisionCounts counts;  // of the last step

  LooseCloth(const TriangleMesh& subject, const TriangleMesh& sheet, const Vec3& speed)
      : x(sheet.points),
        v(sheet.points.size(), speed),
        inverse_mass(sheet.points.size(), 1 / 2e-5),
        collisions(subject, sheet.triangles) {}

  void step(double dt, const Vec3& gravity) {
    for (Vec3& speed : v) speed += dt * gravity;
    counts = collisions.respond(x, inverse_mass, dt, options, v);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += dt * v[i];
  }
};

}  // namespace toile::test
