// Finds the triangles of a mesh near a point or in a box.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// A tree of boxes around triangles, eight to a box of the next level. Eight boxes are tested at
/// once, in single precision, rounded to the safe side. Building is O(n log n), a query about
/// O(log n). Results depend on the mesh and the query only.
class TriangleTree {
 public:
  /// The mesh has to outlive the tree, to have triangles, and to have finite points only.
  explicit TriangleTree(const TriangleMesh& mesh);

  /// The triangle closest to the point, the first one of several. `hint` is a triangle that may be
  /// near; it makes the search faster and does not change its result. -1: no hint. For a point that
  /// is not finite the result is 0.
  int closest_triangle(const Vec3& point, int hint = -1) const;

  /// Finds the triangle closest to each of some points that are near each other, up to
  /// `most_points` of them, as closest_triangle() does, sooner. `found` has room for one a point.
  void closest_triangles(std::span<const Vec3> points, int hint, int* found) const;
  static constexpr std::size_t most_points = 64;

  /// Appends all triangles that meet the box from `low` to `high`, and some others.
  void meeting(const Vec3& low, const Vec3& high, std::vector<int>& found) const;

 private:
  static constexpr int width = 8;
  struct alignas(32) Boxes {
    float low[3][width];
    float high[3][width];
  };
  struct FloatBox {
    float low[3];
    float high[3];
  };
  struct Nearest;
  struct Query;
  struct Search;

  void search(std::size_t level, std::size_t number, Search& found) const;
  /// Appends the triangles whose boxes meet `box`, below one eight of boxes.
  void collect(std::size_t level, std::size_t number, const FloatBox& box,
               std::vector<int>& found) const;

  const TriangleMesh& mesh_;
  double largest_ = 0;                      // largest size of a coordinate
  std::vector<int> order_;                  // triangles in the order of their boxes
  std::vector<std::vector<Boxes>> levels_;  // first the triangles' boxes, last a single eight
};

}  // namespace toile
