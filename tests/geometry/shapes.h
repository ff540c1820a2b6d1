// Small meshes of known measures, named for their shape.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "geometry/types.h"

namespace toile::shapes {

/// A box from `low` to `high`, 12 triangles, outward.
inline TriangleMesh box(const Vec3& low, const Vec3& high) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.points.emplace_back((corner & 1) != 0 ? high.x() : low.x(),
                             (corner & 2) != 0 ? high.y() : low.y(),
                             (corner & 4) != 0 ? high.z() : low.z());
  }
  const std::array<std::array<int, 4>, 6> quads = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& quad : quads) {
    mesh.triangles.push_back({quad[0], quad[1], quad[2]});
    mesh.triangles.push_back({quad[0], quad[2], quad[3]});
  }
  return mesh;
}

/// A sphere of latitude and longitude lines around the y axis, outward: two poles and
/// `rings` - 1 circles of 2 `rings` points, all exactly `radius` from `centre`.
inline TriangleMesh sphere(const Vec3& centre, double radius, int rings) {
  TriangleMesh mesh;
  const int around = 2 * rings;
  mesh.points.push_back(centre + Vec3(0, -radius, 0));
  for (int ring = 1; ring < rings; ++ring) {
    const double latitude = std::numbers::pi * ring / rings;
    for (int i = 0; i < around; ++i) {
      const double longitude = 2 * std::numbers::pi * i / around;
      mesh.points.push_back(centre + radius * Vec3(std::sin(latitude) * std::cos(longitude),
                                                   -std::cos(latitude),
                                                   std::sin(latitude) * std::sin(longitude)));
    }
  }
  const int top = static_cast<int>(mesh.points.size());
  mesh.points.push_back(centre + Vec3(0, radius, 0));
  const auto at = [&](int ring, int i) { return 1 + (ring - 1) * around + i % around; };
  for (int i = 0; i < around; ++i) {
    mesh.triangles.push_back({0, at(1, i), at(1, i + 1)});
    for (int ring = 1; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
    mesh.triangles.push_back({at(rings - 1, i), top, at(rings - 1, i + 1)});
  }
  return mesh;
}

/// Both meshes in one, not joined.
inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const int offset = static_cast<int>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return a;
}

/// The same surface turned inside out.
inline TriangleMesh inside_out(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace toile::shapes
