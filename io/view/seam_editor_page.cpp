#include "io/view/seam_editor_page.h"

#include <nlohmann/json.hpp>

#include "io/text.h"
#include "io/view/embedded.h"
#include "io/view/page_template.h"
#include "io/view/three.h"

TOILE_EMBED(toile_editor_html, TOILE_EDITOR_PAGE);
TOILE_EMBED(toile_pattern_model_js, TOILE_PATTERN_MODEL);
TOILE_EMBED(toile_sheet_js, TOILE_SHEET);
TOILE_EMBED(toile_drape_view_js, TOILE_DRAPE_VIEW);
TOILE_EMBED(toile_editor_js, TOILE_EDITOR);

namespace toile {

std::string seam_editor_page(const SeamEditorPage& page) {
  // The pattern's own text goes in: its keys keep their order, its numbers their digits.
  const auto text = [](const std::string& words) {
    return nlohmann::json(valid_utf8(words)).dump();
  };
  const std::string data = "{\"name\":" + text(page.name) + ",\"pattern\":" + page.pattern +
                           ",\"proposals\":" + (page.proposals.empty() ? "null" : page.proposals) +
                           ",\"served\":" + (page.served ? "true" : "false") +
                           ",\"version\":" + text(page.version) + ",\"body\":" + text(page.body) +
                           "}";
  return filled(toile_editor_html, [&](std::string_view name) -> std::string {
    if (name == "title") return html_escaped(page.name);
    if (name == "data") return json_in_html(data);
    if (name == "libraries") return page.body.empty() ? "" : three_js();
    if (name == "model") return std::string(toile_pattern_model_js);
    if (name == "sheet") return std::string(toile_sheet_js);
    if (name == "drape") return std::string(toile_drape_view_js);
    return std::string(toile_editor_js);  // "editor"
  });
}

}  // namespace toile
