// Which way up a panel is that closes around its part by itself, as a sleeve of one piece does.
#pragma once

#include "pattern/panel_mesh.h"

namespace toile {

/// The direction of the flat panel that points up its part. It runs along the seam that closes the
/// panel, else along the drawing's y. It points to the seams to other panels where `to_partners`
/// says so, else to the drawing's plus side. Linear.
PlacementAxis up_axis(const PanelMesh& garment, int panel, bool to_partners);

}  // namespace toile
