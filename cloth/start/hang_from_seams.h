// The start of a skirt's panels: each hangs from what it is sewn to above.
#pragma once

#include "pattern/panel_mesh.h"

namespace toile {

/// Lets the panels of a skirt start along their upper seam. A panel's points keep their place along
/// that seam and their distance from it, so the seam starts closed. A panel that is wider than the
/// seam, as half a circle or a gathered frill, starts as a fan, pressed together. It opens while
/// the other seams close. As drawn, half a circle stands as high beside its waist as that is deep,
/// and a frill may stand below the feet. Their seams would close through other cloth.
///
/// - A panel hangs only down, and the same way up as it was placed: what is sewn by its hem stays.
/// - First those hang that are sewn to anything but a skirt, then those that are sewn to these, and
///   so on. Of a skirt alone, the panels with the highest points stay, and the others hang.
/// - A panel's upper seam joins it to panels that face as it does. It is one run of its outline,
///   without a corner. Darts at the waist part it: such a panel stays. So does one whose seam would
///   lay it upon what it is sewn to, one of several gores, and one that would meet the body.
/// - A panel stays where its upper seam stands nearly closed, or where the skeleton positions it.
///
/// Changes `placed` of the panels that hang. `body`: metres. Linear in the points, times the panels
/// and the points of an upper seam.
void hang_from_seams(const TriangleMesh& body, PanelMesh& garment);

}  // namespace toile
