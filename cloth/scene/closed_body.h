// Reads a body for programs that dress and measure it.
#pragma once

#include <filesystem>
#include <string>

#include "geometry/body/skeleton.h"
#include "geometry/surface_distance.h"
#include "geometry/types.h"

namespace toile {

/// Reads a body in any mesh format and cuts its polygons into triangles. Metres. Throws Error when
/// it is not closed and outward-oriented, for then inside and outside cannot be told apart. It has
/// to be 0.1 to 3 m tall, less than 3 m wide and deep, and less than 10 m from the origin.
TriangleMesh read_closed_body(const std::filesystem::path& path);
/// The same of a mesh; `name` stands for the file in messages.
TriangleMesh closed_body(TriangleMesh body, const std::string& name);

/// Reads the joints of `body`. Throws Error when a joint is not inside the body: the skeleton is
/// another body's.
Skeleton read_skeleton_of(const SurfaceDistance& body, const std::filesystem::path& path);
/// Returns the joints, called `name` in messages. Throws Error as read_skeleton_of() does.
Skeleton skeleton_of(const SurfaceDistance& body, Skeleton skeleton, const std::string& name);

}  // namespace toile
