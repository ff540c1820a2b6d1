// What a panel is, as garments and reports have it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "io/json_value.h"
#include "pattern/classify/panel_class.h"

namespace toile {

/// {"part": "left_arm", "role": "sleeve", "worn_as": "sleeve", "side": "left", "around": true,
/// "by": {"part": "stated", "role": "name", …}}. What nobody tells is left out. Where witnesses
/// contradict each other, "contradiction" says what they say.
nlohmann::ordered_json panel_class_json(const PanelClass& is);

/// The same back. Throws Error, with the value's place, for an unknown key or word.
PanelClass read_panel_class(const JsonValue& value);

}  // namespace toile
