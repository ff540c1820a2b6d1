// Words and keys in JSON that have to come from a list.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "io/json_value.h"
#include "io/text.h"

namespace toile {

/// `text` as messages show it, in single quotes.
inline std::string in_quotes(const std::string& text) {
  std::string quoted(1, '\'');
  return quoted.append(shown_text(text)).append(1, '\'');
}

/// The words that are not empty, as "a, b, c".
template <class Words>
std::string listed(const Words& words) {
  std::string all;
  for (const std::string_view word : words) {
    if (word.empty()) continue;
    all += (all.empty() ? "" : ", ") + std::string(word);
  }
  return all;
}

/// Throws Error with the value's place for a key that is not in `known`.
template <class Words>
void refuse_other_keys(const JsonValue& value, const Words& known) {
  for (const std::string& key : value.keys()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    value.fail("has an unknown key " + in_quotes(key), "use " + listed(known));
  }
}

/// The index in `words` of the value's word. Throws Error when it is not in `words`.
template <class Words>
std::size_t word_of(const JsonValue& value, const Words& words) {
  const std::string word = value.text();
  const auto found = std::find(words.begin(), words.end(), word);
  if (word.empty() || found == words.end()) {
    value.fail(in_quotes(word) + " is unknown", "use one of " + listed(words));
  }
  return static_cast<std::size_t>(found - words.begin());
}

}  // namespace toile
