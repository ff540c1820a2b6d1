// What the name of a panel says, in five languages.
#pragma once

#include <string>
#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// What a panel is a piece of.
enum class PanelRole {
  unknown,
  bodice,
  skirt,
  trousers,
  sleeve,
  cuff,
  collar,
  hood,
  waistband,
  yoke,
  facing,
  pocket,
};

struct PanelWords {
  PanelRole role = PanelRole::unknown;
  int side = 0;       ///< -1 right, +1 left, 0 neither; the wearer's
  int face = 0;       ///< -1 back, +1 front, 0 neither
  std::string stem;   ///< the name without side, face and number
  std::string whole;  ///< the name without its side, for pairs of left and right
  int number = -1;    ///< the last number in the name; -1: none
};

/// Reads names in English, German, French, Spanish and Italian, and the panel's part and label
/// where its name says no role. GarmentCode's shorthand counts: `ftorso`, `wb`, `_b`, `_l`.
PanelWords words_of(const PatternPanel& panel);

/// What a panel is that is no piece of the shell, by its name or the first word of its material.
/// `pocket`, `interfacing`, `lining`, `placket`, `binding` or `loop`; empty: nothing says
/// so.
std::string kind_beside_shell(const PatternPanel& panel);

/// Whether a material is ribbing: a knit that is cut shorter than what it is sewn to, and
/// stretched.
bool is_ribbing(const std::string& material);

}  // namespace toile
