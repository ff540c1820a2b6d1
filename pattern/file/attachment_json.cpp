#include "pattern/file/attachment_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "io/json_words.h"
#include "io/text.h"

namespace toile {

namespace {

constexpr std::array<std::string_view, 6> place_words = {"", "place", "skin", "", "side", "height"};
constexpr std::array<std::string_view, 3> while_words = {"dressing", "always", "slipping"};
constexpr std::array<std::string_view, 7> known_keys = {
    "edge", "vertex", "to", "above", "while", "stiffness_N_per_m", "max_N"};

/// Metres: the largest coordinate or height that an attachment may have.
constexpr double farthest = 10;
constexpr double max_stiffness = 1e6;   // N/m
constexpr double max_pull_limit = 1e4;  // N

std::vector<std::string_view> target_words() {
  std::vector<std::string_view> words(joint_names.begin(), joint_names.end());
  words.insert(words.end(), girth_names.begin(), girth_names.end());
  words.insert(words.end(), {"place", "skin", "side", "height"});
  return words;
}

double length(const JsonValue& value, double unit) {
  const double metres = value.number() * unit;
  if (std::abs(metres) > farthest) value.fail("is more than 10 m", "check 'units_in_meter'");
  return metres;
}

double positive(const JsonValue& value, double max, const std::string& remedy) {
  const double number = value.number();
  if (!(number > 0 && number <= max)) {
    value.fail("is not above 0 and at most " + fixed_number(max, 0), remedy);
  }
  return number;
}

void read_target(const JsonValue& to, double unit, Attachment& attachment) {
  if (to.is_array()) {
    attachment.to = AttachedTo::point;
    to.size(3, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      attachment.point[static_cast<Eigen::Index>(i)] = length(to.item(i), unit);
    }
    return;
  }
  const std::vector<std::string_view> words = target_words();
  const std::string_view word = words[word_of(to, words)];
  attachment.to = word == "place"    ? AttachedTo::place
                  : word == "skin"   ? AttachedTo::skin
                  : word == "side"   ? AttachedTo::side
                  : word == "height" ? AttachedTo::height
                                     : AttachedTo::level;
  if (attachment.to == AttachedTo::level) attachment.landmark = word;
}

/// The edge or vertex that an entry holds.
PanelAttachment attached_edge(const JsonValue& entry, const JsonValue& edges) {
  using Share = PanelAttachment::Share;
  const auto edge = entry.find("edge");
  const auto vertex = entry.find("vertex");
  if (edge.has_value() == vertex.has_value()) {
    entry.fail("names no edge and no vertex, or both", "give it 'edge' or 'vertex', from 0");
  }
  const int count = static_cast<int>(edges.size());
  if (edge) {
    const int number = edge->index();
    if (number >= count) {
      entry.fail("names edge " + std::to_string(number) + ", but the panel has edges 0 to " +
                 std::to_string(count - 1));
    }
    return {std::to_string(number), number, Share::whole, {}};
  }
  const int number = vertex->index();
  for (int e = 0; e < count; ++e) {
    const JsonValue ends = edges.item(static_cast<std::size_t>(e)).get("endpoints");
    for (const Share share : {Share::start, Share::end}) {
      if (ends.item(share == Share::start ? 0 : 1).index() != number) continue;
      return {std::string("v").append(std::to_string(number)), e, share, {}};
    }
  }
  entry.fail("names vertex " + std::to_string(number) + ", which no edge of the panel has");
}

}  // namespace

std::vector<PanelAttachment> read_panel_attachments(const JsonValue& attach, const JsonValue& edges,
                                                    double unit) {
  std::vector<PanelAttachment> all;
  for (std::size_t i = 0; i < attach.size(); ++i) {
    const JsonValue entry = attach.item(i).called(attach.place() + " " + std::to_string(i));
    refuse_other_keys(entry, known_keys);
    all.push_back(attached_edge(entry, edges));
    all.back().how = read_attachment(entry, unit);
  }
  return all;
}

Attachment read_attachment(const JsonValue& entry, double unit) {
  Attachment attachment;
  read_target(entry.get("to"), unit, attachment);
  if (const auto above = entry.find("above")) {
    if (attachment.to != AttachedTo::level) {
      above->fail("is given, but 'to' names no level",
                  "let 'to' name a joint or a girth, or leave it out");
    }
    attachment.above = length(*above, unit);
  }
  if (const auto until = entry.find("while")) {
    const std::string_view word = while_words[word_of(*until, while_words)];
    attachment.always = word == "always";
    attachment.only_if_it_slips = word == "slipping";
  }
  if (const auto stiffness = entry.find("stiffness_N_per_m")) {
    attachment.stiffness = positive(*stiffness, max_stiffness, "5000 gives way by 0.2 mm for 1 N");
  }
  if (const auto max_pull = entry.find("max_N")) {
    attachment.max_pull = positive(*max_pull, max_pull_limit, "a garment weighs 1 to 20 N");
  }
  return attachment;
}

nlohmann::ordered_json attachment_json(const Attachment& attachment) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (attachment.to == AttachedTo::point) {
    json["to"] = {attachment.point.x(), attachment.point.y(), attachment.point.z()};
  } else if (attachment.to == AttachedTo::level) {
    json["to"] = attachment.landmark;
  } else {
    json["to"] = place_words[static_cast<std::size_t>(attachment.to)];
  }
  if (attachment.above != 0) json["above"] = attachment.above;
  json["while"] = while_words[attachment.always ? 1 : (attachment.only_if_it_slips ? 2 : 0)];
  json["stiffness_N_per_m"] = attachment.stiffness;
  json["max_N"] = attachment.max_pull;
  return json;
}

}  // namespace toile
