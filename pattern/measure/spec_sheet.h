// A garment's specification: what each point of measure should be, by size.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pattern/measure/points_of_measure.h"

namespace toile {

/// A row of a specification. Metres.
struct SpecRow {
  int line = 0;      ///< of the file
  std::string name;  ///< of points_of_measure(), with or without its side, or one's own
  std::string rule;  ///< how it is taken; empty: as points_of_measure() does
  std::optional<double> spec;
  std::optional<double> tolerance;
};

/// Reads a table with a header. Its columns are `name`, `measured` (the rule), `tolerance_cm`, and
/// one of specs in centimetres a size, or `spec_cm` alone. Columns that measure-pattern writes
/// besides are passed over. `size` is one of the columns; empty: there is one size at most.
///
/// Throws Error, whose place is file and line, for a header without `name` and for a field that is
/// no length. The same goes for a size that is not there or not said.
std::vector<SpecRow> read_spec_sheet(std::string_view text, const std::string& file,
                                     const std::string& size);

/// A point of measure of a garment beside what it should be. Metres.
struct MeasuredPoint {
  std::string name;
  std::string rule;              ///< empty: nobody says how it is taken
  std::optional<double> actual;  ///< none: the garment has no such point
  std::optional<double> spec;
  double tolerance = 0;

  std::optional<double> difference() const {
    return actual && spec ? std::optional(*actual - *spec) : std::nullopt;
  }
  /// "in tolerance", "too small", "too large" or "not found"; empty: it is there and has no spec.
  std::string result() const;
};

/// Measures the rows of a specification. A name without its side stands for both sides.
/// `tolerance`: metres, of rows without one. Throws Error, whose place is the row in `file`, for a
/// rule that does not hold.
std::vector<MeasuredPoint> measure_to_spec(const SewnPanels& panels,
                                           const std::vector<SpecRow>& spec,
                                           const std::string& file, double tolerance);

/// All that points_of_measure() finds, without a spec. What a line on the panels does not reach is
/// left out.
std::vector<MeasuredPoint> measure_all_points(const SewnPanels& panels);

}  // namespace toile
