// The page and the pictures of an ease map.
#pragma once

#include <string>
#include <vector>

#include "tools/ease_map/report.h"

namespace toile {

/// A page to turn the garment in; see io/view/viewer_page.h. `picture` is what a browser without
/// WebGL shows instead.
std::string ease_page(const EaseReport& report, const std::string& picture);

/// Front and back with the colour bar, PNG, in each of the widths (of a view, in pixels).
std::vector<std::string> ease_pictures(const EaseReport& report, const std::vector<int>& widths);

}  // namespace toile
