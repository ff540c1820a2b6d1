// What ease-map does once it knows what is asked.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "cloth/ease/ease_targets.h"
#include "io/warning.h"
#include "pattern/measure/spec_sheet.h"
#include "tools/program.h"

namespace toile {

struct EaseMapSettings {
  std::filesystem::path garment;
  std::filesystem::path body;
  std::optional<std::filesystem::path> csv, ply, png, pdf, glb;
  std::optional<std::filesystem::path> body_obj;  ///< the body for other programs
  double thickness = 0;                           ///< metres, of the cloth in `glb`; 0: a surface
  std::optional<std::filesystem::path> skeleton;  ///< none: beside the body, if there
  std::optional<std::filesystem::path> dress_report;  ///< none: beside the garment, if there
  /// The garment before it was dressed, for loads; none: as the report of dress names it, if there.
  std::optional<std::filesystem::path> meshed;
  /// Metres: cloth nearer than this touches the skin. None: 1 mm more than the offset at which the
  /// cloth was draped, if the report of dress says it, else EaseOptions::contact.
  std::optional<double> contact;
  std::optional<double> top;  ///< metres, the end of the colour scale; none: to suit the garment
  std::optional<EaseTargets> targets;
  std::vector<Warning> earlier_warnings;  ///< said already, for the report and the page
  /// Other drapes of the garment on this body, that errors are taken from.
  std::vector<std::filesystem::path> repeats;
  /// What the page calls them; none: the files' names.
  std::optional<std::string> garment_name, body_name;
  std::string size;                              ///< of the pattern; empty: not known
  std::vector<MeasuredPoint> points;             ///< of measure, for the page
  std::optional<std::filesystem::path> against;  ///< another drape to show this one beside
  std::vector<double> heights;  ///< metres above the floor: levels of the trunk to add
};

/// Measures the dressed garment's ease and writes the files that are asked for. The page is one of
/// them where there is an output. Throws Error for what can't be read, measured or written.
void run_ease_map(const EaseMapSettings& settings, const CommonSettings& common);

}  // namespace toile
