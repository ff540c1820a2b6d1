// Meshes on disk, in the formats that other programs read: OBJ, PLY, STL, OFF.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/types.h"
#include "io/view/colour.h"

namespace toile {

/// Reads a mesh in the format of the path's extension: .obj, .ply (ASCII or binary of either byte
/// order), .stl (ASCII or binary), .off; capitals too. Throws Error that names the file and the
/// line or byte when the file is cut off, contradicts itself, or holds a coordinate that is not
/// finite, an index out of range, or no faces.
PolygonSoup read_mesh(const std::filesystem::path& path);

/// The soup as triangles, each polygon cut into a fan from its first corner.
TriangleMesh fan_triangles(PolygonSoup soup);

/// Writes a mesh in the format of the path's extension, whole or not at all. OBJ, OFF and PLY
/// (binary) keep the doubles exactly; STL holds floats and no shared points. `colours` is empty
/// or one a point, and only PLY can hold it. Throws Error for an extension it doesn't know, for
/// colours in another format, and as OutputFile does.
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const std::vector<Colour>& colours = {});

/// Throws Error unless write_mesh could write such a file: to find out before a long computation.
void check_mesh_extension(const std::filesystem::path& path);

}  // namespace toile
