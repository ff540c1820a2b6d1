#include "pattern/classify/panel_class_json.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/json_words.h"

namespace toile {

namespace {

constexpr std::array<std::string_view, 8> class_keys = {
    "part", "role", "worn_as", "side", "face", "around", "by", "contradiction"};

/// A word for each value of an answer, from the least on. Empty: it says nothing.
template <typename Answer>
std::vector<std::string> words_of();
template <>
std::vector<std::string> words_of<BodyPart>() {
  std::vector<std::string> words = {""};
  words.insert(words.end(), body_parts.begin(), body_parts.end());
  return words;
}
template <>
std::vector<std::string> words_of<PanelRole>() {
  std::vector<std::string> words = {""};
  for (int role = 1; role <= static_cast<int>(PanelRole::pocket); ++role) {
    words.push_back(name_of(static_cast<PanelRole>(role)));
  }
  return words;
}
template <>
std::vector<std::string> words_of<PanelSide>() {
  return {"right", "", "left"};
}
template <>
std::vector<std::string> words_of<PanelFace>() {
  return {"back", "", "front"};
}
template <>
std::vector<std::string> words_of<PanelSource>() {
  return {"", "stated", "label", "name", "seams", "shape", "asked"};
}

template <typename Answer>
constexpr int least = 0;
template <>
constexpr int least<PanelSide> = -1;
template <>
constexpr int least<PanelFace> = -1;

template <typename Answer>
std::string word_for(Answer answer) {
  return words_of<Answer>()[static_cast<std::size_t>(static_cast<int>(answer) - least<Answer>)];
}

template <typename Answer>
Answer answer_of(const JsonValue& value) {
  return static_cast<Answer>(static_cast<int>(word_of(value, words_of<Answer>())) + least<Answer>);
}

}  // namespace

nlohmann::ordered_json panel_class_json(const PanelClass& is) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  nlohmann::ordered_json by = nlohmann::ordered_json::object();
  const auto add = [&](const char* key, const auto& told) {
    if (told.by == PanelSource::none) return;
    json[key] = word_for(told.is);
    by[key] = word_for(told.by);
  };
  add("part", is.part);
  add("role", is.role);
  add("worn_as", is.worn_as);
  add("side", is.side);
  add("face", is.face);
  if (is.around) {
    json["around"] = true;
    by["around"] = word_for(is.around.by);
  }
  json["by"] = by;
  if (!is.contradiction.empty()) json["contradiction"] = is.contradiction;
  return json;
}

PanelClass read_panel_class(const JsonValue& value) {
  refuse_other_keys(value, class_keys);
  const JsonValue by = value.get("by");
  refuse_other_keys(by, class_keys);
  PanelClass is;
  const auto read = [&]<typename Answer>(const char* key, Told<Answer>& told) {
    if (const auto answer = value.find(key)) {
      told = {answer_of<Answer>(*answer), answer_of<PanelSource>(by.get(key))};
    }
  };
  read("part", is.part);
  read("role", is.role);
  read("worn_as", is.worn_as);
  read("side", is.side);
  read("face", is.face);
  if (const auto around = value.find("around")) {
    is.around = {around->flag(), answer_of<PanelSource>(by.get("around"))};
  }
  if (const auto contradiction = value.find("contradiction")) {
    is.contradiction = contradiction->text();
  }
  return is;
}

}  // namespace toile
