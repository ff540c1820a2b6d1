// make-mannequin --measures: a mannequin from what a tape measured.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/body/mannequin/mannequin.h"
#include "tools/program.h"

namespace toile {

/// What the command line says of a body's measures.
struct MeasureSettings {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> measures;  ///< "bust=94"; they win over those of the files
  std::optional<double> unit;         ///< metres, of what states no unit
  std::string figure;          ///< woman, man or child; empty: what the file says, or by height
  std::string cup;             ///< of a woman whose underbust was not taken; empty: unknown
  bool scales_edges = false;   ///< the edge length is for a body 1.70 m tall
  bool pose_is_given = false;  ///< else arms stay raised that would lie at the bust
};

/// Makes the mannequin and says how it compares. Adds `figure`, `measures`, `notes` and `warnings`
/// to the report. Throws Error for measures that contradict.
Mannequin mannequin_by_measures(const MeasureSettings& settings, MannequinOptions options,
                                const CommonSettings& common, nlohmann::ordered_json& report);

}  // namespace toile
