// Reads and writes mesh files: OBJ, PLY, STL and OFF.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/types.h"
#include "io/output_file.h"
#include "io/view/colour.h"

namespace toile {

/// Reads a mesh in the format of the path's extension, in small or capital letters: .obj, .ply,
/// .stl or .off. PLY and STL may be ASCII or binary, PLY of either byte order. It throws Error with
/// the file and the line or byte when the file is cut off or contradicts itself. Coordinates that
/// are not finite or beyond max_coordinate, indices out of range, and no faces are Errors, too.
PolygonSoup read_mesh(const std::filesystem::path& path);

/// The same of a file that need not hold faces, nor points.
PolygonSoup read_polygons(const std::filesystem::path& path);

/// The soup as triangles. Each polygon is cut into a fan from its first corner.
TriangleMesh fan_triangles(PolygonSoup soup);

/// Values of a mesh's points or triangles, under a name without blanks.
struct MeshProperty {
  std::string name;
  std::vector<double> values;
};

/// What a mesh file says besides the mesh. Each is empty or has one entry a point or triangle.
struct MeshProperties {
  std::vector<Colour> colours;          ///< of the points
  std::vector<MeshProperty> points;     ///< written as floats
  std::vector<MeshProperty> triangles;  ///< written as floats
};

/// Writes a mesh in the format of the path's extension, whole or not at all. OBJ, OFF and PLY
/// (binary) keep the doubles exactly. STL holds floats and no shared points. Only PLY can hold
/// properties. It throws Error for an unknown extension, for properties in another format, and as
/// OutputFile does.
void write_mesh(const OutputPath& path, const TriangleMesh& mesh,
                const MeshProperties& properties = {});

/// Throws Error unless write_mesh() knows the extension. Call it before a long computation.
void check_mesh_extension(const std::filesystem::path& path);

}  // namespace toile
