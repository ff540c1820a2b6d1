#include "cloth/judge/fit.h"

#include "cloth/scene/constants.h"
#include "io/text.h"

namespace toile {

Fit fit_of(const std::vector<GirthEase>& girths, const std::vector<GarmentLevel>& garment_levels,
           const std::vector<LimbEase>& limbs) {
  Fit fit;
  const auto compare = [&](const std::string& level, double body, double as_cut) {
    fit.is_checked = true;
    if (body - as_cut >= flesh_give) fit.levels.push_back({level, body, as_cut});
  };
  for (const GirthEase& girth : girths) {
    if (!girth.level.empty()) compare(girth.level, girth.body, girth.as_cut);
  }
  for (const GarmentLevel& level : garment_levels) {
    if (level.body) compare(level.name, *level.body, level.as_cut);
  }
  for (const LimbEase& limb : limbs) compare(limb.limb, limb.body, limb.as_cut);
  return fit;
}

std::string to_string(const Fit& fit) {
  if (!fit.is_checked) return "not_checked";
  return fit.levels.empty() ? "ok" : "too_small";
}

std::string text_of(const TooSmallLevel& level) {
  return "at the " + level.level + " the garment is cut " + centimetres(level.missing(), 1) +
         " smaller than the body, and stretched by that: " + centimetres(level.as_cut, 1) +
         " around " + centimetres(level.body, 1);
}

}  // namespace toile
