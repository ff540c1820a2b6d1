// What the name of a panel says, in five languages.
#pragma once

#include <string>
#include <vector>

#include "pattern/classify/panel_class.h"

namespace toile {

struct PanelName {
  /// All that it may be a piece of. What is sewn onto a piece stands before the piece: a sleeve's
  /// cuff is a cuff.
  std::vector<PanelRole> roles;
  int side = 0;       ///< -1 right, +1 left, 0 neither; the wearer's
  int face = 0;       ///< -1 back, +1 front, 0 neither
  std::string stem;   ///< the name without side, face and number
  std::string whole;  ///< the name without its side, for pairs of left and right
  int number = -1;    ///< the last number in the name; -1: none

  PanelRole first_role() const { return roles.empty() ? PanelRole::unknown : roles.front(); }
  bool says(PanelRole role) const;
};

/// Reads names in English, German, French, Spanish and Italian. GarmentCode's shorthand counts:
/// `ftorso`, `wb`, `_b`, `_l`.
PanelName read_panel_name(const std::string& name);

}  // namespace toile
