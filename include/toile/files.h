// Reads and writes the files of Toile's programs.
#pragma once

#include <filesystem>

#include "toile/error.h"
#include "toile/values.h"

namespace toile {
inline namespace library {

/// Reads a mesh: .obj, .ply, .stl or .off. Polygons are cut into triangles. Throws Error for a file
/// that can't be read, is cut off or contradicts itself. So do all that follow.
TOILE_API Mesh read_mesh(const std::filesystem::path& file);

/// Reads a body, in metres, and the joints beside it: body.body.json beside body.ply. Throws Error
/// for a body that is not closed, and for joints of another body.
TOILE_API Body read_body(const std::filesystem::path& file);

/// Reads a pattern in GarmentCode's JSON. Throws Error for one that is no pattern.
TOILE_API SewingPattern read_pattern(const std::filesystem::path& file);

/// Reads a garment that mesh-pattern wrote, with garment.garment.json beside garment.obj.
TOILE_API Garment read_garment(const std::filesystem::path& file);

/// Reads a drape that dress wrote, and its report: dressed.json beside dressed.obj, where that is
/// of this drape. `garment` is what was dressed. Throws Error where the two are not the same
/// garment.
TOILE_API Drape read_drape(const std::filesystem::path& file, const Garment& garment);

/// Writes a body and its joints beside it. The file's ending says the format, as of read_mesh().
/// All files are new, or none. Throws Error for what can't be written. So do all that follow.
TOILE_API void write(const Body& body, const std::filesystem::path& file);
TOILE_API void write(const SewingPattern& pattern, const std::filesystem::path& file);
/// garment.obj, and garment.garment.json beside it.
TOILE_API void write(const Garment& garment, const std::filesystem::path& file);
/// dressed.obj, and its report, if there is one, as dressed.json beside it.
TOILE_API void write(const Drape& drape, const std::filesystem::path& file);

}  // namespace library
}  // namespace toile
