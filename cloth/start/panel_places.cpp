#include "cloth/start/panel_places.h"

#include <algorithm>
#include <array>

#include "geometry/body/body_part.h"
#include "geometry/error.h"

namespace toile {

namespace {

constexpr std::array<std::pair<const char*, PlacementSide>, 4> sides = {
    {{"front", PlacementSide::front},
     {"back", PlacementSide::back},
     {"left", PlacementSide::left},
     {"right", PlacementSide::right}}};

}  // namespace

std::pair<std::string, AskedPlace> parse_asked_place(const std::string& text) {
  const auto refuse = [&](const std::string& problem) {
    return Error("--place '" + text + "'", problem,
                 "say PANEL=PART:SIDE, as in front=torso:front; PART is torso, head, left_arm, "
                 "right_arm, left_leg or right_leg, SIDE is front, back, left, right or around");
  };
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0) throw refuse("names no panel");
  AskedPlace place;
  std::string rest = text.substr(equals + 1);
  if (rest.empty() || rest.back() == ':') throw refuse("says no place, or no side after the colon");
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const std::string word = rest.substr(0, colon);
    rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
    const auto side = std::ranges::find(sides, word, [](const auto& s) { return s.first; });
    if (body_part(word) != BodyPart::none && place.part == BodyPart::none) {
      place.part = body_part(word);
    } else if (word == "around" && place.side == PlacementSide::none && !place.around) {
      place.around = true;
    } else if (side != sides.end() && place.side == PlacementSide::none && !place.around) {
      place.side = side->second;
    } else {
      throw refuse("has '" + word + "', which is unknown or one word too many");
    }
  }
  return {text.substr(0, equals), place};
}

std::string side_name(PlacementSide side) {
  const auto found = std::ranges::find(sides, side, [](const auto& s) { return s.second; });
  return found == sides.end() ? "" : found->first;
}

std::string text_of(const FoundPlace& place) {
  std::string part = name_of(place.part);
  std::ranges::replace(part, '_', ' ');
  std::string text = place.panel + ": " + part + ", ";
  text += place.around ? "around" : side_name(place.side);
  return place.asked ? text + " (as asked)" : text;
}

}  // namespace toile
