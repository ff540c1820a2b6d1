// The keys of a panel's `placement`, as docs/pattern.schema.json states them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/json_value.h"
#include "pattern/panel_placement.h"

namespace toile {

/// The body part that `placement` names, one of body_parts; empty when it names none. Throws Error.
std::string read_part(const JsonValue& placement);

/// Everything else of it, its lengths times `unit` metres. Throws Error for a key or word that is
/// unknown, numbers that make no sense, and keys that would have no effect: those that say how a
/// panel is positioned need side or around, and these a part.
PanelPlacement read_placement(const JsonValue& placement, const std::string& part, double unit);

/// What read_placement reads back the same with unit 1. Without the part.
nlohmann::ordered_json placement_json(const PanelPlacement& placement);

}  // namespace toile
