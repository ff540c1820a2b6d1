// Places of panels on the body as the user asks for them, and as they were found.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "pattern/panel_mesh.h"

namespace toile {

/// What is asked of the place of one panel.
struct AskedPlace {
  BodyPart part = BodyPart::none;            ///< none: not asked
  PlacementSide side = PlacementSide::none;  ///< none: not asked
  bool around = false;                       ///< rolled around its part
};

/// By the names of panels.
using AskedPlaces = std::map<std::string, AskedPlace>;

/// Reads "front=torso:front". The side is one of front, back, left, right and around; it or the
/// part may be left out. Throws Error, naming `text`, for anything else. Returns the panel's name
/// and what is asked.
std::pair<std::string, AskedPlace> parse_asked_place(const std::string& text);

/// Where a panel was placed.
struct FoundPlace {
  std::string panel;
  BodyPart part = BodyPart::none;
  PlacementSide side = PlacementSide::front;
  bool around = false;       ///< rolled around its part
  bool asked = false;        ///< as asked, not found
  bool upside_down = false;  ///< its drawing looks so, see WornLayout::is_upside_down()
};

/// "front", "back", "left" or "right".
std::string side_name(PlacementSide side);

/// "front: torso, front"
std::string text_of(const FoundPlace& place);

}  // namespace toile
