// The keys of a panel's `placement`, as docs/pattern.schema.json states them.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "io/json_value.h"
#include "pattern/panel_placement.h"

namespace toile {

/// The body part that `placement` names; `none` when it names none. Throws Error for any other
/// name.
BodyPart read_part(const JsonValue& placement);

/// Reads all keys of `placement` but the part. Lengths in the file are in units of `unit` metres.
/// Throws Error for an unknown key or word and for numbers out of range. Throws it for keys without
/// effect: those that state how a panel is positioned need `side` or `around`, and these need a
/// part.
PanelPlacement read_placement(const JsonValue& placement, BodyPart part, double unit);

/// The placement as JSON, in metres and without the part: read_placement with unit 1 gives the same
/// back.
nlohmann::ordered_json placement_json(const PanelPlacement& placement);

}  // namespace toile
