// Finds the triangles of a mesh that are near.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// Boxes around triangles, eight to a box of the next level: eight are tested side by side, in
/// single precision, rounded to the safe side.
/// Building is O(n log n), a question about O(log n). Answers depend on the mesh only.
class TriangleTree {
 public:
  /// The mesh has to outlive the tree, and has triangles, all of finite points.
  explicit TriangleTree(const TriangleMesh& mesh);

  /// The triangle nearest to the point, of several the first; `hint`, a triangle that may be near,
  /// spares looking at what is farther, and changes no answer. 0 for a point that is not finite.
  int closest_triangle(const Vec3& point, int hint = -1) const;

  /// Appends all triangles within `radius` of the point, and some more.
  void within(const Vec3& point, double radius, std::vector<int>& found) const;

  /// Appends all triangles that meet the box from `low` to `high`, and some more.
  void meeting(const Vec3& low, const Vec3& high, std::vector<int>& found) const;

 private:
  static constexpr int width = 8;
  struct alignas(16) Boxes {
    float low[3][width];
    float high[3][width];
  };
  struct Nearest;
  struct Query;

  void search(std::size_t level, std::size_t number, Nearest& nearest) const;
  /// Calls `visit` with the triangles in boxes that `meets` lets pass.
  template <class Meets, class Visit>
  void descend(std::size_t level, std::size_t number, const Meets& meets, const Visit& visit) const;

  const TriangleMesh& mesh_;
  double largest_ = 0;                      // size of a coordinate
  std::vector<int> order_;                  // of the triangles
  std::vector<std::vector<Boxes>> levels_;  // first the triangles' own boxes, last a single eight
};

}  // namespace toile
