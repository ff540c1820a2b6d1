#include "pattern/panel_kind.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace toile {

namespace {

/// The words of a name in small letters: runs of letters, cut where a capital follows a small one.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words;
  bool in_word = false;
  bool was_small = false;
  for (const char letter : name) {
    const auto c = static_cast<unsigned char>(letter);
    const bool is_letter = std::isalpha(c) != 0;
    if (is_letter && (!in_word || (was_small && std::isupper(c) != 0))) words.emplace_back();
    if (is_letter) words.back() += static_cast<char>(std::tolower(c));
    in_word = is_letter;
    was_small = std::islower(c) != 0;
  }
  return words;
}

bool has_any(const std::vector<std::string>& words,
             std::initializer_list<std::string_view> wanted) {
  return std::ranges::any_of(words, [&](const std::string& word) {
    return std::ranges::find(wanted, word) != wanted.end();
  });
}

PanelKind kind_by_name(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  if (has_any(words, {"trouser", "trousers", "pant", "pants", "jeans", "shorts", "leg", "legs"})) {
    return PanelKind::trousers;
  }
  if (has_any(words, {"sleeve", "sleeves", "cuff", "cuffs"})) return PanelKind::sleeve;
  if (has_any(words, {"skirt", "godet"})) return PanelKind::skirt;
  if (has_any(words, {"wb", "waistband", "belt"})) return PanelKind::band;
  if (has_any(words, {"torso", "ftorso", "btorso", "bodice", "top", "yoke", "collar", "hood",
                      "lapel", "shirt", "blouse"})) {
    return PanelKind::top;
  }
  return PanelKind::unknown;
}

}  // namespace

PanelKind kind_of(const MeshedPanel& panel) {
  const PanelKind by_name = kind_by_name(panel.name);
  if (panel.part.ends_with("_arm") || panel.label == "arm") return PanelKind::sleeve;
  if (panel.part.ends_with("_leg")) return PanelKind::trousers;
  if (panel.part == "head") return PanelKind::top;
  if (panel.label == "leg") {
    return by_name == PanelKind::trousers ? PanelKind::trousers : PanelKind::skirt;
  }
  if (panel.label == "body") return by_name == PanelKind::band ? by_name : PanelKind::top;
  return by_name;
}

bool names_headwear(const std::string& name) {
  return has_any(words_of(name), {"hood", "collar", "turtle", "lapel"});
}

int side_by_name(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  const bool left = has_any(words, {"left", "l"});
  const bool right = has_any(words, {"right", "r"});
  return static_cast<int>(left) - static_cast<int>(right);
}

int face_by_name(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  const bool front = has_any(words, {"front", "f", "ftorso"});
  const bool back = has_any(words, {"back", "b", "btorso"});
  return static_cast<int>(front) - static_cast<int>(back);
}

}  // namespace toile
