// Words that people use for body measures.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/measure_names.h"

namespace toile {

/// What a word stands for: one side or the whole of a measure of `measure_names()`.
struct MeasureWord {
  std::string side;       ///< "left_", "right_" or empty
  MeasureTerm measure{};  ///< the word's value is `factor` times that of the measure
};

/// Finds a measure by a word of English, German or French, as "inside leg" or "Brustumfang", or by
/// a name of Valentina, FreeSewing or GarmentCode. Nothing where the word is not known.
///
/// Case, blanks, hyphens and accents don't count, nor whether ae or ä is written. Where programs
/// and people differ, people win: `hips` is the hip here, and `neck_circ` the neck, not its base.
std::optional<MeasureWord> measure_of_word(std::string_view word);

}  // namespace toile
