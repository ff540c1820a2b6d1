// The measures of a body that tailors take: 33 lines of Zhong & Xu 2009, Fig. 12, and their parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/body/body_measures.h"
#include "geometry/body/find_landmarks.h"
#include "geometry/body/measure_values.h"

namespace toile {

/// One measure of a body, or the reason why it is not taken.
struct Measure {
  std::string name;             ///< as io/measure_names.h has it, with its side
  std::optional<double> value;  ///< metres, or degrees
  bool is_angle = false;
  bool is_girth = false;                 ///< its line is closed and lies in a plane
  std::string definition;                ///< how the tape lies, in a sentence
  std::string iso;                       ///< number in ISO 8559-1:2017; empty: none, or not known
  double plus_minus = 0;                 ///< as `value`; 0: estimate_errors() was not asked
  double confidence = 0;                 ///< 0 to 1: the least of its landmarks'
  std::string reason;                    ///< why there is no value; empty: there is one
  std::vector<std::vector<Vec3>> lines;  ///< metres, in the given body's frame: where it is taken
};

/// Of the body's height: the girth of an arm at most. A longer section holds the trunk as well.
/// Half of it refuses an arm of 37 cm at 168 cm. Double of it takes a slender trunk for an arm.
inline constexpr double most_of_an_arm = 0.35;

/// Takes all measures. Girths are of the convex hull of a section, as a tape lies. Lengths on the
/// trunk are taut in the plane through their ends, over what is hollow. Along arms and shoulders
/// they are geodesics. Where a landmark is missing, so is the measure. Where an arm touches the
/// trunk, its girth is missing. Costs some 120 slices and six geodesic().
std::vector<Measure> measure_body(const BodyShape& shape);

/// What garments are compared with, of the measures that have a value.
BodyMeasures body_measures(const std::vector<Measure>& measures);

/// Those that have a value, by name.
MeasureValues values_of(const std::vector<Measure>& measures);
/// Left and right as one, without the side in the name: the mean where both are there. A value that
/// has no side in its name wins over both.
MeasureValues without_sides(const MeasureValues& values);

/// The measure of that name; null where there is none.
const Measure* find_measure(const std::vector<Measure>& measures, const std::string& name);

}  // namespace toile
