// Measures as files: JSON, CSV, and those of other programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "geometry/body/measures.h"
#include "io/measure_names.h"
#include "pattern/pattern.h"

namespace toile {

/// All that the files say.
struct MeasuredBody {
  std::string body_name;
  std::vector<Measure> measures;
  std::vector<Measure> freehand;
  Landmarks landmarks;  ///< in the body's coordinates
  std::string unit = "cm";
  std::string no_joints;        ///< why; empty: there are joints
  std::vector<Remark> remarks;  ///< what is said besides

  /// The value in the unit of the files, or in degrees.
  double shown(const Measure& measure) const;
  double shown_error(const Measure& measure) const;  ///< Measure::plus_minus, alike
};

/// A difference to a measure that was taken before, in the unit of the files.
struct MeasureDifference {
  std::string name;
  double before = 0;
  double now = 0;
};

nlohmann::ordered_json measures_json(const MeasuredBody& measures,
                                     const std::vector<MeasureDifference>& differences);

/// Columns: name, value, unit, plus_minus, confidence, iso, definition, reason.
std::string measures_csv(const MeasuredBody& measures);

/// What the file of another program lacks, by that program's names.
struct ForeignGaps {
  std::vector<std::string> filled;   ///< has a value by proportion
  std::vector<std::string> missing;  ///< has none
};

/// The file of another program. What a body with joints does not show is filled in by proportion,
/// as measures_by_proportion() does.
std::string foreign_file(const MeasuredBody& measures, DraftingProgram program, ForeignGaps& gaps);

/// Metres in the unit "cm" or "inch".
double metres_in(const std::string& unit);

}  // namespace toile
