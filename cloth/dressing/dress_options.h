// What a user may ask of a dressing.
#pragma once

#include "cloth/dressing/quality.h"

namespace toile {

struct DressOptions {
  /// Residual of a garment at rest, in mean node weights.
  double stop_median = standard_quality.residual;
  double stop_rms = rms_over_median * standard_quality.residual;
  /// Residual of whole patches of cloth, in their weights; 0: not asked for. Soft motions come to
  /// rest slowly. At 0.0015 nodes are up to 0.3 mm (rms) from where they end, at 0.003 up to 0.6
  /// mm. At 0.0007 99 % of a garment move less than 2 mm when it is released for a second
  /// [measured].
  double stop_wide = standard_quality.residual;
  int max_iterations = 40000;  ///< of the last stage, on the garment's own mesh
  /// For which the dressed garment is released; 0: it is not. A garment that is to be released is
  /// brought nearer to rest first, to releasable_residual, where it comes so far.
  double release_seconds = 0;
};

}  // namespace toile
