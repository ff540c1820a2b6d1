// Which part of the body each panel is for.
#pragma once

#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The body part of each panel, none of them `none`. The panel's class counts first. Of a sleeve
/// the nearer arm counts then, and of trousers the nearer leg.
/// Of other panels it is the part whose bones lie nearest to the middle of the panel as placed.
/// A panel in front of both legs belongs to the torso, from which a skirt hangs. A panel that
/// reaches the body's middle is no sleeve.
std::vector<BodyPart> panel_parts(const PanelMesh& garment, const Skeleton& skeleton);

}  // namespace toile
