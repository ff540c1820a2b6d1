#include "io/svg_style.h"

#include <algorithm>

namespace toile {

namespace {

constexpr std::size_t max_rules = 1000;

constexpr std::string_view blanks = " \t\r\n\f";

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string without_comments(std::string_view sheet) {
  std::string kept;
  while (!sheet.empty()) {
    const std::size_t start = sheet.find("/*");
    kept += sheet.substr(0, start);
    if (start == std::string_view::npos) break;
    const std::size_t end = sheet.find("*/", start + 2);
    if (end == std::string_view::npos) break;
    sheet.remove_prefix(end + 2);
  }
  return kept;
}

/// Where the block that opens at `open` ends: the place of its brace, or the end.
std::size_t block_end(std::string_view sheet, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < sheet.size(); ++i) {
    if (sheet[i] == '{') ++depth;
    if (sheet[i] == '}' && --depth == 0) return i;
  }
  return sheet.size();
}

}  // namespace

std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words;
  for (;;) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return words;
    text.remove_prefix(first);
    const std::size_t length = std::min(text.find_first_of(blanks), text.size());
    words.emplace_back(text.substr(0, length));
    text.remove_prefix(length);
  }
}

std::optional<std::string> declared(std::string_view declarations, std::string_view property) {
  std::optional<std::string> value;
  while (!declarations.empty()) {
    const std::size_t end = std::min(declarations.find(';'), declarations.size());
    const std::string_view one = declarations.substr(0, end);
    declarations.remove_prefix(std::min(end + 1, declarations.size()));
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos || without_blanks(one.substr(0, colon)) != property)
      continue;
    value = std::string(without_blanks(one.substr(colon + 1, one.find('!') - colon - 1)));
  }
  return value;
}

void SvgStyleSheet::add(std::string_view given) {
  const std::string text = without_comments(given);
  std::string_view sheet = text;
  for (;;) {
    const std::size_t open = sheet.find('{');
    if (open == std::string_view::npos) return;
    const std::size_t end = block_end(sheet, open);
    std::string_view selectors = sheet.substr(0, open);
    // A statement such as @import ends with a semicolon.
    selectors = without_blanks(selectors.substr(selectors.rfind(';') + 1));
    const std::string_view body = sheet.substr(open + 1, end - open - 1);
    sheet.remove_prefix(std::min(end + 1, sheet.size()));
    if (selectors.starts_with('@')) continue;
    while (!selectors.empty()) {
      const std::size_t comma = std::min(selectors.find(','), selectors.size());
      add_rule(without_blanks(selectors.substr(0, comma)), body);
      selectors.remove_prefix(std::min(comma + 1, selectors.size()));
    }
  }
}

void SvgStyleSheet::add_rule(std::string_view selector, std::string_view declarations) {
  const auto display = declared(declarations, "display");
  const auto visibility = declared(declarations, "visibility");
  if ((!display && !visibility) || selector.empty() || rules_.size() >= max_rules) return;
  if (selector.find_first_of(" \t\r\n\f>+~[:") != std::string_view::npos) return;
  Rule rule;
  rule.display = display.value_or("");
  rule.visibility = visibility.value_or("");
  while (!selector.empty()) {
    const char kind = selector[0];
    const bool named = kind == '.' || kind == '#';
    if (named) selector.remove_prefix(1);
    const std::size_t end = std::min(selector.find_first_of(".#"), selector.size());
    const std::string name(selector.substr(0, end));
    selector.remove_prefix(end);
    if (name.empty()) return;
    if (kind == '.') {
      rule.classes.push_back(name);
      rule.specificity += 1000;
    } else if (kind == '#') {
      rule.id = name;
      rule.specificity += 1'000'000;
    } else if (name != "*") {
      rule.element = name;
      rule.specificity += 1;
    }
  }
  rules_.push_back(std::move(rule));
}

std::optional<std::string> SvgStyleSheet::find(std::string_view property, std::string_view element,
                                               std::string_view id,
                                               const std::vector<std::string>& classes) const {
  const Rule* best = nullptr;
  for (const Rule& rule : rules_) {
    const std::string& value = property == "display" ? rule.display : rule.visibility;
    if (value.empty() || (best != nullptr && best->specificity > rule.specificity)) continue;
    if (!rule.element.empty() && rule.element != element) continue;
    if (!rule.id.empty() && rule.id != id) continue;
    if (!std::all_of(rule.classes.begin(), rule.classes.end(), [&](const std::string& name) {
          return std::find(classes.begin(), classes.end(), name) != classes.end();
        })) {
      continue;
    }
    best = &rule;
  }
  if (best == nullptr) return std::nullopt;
  return property == "display" ? best->display : best->visibility;
}

}  // namespace toile
