// Limb ease: the girth of the garment around arms and legs less the girth of the body.
#pragma once

#include <string>
#include <vector>

#include "cloth/ease/panel_widths.h"
#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The girths of body and garment around one bone, where the garment is cut the least for it.
/// Lengths in metres.
struct LimbEase {
  std::string limb;    ///< "left upper arm", "left forearm", "left thigh" or "left lower leg"
  double share = 0;    ///< of the bone, from its upper end
  Vec3 at{0, 0, 0};    ///< the point of the bone
  double body = 0;     ///< girth of the section's convex hull: what a tape reads
  double garment = 0;  ///< length along the cloth, folds included
  double as_cut = 0;   ///< sum of the panels' widths
};

/// Limb ease on planes square to the bones, 1 cm apart. Of each bone there is the plane with the
/// least of `as_cut` less `body`. Bones that the garment does not close around are left out, and so
/// are limbs of which `skeleton` lacks a joint. Armpit and crotch are left out, too.
///
/// Where cloth lies in layers, the outermost counts. `grains` are MeshedPanel::grain of each panel;
/// empty: the warp runs along the drawing's y. Costs a slice() of the garment each plane, and one
/// of the body where the garment closes.
std::vector<LimbEase> measure_limb_ease(const DressedGarment& garment, const TriangleMesh& body,
                                        const Skeleton& skeleton,
                                        const std::vector<double>& grains = {});

}  // namespace toile
