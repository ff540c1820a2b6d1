// The skeleton of a standing body, found from its surface.
#pragma once

#include <string>

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

/// Finds the joints of a body that stands on y = 0 along y, arms held away from the trunk at
/// anything from an A-pose to level (about 15 to 90 degrees from hanging), legs apart below the
/// crotch. `body` is closed and outward-oriented, in metres; its size does not matter, its
/// proportions do.
///
/// What is measured: the crotch (the level where two legs become one trunk), the armpits (where
/// the arms leave the trunk), the waist (least girth between), the neck (least girth below the
/// head; its base where it widens to the shoulders), the limbs' centrelines (through sections
/// square to them), the wrists (least girth above the hand). What is not visible from outside is
/// placed on those by proportion: hip joints, knees, elbows (segment lengths from Drillis &
/// Contini 1966).
///
/// Throws Error, `name` its place, when the surface has no such parts. About 300 slices of O(n).
Skeleton find_skeleton(const TriangleMesh& body, const std::string& name);

/// How far the feet reach forward (+z) of the ankles on average, as a share of the height: positive
/// for a body that faces +z, negative for one that faces -z, about 0 without feet.
double toes_forward(const TriangleMesh& body, const Skeleton& skeleton);

}  // namespace toile
