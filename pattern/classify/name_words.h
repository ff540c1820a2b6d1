// The words of a name that somebody gave, in any of five languages.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace toile {

struct NameWord {
  std::string text;     ///< small letters without accents, or digits
  bool number = false;  ///< whether it is digits
};

/// Runs of letters, cut where a capital follows a small letter, and runs of digits. `name` is
/// UTF-8; letters beyond Latin-1 part words.
std::vector<NameWord> words_in(const std::string& name);

/// Whether a word begins with one of `beginnings`, or holds it: German joins words, as Vorderhose
/// and Hemdkragen. A beginning of four letters has to begin or end the word, one of three or fewer
/// has to be the word.
bool any_fits(const std::vector<NameWord>& words,
              std::initializer_list<std::string_view> beginnings);

}  // namespace toile
