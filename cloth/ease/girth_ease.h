// Girth ease: by how much the garment is longer around the torso than the body.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/landmarks.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Body and garment at one height. Lengths in metres.
struct GirthEase {
  std::string level;   ///< "bust", "waist", "hip", or empty for a height in between
  double height = 0;   ///< above the floor
  double body = 0;     ///< around the convex hull of the torso's section: what a tape reads
  double garment = 0;  ///< along the cloth, folds and all
  double ease = 0;     ///< garment - body
  double as_cut = 0;   ///< the same line of cloth on the flat panels: what was cut
};

/// Girth ease on horizontal planes through the torso, from the top down: at the bust, waist and hip
/// of ISO 8559-1 and every `step` between crotch and armpits. Levels at which the garment does not
/// close around the torso are left out.
///
/// The levels are found on the body, between its joints: hip is the height of the backmost point
/// below the waist, bust that of the foremost point above it, waist that of the smallest girth
/// between the two. What is too small stretches until it goes around: its ease is positive, and
/// `as_cut` is less than the body's. A section of cloth that hangs in slanting folds is longer
/// than the cloth is wide, so a loose garment reads up to a few per cent high. `skeleton` has to
/// have the joints pelvis, waist and chest. One pass over a mesh a level; bust, waist and hip take
/// about 100 of the body.
std::vector<GirthEase> measure_girth_ease(const DressedGarment& garment, const TriangleMesh& body,
                                          const Skeleton& skeleton, double step = 0.05);

}  // namespace toile
