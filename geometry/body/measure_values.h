// The measures of a body by name: plain data.
#pragma once

#include <map>
#include <string>

namespace toile {

/// Metres by the names of measures, and degrees where the measure is an angle.
using MeasureValues = std::map<std::string, double>;

/// What a body is by its proportions.
enum class FigureType { woman, man, child };

}  // namespace toile
