// Numbers as the files of ease-map show them.
#pragma once

#include <cmath>
#include <string>

#include "io/text.h"

namespace toile {

inline std::string mm(double metres) { return fixed_number(1000 * metres, 1); }
inline std::string cm(double metres) { return fixed_number(100 * metres, 1); }
inline std::string percent_text(double share) { return fixed_number(100 * share, 1); }

/// To four decimals: a tenth of a micrometre in mm is finer than anything measured here.
inline double rounded(double value) { return std::round(value * 1e4) / 1e4; }

}  // namespace toile
