// What render does once it knows what is asked.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/view/picture.h"
#include "tools/program.h"

namespace toile {

struct RenderSettings {
  std::string body;                   ///< a file; empty: none
  std::vector<std::string> garments;  ///< files
  std::vector<View> views = {View::front, View::back};
  bool whole = false;  ///< the whole body is shown, not only where the garment is
  int width = 900;     ///< of a view, in pixels
  std::string title;
};

/// Draws the picture. Throws Error for what can't be read or written.
void run_render(const RenderSettings& settings, const CommonSettings& common);

}  // namespace toile
