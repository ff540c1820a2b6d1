#include "tools/dress/kept_distances.h"

#include <algorithm>
#include <string>
#include <utility>

#include "geometry/error.h"
#include "io/distance_cache_file.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

bool keep_distances(const fs::path& path, const Collider& body, std::size_t computed,
                    DressLog& log) {
  constexpr std::size_t worth_writing = 2000;  // nodes, a few milliseconds' work
  // A file that grows by little takes as long to write as it saves.
  constexpr std::size_t known_over_new = 10;
  const std::size_t known = body.grid().restored_nodes();
  if (computed < std::max(worth_writing, known / known_over_new)) return false;
  try {
    write_distance_cache(path, body.body(), body.grid().cache());
  } catch (const Error& error) {
    log.warn({"distances_not_kept", "",
              std::string("the body's distances are not kept: ") + error.what()});
    return false;
  }
  return true;
}

}  // namespace

KeptDistances::KeptDistances(fs::path path, DressLog& log) : path_(std::move(path)), log_(log) {}

DistanceCache KeptDistances::of_body(const TriangleMesh& body) const {
  return read_distance_cache(path_, body).value_or(DistanceCache());
}

bool KeptDistances::keep_body(const Collider& body, std::size_t computed) const {
  return keep_distances(path_, body, computed, log_);
}

DistanceCache KeptDistances::known(const TriangleMesh& raised) const {
  return read_distance_cache(raised_distances_path(path_), raised).value_or(DistanceCache());
}

void KeptDistances::keep(const Collider& raised) const {
  keep_distances(raised_distances_path(path_), raised, raised.grid().computed_nodes(), log_);
}

fs::path distances_path(const fs::path& body) {
  return fs::path(body).replace_extension("distances");
}

fs::path raised_distances_path(const fs::path& distances) {
  return fs::path(distances).replace_extension("raised.distances");
}

std::vector<fs::path> kept_distances_of(const fs::path& body) {
  const fs::path distances = distances_path(body);
  return {distances, raised_distances_path(distances)};
}

}  // namespace toile
