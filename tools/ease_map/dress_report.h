// What the report of dress says that an ease map shows, too.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cloth/judge/fit.h"
#include "cloth/scene/fabric.h"
#include "io/warning.h"

namespace toile {

/// A fabric of the garment, and the names of the panels that are cut from it, as valid UTF-8.
struct UsedFabric {
  Fabric fabric;
  std::vector<std::string> panels;
};

struct DressReport {
  std::string verdict;
  Fit fit;                         ///< without its nearest level
  std::vector<Warning> warnings;   ///< in their order
  double body_offset = 0;          ///< metres from the skin at which the cloth was held
  std::vector<double> grains;      ///< radians, MeshedPanel::grain per panel of the garment
  std::vector<PanelRole> worn_as;  ///< per panel
  /// The garment's levels: names and where they were drafted to lie.
  std::vector<GarmentLevel> levels;
  std::filesystem::path body;       ///< as it was named then
  std::filesystem::path garment;    ///< the meshed garment, as it was named then
  std::vector<UsedFabric> fabrics;  ///< empty: an earlier version's report, which has none
  Vec3 gravity{0, -9.81, 0};        ///< m/s²
  /// Why the forces that held the drape are not all known (measure_loads()); empty: they are.
  std::string unknown_forces;
};

/// Where it is looked for: dressed.json beside dressed.obj.
std::filesystem::path dress_report_path(const std::filesystem::path& garment_file);

/// Reads the report of a garment, or the garment's entry in the report of a scene. `garment_file`
/// is the dressed garment's. Nothing if the file is no report of dress, or of another drape: the
/// checksum in it tells. Throws Error for a file that can't be read or is damaged.
std::optional<DressReport> read_dress_report(const std::filesystem::path& file,
                                             const std::filesystem::path& garment_file);

}  // namespace toile
