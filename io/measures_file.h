// Measures of a body as people have them, from files and command lines.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace toile {

/// Measures by the names of `measure_names()`, metres or degrees. Those of two sides apart have
/// `left_` or `right_` before the name.
struct MeasureSet {
  std::map<std::string, double> values;
  std::string gender;  ///< "female", "male", or empty: the file does not say
  std::map<std::string, std::string> taken_as;  ///< words for measures, and the names here
  std::vector<std::string>
      left_out;  ///< names in the file that are not known here, or without number
};

/// Reads a file by its name's end and what is in it:
/// - `.json`: an object with `measures` as measure-body writes it, cm, or `unit` beside or within a
///   measure; null is left out. A FreeSewing set, in mm: `measurements` or `measies`, or an object
///   of its names that has `chest`, `seat` or `hips`;
/// - `.csv`: a name and a value a row, cm or the unit in a third field. A header, which
///   has `value`, names the columns `measure` or `name`, `value` and `unit`;
/// - `.vit`, `.smis` and the tables `.vst`, `.smms` of SeamlyMe and Valentina in the file's unit.
///   Of a table the base size counts. Formulas are left out;
/// - `.yaml`, `.yml`: GarmentCode's `body:` block, cm.
///
/// `metres_per_unit` stands for the unit where a file does not state its own. Throws Error, with
/// file and line or key, for what can't be read, a measure twice, and a length that is not
/// positive.
MeasureSet read_measures(const std::filesystem::path& path,
                         std::optional<double> metres_per_unit = std::nullopt);

/// Adds "bust=94", "left knee=36.5", "height=5.5in" or "shoulder_angle=21" to a set, by a word of
/// measure_of_word(). A bare number
/// counts in `metres_per_unit`. Throws Error for what is no measure.
void add_measure(const std::string& text, double metres_per_unit, MeasureSet& set);

}  // namespace toile
