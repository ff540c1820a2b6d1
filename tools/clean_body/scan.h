// The scan of a body that clean-body is given: reading it, and what is said and reported of it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/body/clean_body.h"
#include "geometry/scan/reconstruct_scan.h"
#include "tools/clean_body/run.h"

namespace toile {

/// What the files of a body hold: polygons, or the points of a scan.
struct BodyInput {
  std::string name;  ///< the first file's, and how many more there are
  PolygonSoup soup;  ///< without polygons if it is a scan
  PointCloud scan;   ///< empty if it is a mesh
  int files = 1;
  /// All files together are thinned to this many at most: more tell nothing, and fill the memory.
  static constexpr std::size_t most_points = 10'000'000;
  std::size_t left_out = 0;  ///< points that were read and not taken
};

/// Reads all files. They are a scan if there are several, if the one has no faces, or if asked for.
/// Poses are applied. Throws Error for what can't be read.
BodyInput read_body_input(const CleanBodySettings& settings);

/// Where the scan's holes are in the cleaned body.
std::vector<PlacedHole> placed_holes(const ScanReport& scan, const CleanBody& body);

/// Adds what the user should know about how the body stood in the scan.
void warn_of_scan(const ScanReport& scan, std::vector<std::string>& warnings);

/// What was read, dropped and not seen, a line each.
void say_scan(const ScanReport& scan, int files, const CommonSettings& common);
/// The same of holes below large_scan_hole; the larger ones are warnings.
void say_holes(const std::vector<PlacedHole>& holes, const CommonSettings& common,
               std::vector<std::string>& warnings);

nlohmann::ordered_json scan_json(const ScanReport& scan, int files,
                                 const std::vector<PlacedHole>& holes);

}  // namespace toile
