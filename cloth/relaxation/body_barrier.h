// Keeps cloth on its side of the body while seams close.
#pragma once

#include <utility>
#include <vector>

#include "cloth/scene/scene.h"
#include "geometry/types.h"
#include "geometry/vec4.h"

namespace toile {

/// Moves cloth out of the body at once, where a push would let it through: seams that close pull
/// with any force. Probes are the cloth's points, places along its edges, and places between the
/// points that a seam will join. So what a seam has on its two sides cannot slip through the gap
/// that is still open.
class BodyBarrier {
 public:
  /// A way between two material points, straight; both are the same: a point.
  struct Way {
    int from;
    int to;
  };

  /// `triangles` and `seams`: of material points at `x` (metres). `seams` are pairs to be joined.
  BodyBarrier(const Scene& scene, const std::vector<Triangle>& triangles,
              const std::vector<Way>& seams, const Vec4s& x);

  /// A displacement (metres) that takes a place between two points out of the body.
  struct Correction {
    Way way;
    double share;  ///< 0 at `from`, 1 at `to`
    Vec3 out;
  };
  /// The probes that are inside the body with the points at `x`, in the order of the probes. Runs
  /// in parallel. Linear in the probes.
  const std::vector<Correction>& find(const Vec4s& x);

 private:
  struct Probe {
    Way way;
    double share;
  };
  void add(const Way& way, double length);

  const Scene& scene_;
  std::vector<Probe> probes_;
  Vec4s clear_;  ///< metres, per probe: where it was last seen, and the square of how far it may go
  std::vector<std::vector<Correction>> found_;
  std::vector<Correction> all_;
};

}  // namespace toile
