// What a panel is a piece of, as its pattern says.
#pragma once

#include <cstdint>
#include <string>

#include "pattern/panel_mesh.h"

namespace toile {

/// The piece of a garment that a panel belongs to.
enum class PanelKind : std::uint8_t {
  unknown,
  top,       ///< of what hangs from shoulders or chest: front, back, collar, hood
  band,      ///< of a waistband
  skirt,     ///< of what hangs from waist or hips around both legs
  trousers,  ///< of what goes around each leg
  sleeve,    ///< of what goes around an arm: sleeve, cuff
};

/// The kind by the panel's part and label (`body`, `arm`, `leg`), then by its name
/// (panel_name.h). At the head a name that tells comes first. A part of `torso` without a name that
/// tells is `unknown`: a tube there may be a top or a skirt.
PanelKind kind_of(const MeshedPanel& panel);

/// The kind by the name alone. A cuff of trousers is of trousers, and a skirt's band is of the
/// skirt.
PanelKind kind_by_name(const std::string& name);

/// Whether the name says that the panel is of a hood.
bool names_hood(const std::string& name);

/// Whether the name says that the panel is of a hood or a collar.
bool names_headwear(const std::string& name);

/// -1: the name says right, +1: left, 0: neither. The wearer's sides.
int side_by_name(const std::string& name);

/// -1: the name says back, +1: front, 0: neither.
int face_by_name(const std::string& name);

/// What contradicts the part: "its name says a skirt", "its name says right", "its label is 'leg'".
/// Empty: nothing does, or the pattern states no part. The label counts before the name, and what a
/// name says of the piece before its side.
std::string against_part(const MeshedPanel& panel);

}  // namespace toile
