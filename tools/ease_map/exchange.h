// Garment and body for other 3D programs.
#pragma once

#include <string>

#include "io/obj.h"
#include "tools/ease_map/report.h"

namespace toile {

/// Body and garment as binary glTF, in metres. The garment is one mesh a panel, under its name,
/// with its fabric as material. A node at a seam is a point of each panel there, and its normal is
/// that of the sewn cloth.
///
/// TEXCOORD_0 is the flat pattern in metres, as `vt` of dressed.obj. TEXCOORD_1 is the panels side
/// by side, in [0, 1]. Vertex colours are those of the ease, see maps.h.
///
/// `thickness`, metres: 0 is the surface through the nodes. Else each panel has an outer and an
/// inner face half of it away, and a rim where the garment ends. Throws Error as format_glb().
std::string ease_glb(const EaseReport& report, double thickness);

/// The body with normals, in the axes of dressed.obj.
ObjData body_obj(const EaseReport& report);

}  // namespace toile
