// Pictures of meshes from several sides, with captions and a colour bar, as PNG.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/view/ray_image.h"

namespace toile {

/// Where the camera stands, for a body that faces +z: `left` is the wearer's left (+x), so in the
/// front view the wearer's left is on the picture's right.
enum class View { front, back, left, right, top };

inline constexpr std::array<std::string_view, 5> view_names = {"front", "back", "left", "right",
                                                               "top"};

/// The view of that name, if there is one.
std::optional<View> view_named(std::string_view name);

struct ColourBar {
  std::string title;  ///< with the unit, such as "gap, mm"
  ColourRamp ramp;
  std::string below;  ///< what the colour below the ramp means; empty: not shown
};

struct LegendEntry {
  Colour colour;
  std::string label;
};

/// What a picture shows besides the meshes. User text may hold any bytes.
struct Picture {
  std::string title;                                 ///< empty: none
  std::vector<View> views{View::front, View::back};  ///< from left to right
  int view_width = 900;                              ///< pixels, from 16 to 4096
  int view_height = 0;                               ///< pixels; 0: as the meshes need it
  std::optional<ColourBar> bar;
  std::vector<LegendEntry> legend;
};

/// The bytes of a PNG file: all views to one scale, in parallel projection. The same input gives
/// the same bytes with the same versions of the libraries and fonts. Throws Error when there is
/// nothing to show.
std::string picture_png(std::vector<PictureMesh> meshes, const Picture& picture);
std::string picture_png(const RayScene& scene, const Picture& picture);

}  // namespace toile
