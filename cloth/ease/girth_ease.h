// Girth ease: the girth of the garment around the torso less the girth of the body.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/landmarks.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The girths of body and garment at one height. Lengths in metres.
struct GirthEase {
  std::string level;   ///< "bust", "waist" or "hip"; empty for other heights
  double height = 0;   ///< above the floor
  double body = 0;     ///< girth of the convex hull of the torso's section: what a tape reads
  double garment = 0;  ///< length along the cloth, folds included
  double ease = 0;     ///< garment - body
  double as_cut = 0;   ///< length of the same line on the flat panels
};

/// Girth ease on horizontal planes through the torso, from the top down. The planes lie at the
/// bust, waist and hip of ISO 8559-1, and every `step` metres between crotch and armpits. Levels at
/// which the garment does not close around the torso are left out.
///
/// - Bust, waist and hip are found on the body by torso_levels().
/// - Cloth that is too small stretches until it goes around. Its ease is positive, and `as_cut` is
///   less than the body's girth.
/// - A section of cloth that hangs in slanting folds is longer than the cloth is wide. So a loose
///   garment reads up to a few per cent high.
///
/// `skeleton` has to have the joints pelvis, waist and chest. Costs one pass over both meshes per
/// level; bust, waist and hip cost about 100 passes over the body.
std::vector<GirthEase> measure_girth_ease(const DressedGarment& garment, const TriangleMesh& body,
                                          const Skeleton& skeleton, double step = 0.05);

}  // namespace toile
