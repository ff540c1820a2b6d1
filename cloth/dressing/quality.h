// How far toward rest a garment is draped, by name, and what is known of the error that is left.
#pragma once

#include <array>

namespace toile {

/// A preset of `dress --quality`.
struct Quality {
  const char* name;
  double residual;  ///< DressOptions::stop_median and stop_wide
  /// Metres, root of the mean square: how far nodes are from where the same run ends when it is
  /// brought to rest. The largest of the drapes below [measured by
  /// tests/benchmarks/preset_distances].
  double distance_rms;
};

/// Of the relaxation. Expected, not bounded: loose cloth can be farther from its rest.
inline constexpr std::array<Quality, 4> qualities = {{
    // Of 11,677 figures 48 are farther than a quarter of their error from rest [docs/method.md].
    {"figures", 0.1, 5e-3},
    {"draft", 0.05, 1.97e-3},
    {"standard", 0.0015, 0.48e-3},
    {"fine", 0.0005, 0.13e-3},
}};
inline constexpr const Quality& figures_quality = qualities[0];
inline constexpr const Quality& standard_quality = qualities[2];

/// Root mean square of the residual that rest may have, in medians that it may have: stop_rms over
/// stop_median.
inline constexpr double rms_over_median = 10;

inline constexpr const char* measured_on =
    "the five garments of docs/performance.md at 25 and 10 mm edges, each under gravity that leans "
    "by 0.1 degrees to either side and not at all: the largest of 30";

}  // namespace toile
