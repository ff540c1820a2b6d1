// One mesh format each, between text or bytes and plain data; mesh_file.h chooses among them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/types.h"
#include "io/mesh_file.h"

namespace toile {

/// All throw Error with "name:line", or "name, byte n" for binary data, as read_mesh() says. None
/// allocates by a count that the rest of the file doesn't bear out.
PolygonSoup parse_ply(std::string_view data, const std::string& name);
PolygonSoup parse_stl(std::string_view data, const std::string& name);
PolygonSoup parse_off(std::string_view data, const std::string& name);

std::string format_ply(const TriangleMesh& mesh, const std::vector<Colour>& colours);
std::string format_stl(const TriangleMesh& mesh);
std::string format_off(const TriangleMesh& mesh);

}  // namespace toile
