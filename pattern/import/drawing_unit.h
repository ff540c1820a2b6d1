// The unit of a drawing of pattern pieces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// What speaks for a unit.
struct UnitEvidence {
  std::optional<double> asked;   ///< metres: the user's
  std::optional<double> stated;  ///< metres: the file's
  std::string stated_by;         ///< what states it, for messages
  std::optional<double> other;   ///< metres: what another part of the file states
  std::string other_by;
  bool metric = false;   ///< the statement is "metric" alone, which may mean centimetres, too
  bool english = false;  ///< the file says that it is not metric
  double largest = 0;    ///< units: the longer side of the largest piece's box
};

/// Metres in a unit of the drawing. The user's word counts first, the file's next. Without either
/// the size of the largest piece tells it, with a remark: a garment's is some 20 cm to 2 m long.
///
/// A stated unit makes no garment where the largest piece is shorter than 15 cm or longer than 4 m.
/// Then the file's other statement is taken, if that makes one. Of "metric" without another
/// statement centimetres are. A warning tells that, names the other units that would fit, and tells
/// of statements that contradict each other.
///
/// Throws Error when the largest piece would be shorter than 2 cm or longer than 5 m, and when its
/// size fits no unit. The user's word is not doubted below 100 m.
double drawing_unit(const UnitEvidence& evidence, const std::string& source,
                    std::vector<Remark>& remarks);

/// "millimetres, by $INSUNITS": what the unit is, and who tells it.
std::string unit_with_source(const UnitEvidence& evidence, double unit);

}  // namespace toile
