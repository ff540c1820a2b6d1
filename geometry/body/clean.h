// A body as the rest of Toile wants it: closed, in metres, upright, on the floor, facing +z.
#pragma once

#include <optional>
#include <string>

#include "geometry/body/skeleton.h"
#include "geometry/repair.h"
#include "geometry/surface_distance.h"

namespace toile {

struct CleanOptions {
  /// Metres in one unit of the file. None: told from the height, since no two of m, dm, cm, mm and
  /// inches make the same number a body between 1.00 and 2.30 m tall.
  std::optional<double> metres_per_unit;
  RepairOptions repair;
  /// The joints, if they are known; metres, in the frame of the mesh in metres. Taken as they are
  /// when they are all there within the body and the toes point to
  /// +z; the body is then not turned.
  std::optional<Skeleton> skeleton;
};

struct CleanReport {
  RepairReport repair;
  double metres_per_unit = 1;
  bool unit_inferred = false;
  std::string turned;     ///< how the body was turned to stand and face +z; empty: it was not
  double lifted = 0;      ///< metres added to y to put the feet on the floor
  Vec3 brought{0, 0, 0};  ///< metres that a body far from the y axis was brought to it
  double height = 0;      ///< metres
  std::string
      skeleton_refused;     ///< why the given joints are not taken; empty: they are, or none are
  std::string no_skeleton;  ///< why there is none; empty: there is one
};

struct CleanBody {
  TriangleMesh mesh;  ///< closed, 2-manifold, outward; metres, y up, lowest point at y = 0
  std::optional<Skeleton> skeleton;
  CleanReport report;
};

/// Repairs, turns, lifts and scales a body and finds its skeleton.
///
/// It is turned by right angles only, and only where there is no doubt: when it lies along z as
/// z-up programs leave it, when it has a skeleton along exactly one axis and that is not y, when it
/// is wider from front to back than from side to side, and when its toes point to -z. Its place on
/// the floor is left as it is within 10 m of the origin; beyond, where no garment is, it is brought
/// to it.
///
/// Given joints say which way the body stands; they only move with it.
///
/// Throws Error as repair() does, and when the unit can't be told or the body is no body's size. A
/// body without a skeleton is no error.
CleanBody clean_body(const PolygonSoup& soup, const std::string& name,
                     const CleanOptions& options = {});

/// Metres that a joint may lie outside of the body: the head's lies on the crown, and repair moves
/// the skin a little.
inline constexpr double joint_tolerance = 0.015;

struct JointOutside {
  std::string name;
  double by = 0;  ///< metres
};

/// The first of the bones' joints that lies outside of the body by more than `joint_tolerance`:
/// then they are another body's. Joints that are missing, or end no bone, are passed over. `body`
/// is in units of `unit` metres.
std::optional<JointOutside> joint_outside(const Skeleton& skeleton, const SurfaceDistance& body,
                                          double unit = 1);

}  // namespace toile
