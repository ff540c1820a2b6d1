// Which part of the body each panel is for.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The body part of each panel, one of body_parts. The part that the pattern names counts first,
/// then the panel's label: `body`, `arm` or `leg`. Of both arms or legs the nearer one counts. A
/// panel labelled `leg` that is no trousers (panel_kind.h) belongs to the torso.
/// Of other panels it is the part whose bones lie nearest to the middle of the panel as placed.
/// A panel in front of both legs belongs to the torso, from which a skirt hangs. A panel that
/// reaches the body's middle is no sleeve.
std::vector<std::string> panel_parts(const PanelMesh& garment, const Skeleton& skeleton);

}  // namespace toile
