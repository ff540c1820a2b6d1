// From a body and a pattern with seams to the ease map: the steps that `toile fit` and `toile try`
// share.
#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cloth/ease/ease_targets.h"
#include "tools/clean_body/run.h"
#include "tools/dress/run.h"
#include "tools/dress/settings.h"
#include "tools/measure_pattern/run.h"
#include "tools/mesh_pattern/run.h"
#include "tools/program.h"
#include "tools/program_files.h"

namespace toile {

/// What the folder holds in the end.
struct FitFiles {
  /// `before`: what the names of a drape's files begin with.
  explicit FitFiles(const std::filesystem::path& out, const std::string& before = "");
  std::vector<std::filesystem::path> all() const;
  /// The meshed garment, the drape and their reports.
  std::vector<std::filesystem::path> of_drape() const;
  /// With the drape's files of another drape, such as repeat-2-dressed.obj.
  FitFiles repeat(int number) const;

  std::filesystem::path folder;

  std::filesystem::path body, skeleton, body_report;
  std::filesystem::path garment, garment_json, mesh_report;
  std::filesystem::path dressed, report;
  std::filesystem::path ease, ease_report, ease_picture, ease_pdf, drape_picture;
  std::filesystem::path dressed_glb, body_obj;  ///< for other 3D programs
  std::filesystem::path points, points_report;  ///< with --pom
};

/// What the command line asks for.
struct FitSettings {
  CleanBodySettings body;
  MeshPatternSettings pattern;
  DressSettings dress;
  bool pictures = false;
  bool pdf = false;
  int drapes = 1;  ///< on meshes that differ; figures are of the first, and errors of all
  std::optional<EaseTargets> targets = {};
  MeasurePatternSettings points = {};  ///< without a spec: not measured
};

/// --edge-length, --repeat, --cache, --png, --target, --pom and the options of the drape.
void add_fit_options(boost::program_options::options_description& options);
/// Reads them, for this body. Throws Error for values that can't be used.
void read_fit_options(const boost::program_options::variables_map& given,
                      const std::filesystem::path& body, const FitFiles& files,
                      FitSettings& settings);

/// All files that the steps read and write, but for the pattern.
ProgramFiles files_of(const FitSettings& settings, const FitFiles& files);

/// Removes what an earlier run left. If this run fails, no file there may pass for its own. Throws
/// Error for what stays.
void remove_earlier(const std::vector<std::filesystem::path>& files);

/// Throws Error for a pattern that can't be meshed, and with `remedy` for panels without any seam.
void check_pattern_file(const std::filesystem::path& file, const std::string& remedy);

/// The settings of a program that is a step.
CommonSettings step_of(const CommonSettings& common, const char* program,
                       const std::filesystem::path& output, const std::filesystem::path& report);

/// Cleans the body, unless it is posed.
CleanBodyResult fit_body(const FitSettings& settings, const FitFiles& files,
                         const CommonSettings& common);

struct FitEnd {
  DressEnd dress;
  bool body_is_usable = true;
  bool keeps_spec = true;
};

/// Meshes the pattern, dresses the body, measures the ease and draws what is asked for. Throws
/// Error where a step fails; files of the steps before stay.
FitEnd fit_pattern(const FitSettings& settings, const FitFiles& files, const CleanBodyResult& body,
                   const CommonSettings& common);

/// That of dress; exit_negative also for a body that can't be relied on, and for a spec that is
/// not kept.
ExitCode exit_code_of(const FitEnd& end);

}  // namespace toile
