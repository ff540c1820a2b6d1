// A file of a body's computed distances, kept from one run to the next.
#pragma once

#include <filesystem>
#include <optional>

#include "geometry/distance_cache.h"
#include "geometry/types.h"

namespace toile {

/// Writes the computed distances to `body`, whole or not at all. Throws Error when the file can't
/// be written.
void write_distance_cache(const std::filesystem::path& path, const TriangleMesh& body,
                          const DistanceCache& cache);

/// Reads the file that write_distance_cache() wrote for the same body on a machine of this kind. It
/// returns nothing when there is no such file, or when it is damaged or of another body. It checks
/// the file's bytes, not whether the distances are right.
std::optional<DistanceCache> read_distance_cache(const std::filesystem::path& path,
                                                 const TriangleMesh& body);

}  // namespace toile
