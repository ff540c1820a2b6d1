// Whether sewn cloth has two sides.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "pattern/panel_mesh.h"

namespace toile {

/// Two panels whose seam turns the outside of a garment into its inside, as a band does that is
/// sewn with half a turn. Every garment that is worn has two sides. Another seam of the same ring
/// may be the wrong one. Layered panels are left out. None: the cloth has two sides. About
/// O(n log n) in the triangles.
std::optional<std::pair<std::string, std::string>> one_sided_seam(const PanelMesh& garment,
                                                                  const DressedGarment& dressed);

}  // namespace toile
