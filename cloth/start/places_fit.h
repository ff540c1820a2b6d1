// Whether the places that a pattern states agree with those that its seams tell.
#pragma once

#include <string>
#include <vector>

#include "cloth/start/find_places.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// What speaks against the places of a pattern, such as "panel 'back' leans by 21 degrees". Empty:
/// nothing does. `found` is `given` after find_places(), which returned `places`.
///
/// Fronts, backs and their like count, sleeves, hoods and collars do not: these turn to their part.
/// What is up on such a panel, by its seams or its drawing, has to be up where the pattern puts it.
/// It may not stand much higher, lower or farther away. Small panels beside larger ones do not
/// count. Linear.
std::string unfit_place(const PanelMesh& given, const PanelMesh& found,
                        const std::vector<FoundPlace>& places);

}  // namespace toile
