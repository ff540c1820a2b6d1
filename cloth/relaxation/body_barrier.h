// Keeps cloth on its side of the body while seams close.
#pragma once

#include <array>
#include <vector>

#include "cloth/contact/fastest_path.h"
#include "cloth/scene/scene.h"
#include "geometry/types.h"
#include "geometry/vec4.h"

namespace toile {

/// Moves cloth out of the body at once, where a push would let it through: seams that close pull
/// with any force. Probes are the points of the cloth, places along its edges and within its
/// triangles, and places between the points that a seam will join. So no toe comes through a wide
/// triangle. Nor does what stands between the two sides of an open seam slip through the gap.
class BodyBarrier {
 public:
  /// Two material points that a seam will join.
  struct Pair {
    int a;
    int b;
  };
  /// A place in a triangle, on an edge (one weight is 0) or at a point (two are).
  struct Place {
    Triangle points;  ///< material points; for an edge and for a point, some are repeated
    std::array<double, 3> weights;  ///< barycentric: their sum is 1
  };

  /// `triangles` and `seams`: of material points at `x` (metres).
  BodyBarrier(const Scene& scene, const std::vector<Triangle>& triangles,
              const std::vector<Pair>& seams, const Vec4s& x);

  /// A displacement (metres) that takes a place out of the body.
  struct Correction {
    Place place;
    Vec3 out;
  };
  /// The probes that are inside the body with the points at `x`, in the order of the probes. Runs
  /// in parallel. Linear in the probes.
  const std::vector<Correction>& find(const Vec4s& x);

 private:
  void add_between(int a, int b, double length);
  void add_within(const Triangle& corners, double longest);
  void find(std::size_t begin, std::size_t end, const Vec4s& x, std::vector<Correction>& found);

  const Scene& scene_;
  std::vector<Place> probes_;
  Vec4s clear_;  ///< metres, per probe: where it was last seen, and the square of how far it may go
  FastestPath path_;
  std::vector<double> clear_until_;  ///< metres, per probe: the path up to which it is surely clear
  std::vector<std::vector<Correction>> found_;
  std::vector<Correction> all_;
};

}  // namespace toile
