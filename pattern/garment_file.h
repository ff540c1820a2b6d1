// Garments on disk: garment.obj with garment.json beside it, and dressed.obj.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// garment.obj: one group a panel, v the placed points, vt the flat coordinates in metres (one for
/// each v, in the same order), l the seam pairs. garment.json of the same stem: panels with their
/// ranges, grain, fabric, part and placement; seams with their pairs and lengths; subdivisions.
void write_garment(const std::filesystem::path& obj, const PanelMesh& garment);

/// Reads what write_garment wrote, also after another program has moved the points. `json` empty:
/// the file of the same stem. Throws Error, naming the file, when the two do not fit together.
PanelMesh read_garment(const std::filesystem::path& obj, const std::filesystem::path& json = {});

void write_dressed(const std::filesystem::path& obj, const DressedGarment& garment);

/// Throws Error when a face has no vt, is no triangle, or belongs to no group.
DressedGarment read_dressed(const std::filesystem::path& obj);

}  // namespace toile
