// Finds the skeleton of a standing body from its surface.
#pragma once

#include <map>
#include <string>

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

/// Finds the joints of a body that stands on y = 0 along y. The arms are held away from the trunk,
/// from an A-pose to level: about 15 to 90 degrees from hanging. The legs are apart below the
/// crotch. `body` is closed and outward-oriented, in metres. Its size does not matter, its
/// proportions do.
///
/// The surface gives:
/// - the crotch, the level where two legs become one trunk;
/// - the armpits, where the arms leave the trunk;
/// - the waist, the least girth between them;
/// - the neck, the least girth below the head, and its base, where it widens to the shoulders;
/// - the limbs' centrelines, through sections square to them;
/// - the wrists, the least girth above the hand.
///
/// Hip joints, knees and elbows are not visible from outside. Proportion places them on these lines
/// (segment lengths [Drillis & Contini 1966]).
///
/// It throws Error, with the place `name`, when the surface lacks these parts. It costs about 300
/// slices of O(n).
Skeleton find_skeleton(const TriangleMesh& body, const std::string& name);

/// The joints that a surface shows of a body that lacks an arm or its head.
struct ShownJoints {
  /// Segments between the joints that are there. Without a head, `neck` is the trunk's upper end.
  Skeleton skeleton;
  std::map<std::string, std::string> missing;  ///< why, by the body's part: an arm, "head"
};

/// As find_skeleton(), of a body that has two legs, a trunk and one arm at least. What else is not
/// there is left out. Throws Error where the surface lacks these.
ShownJoints shown_joints(const TriangleMesh& body, const std::string& name);

/// Share of the height by which the feet's centroids lie before the ankles, in +z, on average. It
/// is positive for a body that faces +z, negative for one that faces -z, and about 0 without feet.
double toes_forward(const TriangleMesh& body, const Skeleton& skeleton);

}  // namespace toile
