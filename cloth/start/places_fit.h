// Whether the places that a pattern states agree with those that its seams tell.
#pragma once

#include <string>
#include <vector>

#include "cloth/start/find_places.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Whether panels stand upright as they are drawn, within 12 degrees. Sleeves, hoods, collars and
/// panels that are small beside others do not count: they turn to their part. Linear.
bool stands_as_drawn(const PanelMesh& garment);

/// What speaks against the places of a pattern, such as "panel 'back' leans by 21 degrees". Empty:
/// nothing does. `found` is `given` after find_places(), which returned `places`. Of the panels
/// that count, what is up by the seams or the drawing has to be up where the pattern puts it.
/// Linear.
std::string unfit_place(const PanelMesh& given, const PanelMesh& found,
                        const std::vector<FoundPlace>& places);

}  // namespace toile
