// What measure-body does once it knows what is asked.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/types.h"
#include "io/measure_names.h"
#include "tools/measure_body/files.h"
#include "tools/program.h"

namespace toile {

struct MeasureBodySettings {
  std::filesystem::path body;
  std::vector<std::string> freehand;  ///< expressions, see freehand.h
  std::optional<std::filesystem::path> freehand_file;
  std::optional<std::filesystem::path> against;  ///< measures taken before
  std::vector<std::pair<DraftingProgram, std::filesystem::path>> others;
  std::optional<std::filesystem::path> html, png;
  std::string unit = "cm";  ///< "cm" or "inch"
};

/// Takes the measures of a body that `name` stands for. `settings` say the unit, and what to
/// measure besides. Throws Error for a freehand expression that says nothing.
MeasuredBody take_measures(const TriangleMesh& body, const std::string& name,
                           const MeasureBodySettings& settings);

/// Measures the body and writes all files. Throws Error for what can't be read or written, and for
/// a freehand expression that says nothing. exit_negative: there is not even a waist.
int run_measure_body(const MeasureBodySettings& settings, const CommonSettings& common);

}  // namespace toile
