#include "pattern/classify/name_words.h"

#include <cctype>

namespace toile {

namespace {

/// The letter without its accent, of the two-byte letters of UTF-8 that begin with C3.
char plain_letter(unsigned char second) {
  static constexpr std::string_view plain =
      "aaaaaaaceeeeiiiidnooooo ouuuuy saaaaaaaceeeeiiiidnooooo ouuuuy y";
  return second >= 0x80 && second < 0xC0 ? plain[second - 0x80] : ' ';
}

}  // namespace

std::vector<NameWord> words_in(const std::string& name) {
  std::vector<NameWord> words;
  enum class Kind { none, letter, digit } last = Kind::none;
  bool was_small = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    auto c = static_cast<unsigned char>(name[i]);
    bool capital = std::isupper(c) != 0;
    if (c == 0xC3 && i + 1 < name.size()) {
      const auto second = static_cast<unsigned char>(name[++i]);
      capital = second < 0xA0;
      c = static_cast<unsigned char>(plain_letter(second));
    }
    const Kind kind = std::isalpha(c) != 0   ? Kind::letter
                      : std::isdigit(c) != 0 ? Kind::digit
                                             : Kind::none;
    if (kind != Kind::none) {
      if (kind != last || (kind == Kind::letter && was_small && capital)) {
        words.push_back({"", kind == Kind::digit});
      }
      words.back().text += static_cast<char>(std::tolower(c));
    }
    last = kind;
    was_small = kind == Kind::letter && !capital;
  }
  return words;
}

bool any_fits(const std::vector<NameWord>& words,
              std::initializer_list<std::string_view> beginnings) {
  for (const NameWord& word : words) {
    for (const std::string_view beginning : beginnings) {
      // German joins words: Vorderhose, Hemdkragen. Short beginnings would be found anywhere.
      const bool fits = beginning.size() < 4 ? word.text == beginning
                        : beginning.size() < 5
                            ? word.text.starts_with(beginning) || word.text.ends_with(beginning)
                            : word.text.find(beginning) != std::string::npos;
      if (fits) return true;
    }
  }
  return false;
}

}  // namespace toile
