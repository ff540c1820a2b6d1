#include "cloth/judge/fit.h"

#include <algorithm>
#include <cmath>

#include "cloth/ease/figure_errors.h"
#include "cloth/scene/constants.h"
#include "io/text.h"

namespace toile {

Fit fit_of(const std::vector<Girth>& girths, const std::vector<GarmentLevel>& garment_levels) {
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
  for (const Girth& girth : girths) {
    if (girth.name.empty() || !girth.is_girth() || girth.is_of_both_legs) continue;
    FitLevel level{girth.name, girth.body, girth.as_cut,
                   as_cut_error(girth.as_cut, girth.on_the_line)};
    level.panels = panels_of(girth);
    if (girth.is_of_trunk) {
      compare_trunk(level, girth.drafted_body);
    } else {
      compare(level);
    }
  }
  for (const GarmentLevel& level : garment_levels) {
    if (level.name == "neckline") continue;  // a collar may be narrower than the neck's base
    const std::optional<GarmentLevel::Compared> with = level.compared();
    if (!with) continue;
    FitLevel compared{level.name, with->body, level.as_cut, with->error};
    compared.panels = level.panels;
    if (with->is_drafted) {
      compared.drafted = level.drafted;
      compared.risen = *level.risen();
    }
    if (level.is_of_limb) {
      compare(compared);
    } else {
      compare_trunk(compared, level.waist);
    }
  }
  return fit;
}

std::string to_string(const Fit& fit) {
  if (!fit.is_checked) return "not_checked";
  return fit.levels.empty() ? "ok" : "too_small";
}

std::string text_of(const FitLevel& level) {
  std::string text = "at the " + level.level + " the garment is cut " +
                     fixed_number(100 * level.missing(), 1) + " \xC2\xB1 " +
                     centimetres(level.error, 1) + " smaller than the body";
  if (level.drafted) {
    text += " where it was drafted to lie, " + centimetres(*level.drafted, 1) +
            " above the floor, and hangs " + centimetres(std::abs(level.risen), 1) +
            (level.risen > 0 ? " higher" : " lower");
  } else {
    text += ", and stretched by that";
  }
  return text + ": " + centimetres(level.as_cut, 1) + " around " + centimetres(level.body, 1);
}

std::string text_of(const Fit& fit) {
  if (fit.levels.empty()) return to_string(fit);
  const FitLevel& most = *std::ranges::max_element(fit.levels, {}, &FitLevel::missing);
  return to_string(fit) + ", " + centimetres(most.missing(), 1) + " missing at the " + most.level;
}

}  // namespace toile
