// Finds the landmarks of ISO 8559-1 that tailors measure from, on the surface alone.
#pragma once

#include <string>

#include "geometry/body/body_frame.h"
#include "geometry/body/landmark.h"
#include "geometry/body/trunk_levels.h"

namespace toile {

/// A body in its own frame, with all that measuring needs.
struct BodyShape {
  BodyFrame frame;
  TrunkLevels levels;
  Landmarks landmarks;  ///< in the frame
};

/// Finds the landmarks of a body that stands along y. They are in `frame`:
/// - cervicale, front_neck, left_ and right_side_neck: around the neck's base;
/// - shoulder, armpit, armpit_front, armpit_back: of each side;
/// - bust_point of each side, and underbust, waist, abdomen at the front's middle, hip at the
/// back's;
/// - waist_back, waist_side, hip_side, bust_side: where the side line meets these levels;
/// - crown, crotch, floor, and gluteal_fold, seat_point, knee, calf, ankle, elbow, wrist of each
/// side.
///
/// The side line leads from the middle of the trunk at the armpits to that at the crotch, seen from
/// the side. `body` is closed and outward-oriented, in metres, `name` its place in messages. What
/// the surface does not show has a reason instead of a place. Throws Error as body_frame() does.
/// Costs some 500 slices.
BodyShape find_landmarks(const TriangleMesh& body, const std::string& name);

/// The landmarks in the frame of the body that was given.
Landmarks given_landmarks(const BodyShape& shape);

/// Why the lowest point of the body is not where it stands; empty: it is.
std::string no_floor(const BodyShape& shape);

/// Metres: z of the side line at the height y. The body has a skeleton.
double side_line(const BodyShape& shape, double y);

}  // namespace toile
