// GarmentCode pattern JSON, read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// Reads a pattern in GarmentCode's JSON [Korosteleva & Sorkine-Hornung 2023], both generations of
/// edge curvature: a lone control point `[x, y]`, and `{type, params}` with quadratic, cubic and
/// circle. docs/pattern.schema.json states the keys, Toile's own included. Panels come in the order
/// of `panel_order`, else of the file. Rotations are Euler angles in degrees about the fixed x,
/// then y, then z axis. Keys that are not read, and what was assumed, are added to `remarks`.
///
/// Throws Error for malformed JSON (with line and column), missing or misshapen values, outlines
/// that are not one closed loop, and stitches to a missing panel or edge (naming panel and edge).
Pattern read_pattern(const std::filesystem::path& path, std::vector<Remark>& remarks);
Pattern parse_pattern(const std::string& text, const std::string& name,
                      std::vector<Remark>& remarks);

}  // namespace toile
