#include "io/view/three.h"

#include "io/view/embedded.h"
#include "io/view/page_template.h"

TOILE_EMBED(toile_three_html, TOILE_THREE_PAGE);
TOILE_EMBED(toile_three_js, TOILE_THREE);
TOILE_EMBED(toile_orbit_controls_js, TOILE_CONTROLS);

namespace toile {

std::string three_js() {
  return filled(toile_three_html, [](std::string_view name) -> std::string {
    return std::string(name == "three" ? toile_three_js : toile_orbit_controls_js);
  });
}

}  // namespace toile
