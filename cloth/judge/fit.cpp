#include "cloth/judge/fit.h"

#include <algorithm>

#include "cloth/scene/constants.h"
#include "io/text.h"

namespace toile {

Fit fit_of(const std::vector<GirthEase>& girths, const std::vector<GarmentLevel>& garment_levels,
           const std::vector<LimbEase>& limbs) {
  Fit fit;
  const auto compare = [&](const FitLevel& level) {
    fit.is_checked = true;
    if (level.missing() >= flesh_give) fit.levels.push_back(level);
  };
  const auto compare_trunk = [&](FitLevel level, std::optional<double> drafted_body) {
    compare(level);
    level.body = drafted_body.value_or(level.body);
    const auto share = [](const FitLevel& of) { return of.as_cut / of.body; };
    if (!fit.nearest || share(level) < share(*fit.nearest)) fit.nearest = level;
  };
  for (const GirthEase& girth : girths) {
    if (!girth.level.empty()) {
      compare_trunk({girth.level, girth.body, girth.as_cut}, girth.drafted_body);
    }
  }
  for (const GarmentLevel& level : garment_levels) {
    if (level.body) compare_trunk({level.name, *level.body, level.as_cut}, level.drafted_body);
  }
  for (const LimbEase& limb : limbs) compare({limb.limb, limb.body, limb.as_cut});
  return fit;
}

std::string to_string(const Fit& fit) {
  if (!fit.is_checked) return "not_checked";
  return fit.levels.empty() ? "ok" : "too_small";
}

std::string text_of(const FitLevel& level) {
  return "at the " + level.level + " the garment is cut " + centimetres(level.missing(), 1) +
         " smaller than the body, and stretched by that: " + centimetres(level.as_cut, 1) +
         " around " + centimetres(level.body, 1);
}

std::string text_of(const Fit& fit) {
  if (fit.levels.empty()) return to_string(fit);
  const FitLevel& most = *std::ranges::max_element(fit.levels, {}, &FitLevel::missing);
  return to_string(fit) + ", " + centimetres(most.missing(), 1) + " missing at the " + most.level;
}

}  // namespace toile
