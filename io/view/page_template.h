// Pages made of a template with gaps.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace toile {

/// `page` with every {{name}} replaced by content(name). The template is read once: {{...}} in the
/// content stays.
std::string filled(std::string_view page,
                   const std::function<std::string(std::string_view)>& content);

/// JSON for an element of a page: no text in it can end the element.
std::string json_in_html(std::string_view json);

}  // namespace toile
