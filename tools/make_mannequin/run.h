// What make-mannequin does once it knows what is asked.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/body/landmark.h"
#include "geometry/body/mannequin/mannequin.h"
#include "tools/make_mannequin/by_measures.h"
#include "tools/program.h"

namespace toile {

struct MakeMannequinSettings {
  MannequinOptions mannequin;
  std::optional<double> arms;               ///< degrees from the trunk, of the standing pose
  std::optional<MeasureSettings> measures;  ///< none: the sample
};

/// What --measures is given: files, and "bust=94".
void add_measures(const std::vector<std::string>& texts, MeasureSettings& settings);

/// A mannequin, and the report of it.
struct MadeMannequin {
  Mannequin mannequin;
  Landmarks landmarks;  ///< empty where it does not stand
  nlohmann::ordered_json report;
};

/// Makes the mannequin, and says its measures. Throws Error for measures that contradict.
MadeMannequin made_mannequin(const MakeMannequinSettings& settings, const CommonSettings& common);

/// Writes the mannequin and its joints. Returns exit_negative where a measure is missed. Throws
/// Error for measures that contradict.
ExitCode run_make_mannequin(const MakeMannequinSettings& settings, const CommonSettings& common);

}  // namespace toile
