// The names of body measures, and what other programs call them.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace toile {

/// What a measure is counted in.
enum class MeasureUnit { length, degrees };

/// A measure of a body by its name in `measures.json`. Those that a body has left and right carry
/// `left_` or `right_` before the name where the sides are apart.
struct MeasureName {
  std::string_view name;
  MeasureUnit unit = MeasureUnit::length;
  bool is_sided = false;  ///< whether a body has it left and right
};

/// All names, in the order in which tables list them.
std::span<const MeasureName> measure_names();

/// The entry of a name without a side, `chest` being `bust`; null where there is none.
const MeasureName* find_measure_name(std::string_view name);

/// Programs that draft patterns from measures.
enum class DraftingProgram {
  valentina,   ///< Valentina and SeamlyMe: `.vit`, `.smis`, `.vst`; in mm, cm or inches
  freesewing,  ///< a measurement set; millimetres
  garmentcode  ///< the `body:` block; centimetres
};

struct MeasureTerm {
  std::string_view name;  ///< of `measure_names()`
  double factor = 1;
};

/// A measure of another program: the sum of its terms. Angles are in degrees everywhere.
struct ForeignMeasure {
  std::string_view name;  ///< as that program writes it
  std::vector<MeasureTerm> terms;
};

/// The measures of a program that are known here, none twice. Where two sides are apart, they stand
/// for the mean of both.
///
/// Sources: SeamlyMe's catalogue of measurements (A01 to Q03), the list of measurements of
/// FreeSewing 3 and 4, and GarmentCode's `assets/bodies`. Arcs, `across_` and `dart_placement` are
/// here from the centre to the side, so half of what goes from side to side.
const std::vector<ForeignMeasure>& foreign_measures(DraftingProgram program);

}  // namespace toile
