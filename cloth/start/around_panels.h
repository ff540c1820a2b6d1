// Panels that close around a body part by themselves, as a sleeve of one piece does.
#pragma once

#include "pattern/panel_mesh.h"

namespace toile {

/// Whether a seam joins two edges of the panel that lie across from each other. A dart's do not.
/// `panel` is an index into garment.panels. Linear.
bool closes_around(const PanelMesh& garment, int panel);

/// The direction of the flat panel that points up its part. It runs along the seam that closes the
/// panel, else along the drawing's y. It points to the seams to other panels where `to_partners`
/// says so, else to the drawing's plus side. Linear.
PlacementAxis up_axis(const PanelMesh& garment, int panel, bool to_partners);

}  // namespace toile
