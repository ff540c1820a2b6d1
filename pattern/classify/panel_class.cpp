#include "pattern/classify/panel_class.h"

#include <algorithm>
#include <array>
#include <vector>

namespace toile {

namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

}  // namespace

std::string name_of(PanelRole role) {
  constexpr std::array<const char*, 12> names = {"",          "bodice", "skirt",  "trousers",
                                                 "sleeve",    "cuff",   "collar", "hood",
                                                 "waistband", "yoke",   "facing", "pocket"};
  return names[static_cast<std::size_t>(role)];
}

std::string text_of(const PanelClass& is) {
  constexpr std::array<const char*, 7> sources = {"",         "as stated", "by label", "by name",
                                                  "by seams", "by shape",  "as asked"};
  std::vector<std::string> words;
  std::vector<std::string> by;
  const auto add = [&](const std::string& word, PanelSource source) {
    if (source == PanelSource::none) return;
    if (!word.empty()) words.push_back(word);
    const char* who = sources[static_cast<std::size_t>(source)];
    if (std::ranges::find(by, who) == by.end()) by.emplace_back(who);
  };
  const Told<PanelRole>& piece = is.role != PanelRole::unknown ? is.role : is.worn_as;
  std::string name = name_of(piece);
  if (piece == PanelRole::cuff && is.worn_as == PanelRole::trousers) name += " of trousers";
  add(name, piece.by);
  // Who decided it, where witnesses do not agree.
  if (!is.contradiction.empty()) add("", is.worn_as.by);
  if (piece.by == PanelSource::none) add(name_of(is.part), is.part.by);
  add(is.side == PanelSide::left ? "left" : "right", is.side.by);
  add(is.face == PanelFace::front ? "front" : "back", is.face.by);
  if (is.around) add("around its part", is.around.by);
  return joined(words, ", ") + (by.empty() ? "" : ", ") + joined(by, " and ");
}

}  // namespace toile
