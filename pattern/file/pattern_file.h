// Reads patterns in GarmentCode's JSON.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// Reads a pattern in GarmentCode's JSON [Korosteleva & Sorkine-Hornung 2023].
/// docs/pattern.schema.json states the keys, Toile's own included.
///
/// Both generations of edge curvature are read: a lone control point `[x, y]`, and `{type, params}`
/// with quadratic, cubic and circle. Panels come in the order of `panel_order`, else of the file.
/// Rotations are Euler angles in degrees about the fixed x, then y, then z axis. Keys that are not
/// read are added to `remarks`, and so is what was assumed. What spoils
/// a mesh is mended, see sew_crossed_rows_as_one(), merge_short_edges() and
/// open_sharp_corners(). Edges keep their numbers.
///
/// Throws Error for malformed JSON, with line and column, and for missing or misshapen values.
/// Throws it for outlines that are not one closed loop. Throws it, naming panel and edge, for
/// stitches to a panel or edge that is not there.
Pattern read_pattern(const std::filesystem::path& path, std::vector<Remark>& remarks);
/// The same of a text; `name` stands for the file in messages.
Pattern parse_pattern(const std::string& text, const std::string& name,
                      std::vector<Remark>& remarks);

/// The same without mending: every edge is as drawn, and every stitch as the file has it.
Pattern parse_drawn_pattern(const std::string& text, const std::string& name,
                            std::vector<Remark>& remarks);

}  // namespace toile
