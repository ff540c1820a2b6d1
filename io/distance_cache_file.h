// What is known of a body's distances, kept from one run to the next.
#pragma once

#include <filesystem>
#include <optional>

#include "geometry/distance_cache.h"
#include "geometry/types.h"

namespace toile {

/// Writes what is known of the distances of `body`, whole or not at all. Throws Error when the file
/// can't be written.
void write_distance_cache(const std::filesystem::path& path, const TriangleMesh& body,
                          const DistanceCache& cache);

/// What write_distance_cache wrote for the same body on a machine of this kind; nothing when there
/// is no such file, when it is damaged or of another body. Only what is in it is checked, not
/// whether its distances are right.
std::optional<DistanceCache> read_distance_cache(const std::filesystem::path& path,
                                                 const TriangleMesh& body);

}  // namespace toile
