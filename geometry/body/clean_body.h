// Cleans a body: closed, in metres, upright on the floor, facing +z, as the rest of Toile needs it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/axis_direction.h"
#include "geometry/body/flaws.h"
#include "geometry/body/skeleton.h"
#include "geometry/repair.h"
#include "geometry/surface_distance.h"

namespace toile {

struct CleanOptions {
  /// Metres in one unit of the file. If absent, height and depth decide, as inferred_unit().
  std::optional<double> metres_per_unit;
  std::optional<double> height;  ///< metres that the body is tall, where its unit is not given
  RepairOptions repair;
  /// The joints, if they are known: metres, in the frame of the mesh in metres. They are used if
  /// all are there, lie within the body, and the toes point to +z. The body is then not turned.
  std::optional<Skeleton> skeleton;
  bool level = true;                   ///< turns a body upright that leans as a whole
  std::optional<AxisDirection> up;     ///< of the mesh, if it is known; the joints above go first
  std::optional<AxisDirection> front;  ///< to where the body faces, if it is known
};

struct CleanReport {
  RepairReport repair;
  double metres_per_unit = 1;
  bool unit_inferred = false;
  std::string turned;            ///< how the body was turned to stand and face +z; empty: not
  double turned_degrees = 0;     ///< about the vertical, once upright; positive from +z to +x
  double levelled_degrees = 0;   ///< by which a body that leant as a whole was turned upright
  double lifted = 0;             ///< metres added to y to put the feet on the floor
  Vec3 brought{0, 0, 0};         ///< metres by which a body far from the y axis was moved to it
  double height = 0;             ///< metres
  BodyMove move;                 ///< from the mesh in metres to the cleaned body
  std::string skeleton_refused;  ///< why the given joints are not used; empty: they are, or none
  std::string no_skeleton;       ///< why there is no whole skeleton; empty: there is one
  std::string missing;  ///< of a skeleton in part: what it lacks; empty: it is whole, or none
  std::vector<FilledHole> large_holes;  ///< beyond large_hole; metres, in the cleaned body's frame
  std::optional<Crossings> crossings;   ///< where the cleaned body crosses itself
};

struct CleanBody {
  TriangleMesh mesh;  ///< closed, 2-manifold, outward; metres, y up, lowest point at y = 0
  std::optional<Skeleton> skeleton;
  CleanReport report;
};

/// Degrees between the x axis and the line from side to side that need no turn. A body that steps
/// or bends has as much.
inline constexpr double max_askew = 8;

/// Metres: what a filled hole has across that deserves a word. Soles take more, fingertips less.
inline constexpr double large_hole = 0.05;

/// Repairs, turns, lifts and scales a body and finds its skeleton.
///
/// The body is turned upright by right angles only, and only in clear cases:
/// - it lies along z, as z-up programs leave it;
/// - it has a skeleton along exactly one axis other than y.
///
/// Then it is turned about the vertical to face +z:
/// - by a right angle if it is wider from front to back than from side to side;
/// - by the angle of its shoulders to the x axis, if that is more than max_askew;
/// - by half a turn if its toes point to -z.
///
/// Within 10 m of the origin the body keeps its place on the floor. Farther off there is no
/// garment, so the body is moved to the origin. Given joints decide the body's orientation. They
/// are turned about the vertical, moved and scaled with it.
///
/// Where `up` or `front` is given, that is not searched for.
///
/// It throws Error as repair() does, when the unit can't be found, when the height is not 0.1 to
/// 10 m, or as refuse_sheet(). A `front` along the vertical is an Error. A body without a skeleton
/// is none. Where limbs are missing it has the joints of incomplete_body(), and is turned to face
/// +z by them.
CleanBody clean_body(const PolygonSoup& soup, const std::string& name,
                     const CleanOptions& options = {});

/// Metres that a joint may lie outside of the body. The head's joint lies on the crown, and repair
/// moves the skin a little.
inline constexpr double joint_tolerance = 0.015;

struct JointOutside {
  std::string name;
  double by = 0;  ///< metres from the body
};

/// The first joint of a segment that lies outside of the body by more than `joint_tolerance`. Such
/// joints belong to another body. It skips joints that are missing or end no segment. `body` is in
/// units of `unit` metres.
std::optional<JointOutside> joint_outside(const Skeleton& skeleton, const SurfaceDistance& body,
                                          double unit = 1);

}  // namespace toile
