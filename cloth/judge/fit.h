// Whether a garment is cut large enough for the body.
#pragma once

#include <string>
#include <vector>

#include "cloth/ease/garment_levels.h"
#include "cloth/ease/girth_ease.h"

namespace toile {

/// A level at which the garment is cut smaller than the body.
struct TooSmallLevel {
  std::string level;   ///< "bust", "waist" or "hip", or a level of the garment: "waist seam"
  double missing = 0;  ///< metres: the body's girth less the garment's as cut
};

/// What `fit` says beside the verdict on sewing.
struct Fit {
  bool is_checked = false;            ///< false: no named level could be measured
  std::vector<TooSmallLevel> levels;  ///< empty: large enough
};

/// The levels of body and garment at which more is missing than flesh gives way (`flesh_give`). A
/// knit that is meant to stretch is named, too.
Fit fit_of(const std::vector<GirthEase>& girths, const std::vector<GarmentLevel>& garment_levels);

/// "ok", "too_small" or "not_checked".
std::string to_string(const Fit& fit);

/// "at the waist the garment is cut 3.2 cm smaller than the body, and stretched by that"
std::string text_of(const TooSmallLevel& level);

}  // namespace toile
