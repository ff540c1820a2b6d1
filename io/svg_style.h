// The part of CSS that says which elements of an SVG are drawn.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// The words of a text that blanks separate.
std::vector<std::string> split_words(std::string_view text);

/// The value that declarations such as "display:none; stroke:red" give a property; the last counts.
std::optional<std::string> declared(std::string_view declarations, std::string_view property);

/// Rules of style sheets for the properties `display` and `visibility`. Selectors of one element
/// name, id or class are known, and those that join them: "path.sa". Others are passed over.
class SvgStyleSheet {
 public:
  /// Adds the rules of a sheet, after those that are there. Rules within @media and the like are
  /// passed over. Beyond a thousand rules the rest is.
  void add(std::string_view sheet);

  /// What the sheets say for an element: the rule that is most specific, of those the last.
  std::optional<std::string> find(std::string_view property, std::string_view element,
                                  std::string_view id,
                                  const std::vector<std::string>& classes) const;

 private:
  struct Rule {
    std::string element;  ///< empty: any
    std::string id;       ///< empty: any
    std::vector<std::string> classes;
    int specificity = 0;
    std::string display;     ///< empty: not set
    std::string visibility;  ///< empty: not set
  };
  void add_rule(std::string_view selector, std::string_view declarations);

  std::vector<Rule> rules_;
};

}  // namespace toile
