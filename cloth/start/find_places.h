// Places on the body for a pattern that states none: found from its seams, names and sizes.
#pragma once

#include <vector>

#include "cloth/start/panel_places.h"
#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Places all panels, whatever places they have. Sets `garment.placed`, and the `placement` of
/// panels that are to be rolled around their part.
///
/// - A panel that is sewn to itself across its width goes around its part. That is an arm or the
///   torso, and of two without others each a leg. A panel that is asked to goes around, too.
/// - A strip that is sewn along its length to what goes around goes around, too (around_panels.h):
///   a collar, a cuff, a waistband. It is turned so that its seams fit.
/// - All others lie in a front and a back face (flat_layout.h), by the faces that their names say,
///   or by what fits. The faces stand before and behind the body. Panels named as hoods stand at
///   the head's sides.
/// - Which face is the front, and their height on the body: see worn_layout.h.
///
/// Throws Error, naming a panel, where the skeleton lacks joints, where panels are not sewn to
/// others, and for asked panels that are not there. `body` has the skeleton's joints.
std::vector<FoundPlace> find_places(const TriangleMesh& body, const Skeleton& skeleton,
                                    const AskedPlaces& asked, PanelMesh& garment);

}  // namespace toile
