// What measure-pattern does once it knows what is asked.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pattern/measure/spec_sheet.h"
#include "tools/program.h"

namespace toile {

struct MeasurePatternSettings {
  std::filesystem::path pattern;
  std::optional<std::filesystem::path> spec;  ///< points of measure as they should be
  std::string size;                           ///< the spec's column; empty: it has one
  std::vector<SpecRow> rows;                  ///< of the spec
  bool knit = false;
  bool says_remarks = true;  ///< those of reading the pattern
};

/// --pom, --size, --knit. A --size that `options` has is left as it is.
void add_pom_options(boost::program_options::options_description& options);
/// Throws boost::program_options::error for --knit without --pom, and for --size, unless that is
/// the size of a drawing, too.
void check_pom_options(const boost::program_options::variables_map& given,
                       bool size_is_of_drawing = false);
/// Reads the spec, too. Throws Error for one that is none.
void read_pom_options(const boost::program_options::variables_map& given,
                      MeasurePatternSettings& settings);

/// What came of it.
struct MeasurePatternEnd {
  std::vector<MeasuredPoint> points;
  /// The warning that was said: something is out of its tolerance or was not found.
  std::optional<std::string> off_spec;
};

/// Measures the pattern and writes the table. Throws Error for what can't be read, and for a rule
/// that does not hold.
MeasurePatternEnd run_measure_pattern(const MeasurePatternSettings& settings,
                                      const CommonSettings& common);

}  // namespace toile
