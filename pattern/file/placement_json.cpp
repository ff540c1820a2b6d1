#include "pattern/file/placement_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "geometry/body/skeleton.h"
#include "io/json_words.h"

namespace toile {

namespace {

constexpr std::array<std::string_view, 5> side_words = {"", "front", "back", "left", "right"};
constexpr std::array<std::string_view, 4> axis_words = {"y", "-y", "x", "-x"};
constexpr std::array<std::string_view, 9> placement_keys = {
    "part", "side", "around", "axis", "turn", "shift", "offset", "at", "level"};

/// Metres: the largest offset and shift that a placement may have, and the largest `level`.
constexpr double farthest_offset = 1;
constexpr double farthest_drawn = 1000;

double length(const JsonValue& value, double unit, double low, double high) {
  const double metres = value.number() * unit;
  if (metres < low || metres > high) value.fail("is out of range", "check the unit");
  return metres;
}

/// 1 if the drawing's coordinate along the axis grows up the body part, -1 if it grows down it.
double up_sign(PlacementAxis axis) {
  return axis == PlacementAxis::plus_y || axis == PlacementAxis::plus_x ? 1 : -1;
}

/// The joint's full name. On a limb its own joints may be named without left_ and right_.
std::string joint_name(const JsonValue& value, BodyPart part) {
  std::string given = value.text();
  const auto known = [](const std::string& name) {
    return std::find(joint_names.begin(), joint_names.end(), name) != joint_names.end();
  };
  std::string beside = name_of(part).substr(0, name_of(part).find('_') + 1) + given;
  if (known(given)) return given;
  if (known(beside)) return beside;
  value.fail(in_quotes(given) + " is no joint", "use one of " + listed(joint_names));
}

}  // namespace

BodyPart read_part(const JsonValue& placement) {
  const auto part = placement.find("part");
  if (!part) return BodyPart::none;
  const std::string name = part->text();
  if (body_part(name) == BodyPart::none) {
    part->fail(in_quotes(name) + " is no body part", "use one of " + listed(body_parts));
  }
  return body_part(name);
}

PanelPlacement read_placement(const JsonValue& value, BodyPart part, double unit) {
  PanelPlacement placement;
  refuse_other_keys(value, placement_keys);
  if (const auto side = value.find("side")) {
    placement.side = static_cast<PlacementSide>(word_of(*side, side_words));
  }
  if (const auto around = value.find("around")) {
    placement.around = around->is_flag() ? (around->flag() ? 1 : 0) : around->number();
    if (!(placement.around >= 0 && placement.around <= 1)) {
      around->fail("is not between 0 and 1", "use true, false or a number up to 1");
    }
  }
  if (!placement.by_part()) {
    for (const std::string& key : value.keys()) {
      if (key == "part" || key == "around") continue;
      value.fail("has " + in_quotes(key) + ", but nothing says where the panel stands",
                 "add 'side' or 'around'");
    }
    return placement;
  }
  if (part == BodyPart::none) {
    value.fail("says where the panel stands, but not at which body part",
               "add 'part', one of " + listed(body_parts));
  }
  if (const auto axis = value.find("axis")) {
    placement.axis = static_cast<PlacementAxis>(word_of(*axis, axis_words));
  }
  if (const auto turn = value.find("turn")) {
    placement.turn_degrees = turn->number();
    if (std::abs(placement.turn_degrees) > 360) turn->fail("is more than a full turn");
  }
  if (const auto shift = value.find("shift")) {
    placement.shift = length(*shift, unit, -farthest_offset, farthest_offset);
  }
  if (const auto offset = value.find("offset")) {
    placement.offset = length(*offset, unit, 0, farthest_offset);
  }
  if (const auto at = value.find("at")) placement.at = joint_name(*at, part);
  if (const auto level = value.find("level")) {
    if (placement.at.empty()) level->fail("needs a joint", "add 'at'");
    placement.level =
        up_sign(placement.axis) * length(*level, unit, -farthest_drawn, farthest_drawn);
  }
  return placement;
}

nlohmann::ordered_json placement_json(const PanelPlacement& placement) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (placement.side != PlacementSide::none) {
    json["side"] = side_words[static_cast<std::size_t>(placement.side)];
  }
  if (placement.around > 0) json["around"] = placement.around;
  if (placement.axis != PlacementAxis::plus_y) {
    json["axis"] = axis_words[static_cast<std::size_t>(placement.axis)];
  }
  if (placement.turn_degrees != 0) json["turn"] = placement.turn_degrees;
  if (placement.shift != 0) json["shift"] = placement.shift;
  if (placement.offset) json["offset"] = *placement.offset;
  if (!placement.at.empty()) json["at"] = placement.at;
  if (placement.level) json["level"] = up_sign(placement.axis) * *placement.level;
  return json;
}

}  // namespace toile
