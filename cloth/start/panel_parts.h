// Which part of the body each panel is for.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The body part of each panel, one of body_parts. The pattern's own word counts first. Else it is
/// the part whose bones lie nearest to the middle of the panel as placed.
/// A panel in front of both legs belongs to the torso, from which a skirt hangs. A panel that
/// reaches the body's middle is no sleeve.
std::vector<std::string> panel_parts(const PanelMesh& garment, const Skeleton& skeleton);

}  // namespace toile
