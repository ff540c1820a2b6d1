// How far toward rest a garment is draped, by name, and what is known of the error that is left.
#pragma once

#include <array>

namespace toile {

/// A preset of `dress --quality`.
struct Quality {
  const char* name;
  double residual;  ///< DressOptions::stop_median and stop_wide; a tenth of stop_rms
  /// Millimetres, root of the mean square: how far nodes are from where the same run ends when it
  /// is brought to rest. The largest of the garments below [measured by bench_work_precision, and
  /// at 25 mm by the test of the presets too].
  double distance_rms_mm;
};

/// Of the relaxation. Expected, not bounded: loose cloth can be farther from its rest, and a finer
/// run end farther from it than a coarser one, as the T-shirt's at 25 mm does (0.39 and 0.74 mm).
inline constexpr std::array<Quality, 3> qualities = {{
    {"draft", 0.05, 6.14},
    {"standard", 0.003, 0.47},
    {"fine", 0.001, 0.74},
}};
inline constexpr const Quality& standard_quality = qualities[1];
inline constexpr const char* measured_on =
    "sample T-shirt, GarmentCode shirt and pencil dress, 15 mm edges, and the T-shirt at 25 mm, "
    "default fabric: the largest";

}  // namespace toile
