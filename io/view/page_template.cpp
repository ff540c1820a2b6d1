#include "io/view/page_template.h"

namespace toile {

std::string filled(std::string_view page,
                   const std::function<std::string(std::string_view)>& content) {
  std::string html;
  for (std::size_t open = 0; (open = page.find("{{")) != std::string_view::npos;) {
    const std::size_t close = page.find("}}", open);
    html += page.substr(0, open);
    html += content(page.substr(open + 2, close - open - 2));
    page.remove_prefix(close + 2);
  }
  return html.append(page);
}

std::string json_in_html(std::string_view json) {
  std::string text;
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace toile
