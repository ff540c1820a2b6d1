// The paths between points that are to be sewn together, and whether the body obstructs them.
#pragma once

#include <optional>
#include <vector>

#include "geometry/body/bones.h"
#include "geometry/body/skeleton.h"
#include "geometry/distance_grid.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The straight paths between the points of each seam's two sides, while the panels are lifted.
class SeamPaths {
 public:
  /// `lifted`: per material point, the share of a lift that it takes part in. `skeleton` null: no
  /// arm is known.
  SeamPaths(const PanelMesh& garment, const std::vector<Vec3>& placed,
            const std::vector<double>& lifted, const DistanceGrid& body, const Skeleton* skeleton);

  /// Pairs whose path leads through the body, or that would meet too near to it. It is not enough
  /// that a seam meets before a narrow shoulder, when its other side has to come through that.
  /// A pair that an arm once obstructed counts at every higher lift. Lifted past the arm, it would
  /// close above, with the arm outside of its sleeve. So call this for rising lifts, in metres.
  int obstructed(double lift);

  /// Those of them that stay obstructed at every higher lift, because of an arm.
  int at_arms() const;

  /// Pairs that would meet inside the body or too near to it.
  int meeting_inside(double lift) const;

 private:
  struct SeamPath {
    int a;
    int b;
    bool at_arm = false;  ///< at this lift or a lower one
  };

  Vec3 lifted_point(int point, double lift) const;
  bool is_obstructed(SeamPath& path, double lift) const;
  bool in_arm(const Vec3& p) const;

  const std::vector<Vec3>& placed_;
  const std::vector<double>& lifted_;
  const DistanceGrid& body_;
  std::optional<Bones> torso_;  // none: no skeleton
  std::vector<Bones> arms_;
  std::vector<SeamPath> paths_;
};

}  // namespace toile
