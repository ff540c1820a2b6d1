// What the words of a panel say: its name, part, label and material.
#pragma once

#include <string>

#include "pattern/classify/panel_name.h"
#include "pattern/pattern.h"

namespace toile {

/// A panel's name, and what the panel is a piece of as classify() says.
struct PanelWords : PanelName {
  PanelRole role = PanelRole::unknown;
};

PanelWords words_of(const PatternPanel& panel);

/// What a panel is that is no piece of the shell, by its name or the first word of its material.
/// `pocket`, `interfacing`, `lining`, `placket`, `binding` or `loop`; empty: nothing says
/// so.
std::string kind_beside_shell(const PatternPanel& panel);

/// Whether a material is ribbing: a knit that is cut shorter than what it is sewn to, and
/// stretched.
bool is_ribbing(const std::string& material);

}  // namespace toile
