// Converts between mesh files' content and plain data, one format each. mesh_file.h chooses one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/types.h"
#include "io/mesh_file.h"

namespace toile {

/// All parsers throw Error with the place "name:line", or "name, byte n" for binary data, as
/// read_mesh() says. None allocates memory by a count that the rest of the file does not justify.
/// `normals`, if it is given, gets the points' normals where the file has them, one a point.
PolygonSoup parse_ply(std::string_view data, const std::string& name,
                      std::vector<Vec3>* normals = nullptr);
PolygonSoup parse_stl(std::string_view data, const std::string& name);
PolygonSoup parse_off(std::string_view data, const std::string& name);

std::string format_ply(const TriangleMesh& mesh, const MeshProperties& properties);
std::string format_stl(const TriangleMesh& mesh);
std::string format_off(const TriangleMesh& mesh);

}  // namespace toile
