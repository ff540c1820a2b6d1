// Whether a garment is cut large enough for the body.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloth/ease/garment_levels.h"
#include "cloth/ease/girths.h"

namespace toile {

/// A level at which the garment's cut and the body are compared. Lengths in metres.
struct FitLevel {
  std::string level;  ///< a Girth's or a GarmentLevel's name
  double body = 0;    ///< the body's girth
  double as_cut = 0;  ///< the garment's girth on the flat panels
  double error = 0;   ///< of `missing()`
  /// Height above the floor at which the edge was drafted to lie, and `body` is measured. None: it
  /// is a level of the body, or nobody knows.
  std::optional<double> drafted = {};
  double risen = 0;              ///< by how much the edge hangs higher than that; negative: lower
  std::vector<int> panels = {};  ///< of the garment, that meet there

  double missing() const { return body - as_cut; }
};

/// What `fit` says beside the verdict on sewing.
struct Fit {
  bool is_checked = false;       ///< false: no named level could be measured
  std::vector<FitLevel> levels;  ///< those that are too small; empty: large enough
  /// The level of the trunk at which the cut is nearest to the body, as a share. The body is
  /// measured where that cloth was drafted to lie: a waist that hangs at the hips may fit there. A
  /// waist seam counts at the waist.
  /// None: no level of the trunk was measured, or the garment is open at one.
  std::optional<FitLevel> nearest;
};

/// The levels of body and garment at which more is missing than flesh gives way (`flesh_give`). A
/// knit that is meant to stretch is named, too. An edge is compared with the body where it was
/// drafted to lie: too small, it rides up to where the body is slimmer. Rows that are
/// no girths do not count, nor those of both legs, which stand apart.
Fit fit_of(const std::vector<Girth>& girths, const std::vector<GarmentLevel>& garment_levels);

/// "ok", "too_small" or "not_checked".
std::string to_string(const Fit& fit);

/// "at the waist the garment is cut 3.2 ± 0.3 cm smaller than the body, and stretched by that: 62.0
/// cm around 65.2 cm". Of an edge it says where it was drafted to lie, and how much higher it
/// hangs.
std::string text_of(const FitLevel& level);

/// "ok", or "too_small, 3.2 cm missing at the waist" with the level that lacks the most.
std::string text_of(const Fit& fit);

}  // namespace toile
