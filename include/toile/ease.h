// Measures how a drape fits: gaps, girths, lengths, strain and pressure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "toile/error.h"
#include "toile/values.h"

namespace toile {
inline namespace library {

struct EaseChoices {
  std::string target = {};           ///< close, fitted, semi-fitted, loose or a JSON file; or none
  std::vector<double> heights = {};  ///< metres above the floor: further levels of the trunk
  /// Metres: nearer cloth touches; none: 1 mm more than the drape was held off the skin.
  std::optional<double> contact = {};
};

/// The report of ease-map as JSON: docs/report.md. Without the drape's report it has no verdict and
/// no loads. Needs a folder for temporary files. Throws Error for a body that is not closed.
TOILE_API std::string ease(const Drape& drape, const Body& body, const EaseChoices& choices = {});

/// Metres from the skin, per node of the drape; negative: inside the body. Throws Error likewise.
TOILE_API std::vector<double> gaps(const Drape& drape, const Body& body);

}  // namespace library
}  // namespace toile
