// Keeps the distances to a body beside it, for dress --cache.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "cloth/scene/collider.h"
#include "tools/dress/say.h"

namespace toile {

/// The distances to a body as it stands, and to the same body with its arms raised, in two files. A
/// file that is missing, damaged or of another body counts as empty.
class KeptDistances : public RaisedDistances {
 public:
  /// `path`: of the body as it stands. Warnings go to `log`, which must outlive this.
  KeptDistances(std::filesystem::path path, DressLog& log);

  DistanceCache of_body(const TriangleMesh& body) const;
  /// Writes the file anew where `computed` distances, those that it lacks, are worth it. Nor is it
  /// an error when nothing can be written. Returns whether it tried.
  bool keep_body(const Collider& body, std::size_t computed) const;

  DistanceCache known(const TriangleMesh& raised) const override;
  void keep(const Collider& raised) const override;

 private:
  std::filesystem::path path_;
  DressLog& log_;
};

/// The body's distances are kept beside it: body.distances for body.ply.
std::filesystem::path distances_path(const std::filesystem::path& body);
/// Those of the raised body: body.raised.distances for body.distances.
std::filesystem::path raised_distances_path(const std::filesystem::path& distances);
/// Both files of a body.
std::vector<std::filesystem::path> kept_distances_of(const std::filesystem::path& body);

}  // namespace toile
