// How far toward rest a garment is draped, by name, and what is known of the error that is left.
#pragma once

#include <array>

namespace toile {

/// A preset of `dress --quality`.
struct Quality {
  const char* name;
  double residual;  ///< DressOptions::stop_median and stop_wide; a tenth of stop_rms
  /// Millimetres, root of the mean square: how far nodes are from where the same run ends when it
  /// is brought to rest. The largest of the garments below [measured; of three of them
  /// bench_work_precision measures it anew, and the test of the presets of one].
  double distance_rms_mm;
};

/// Of the relaxation. Expected, not bounded: loose cloth can be farther from its rest. The largest
/// are the gathered skirt's, the elastic skirt's and the gathered skirt's; a shirt is at 5.6, 0.18
/// and 0.02 mm, a T-shirt at 0.3, 0.12 and 0.04 mm.
inline constexpr std::array<Quality, 3> qualities = {{
    {"draft", 0.05, 11.1},
    {"standard", 0.003, 0.60},
    {"fine", 0.001, 0.26},
}};
inline constexpr const Quality& standard_quality = qualities[1];
inline constexpr const char* measured_on =
    "sample T-shirts, trousers, jacket, bodice dress and skirts, GarmentCode shirt and pencil dress, "
    "15 or 25 mm edges, default fabric: the largest";

}  // namespace toile
