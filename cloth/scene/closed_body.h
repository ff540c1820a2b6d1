// A body as the programs that dress and measure need it.
#pragma once

#include <filesystem>

#include "geometry/body/skeleton.h"
#include "geometry/surface_distance.h"
#include "geometry/types.h"

namespace toile {

/// Reads a body in any mesh format, polygons cut into triangles. Throws Error when it is not closed
/// and outward-oriented, for inside and outside could not be told, or is not of a body's height
/// in metres and within 10 m of the origin.
TriangleMesh read_closed_body(const std::filesystem::path& path);

/// Reads a body's joints. Throws Error when one is not in the body: they are another's.
Skeleton read_skeleton_of(const SurfaceDistance& body, const std::filesystem::path& path);

}  // namespace toile
