// Pictures of meshes from several sides, with captions and a colour bar, as PNG.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/view/ray_image.h"

namespace toile {

/// The side from which the camera looks at a body that faces +z. `left` is the wearer's left (+x).
/// In the front view the wearer's left is on the picture's right.
enum class View { front, back, left, right, top };

inline constexpr std::array<std::string_view, 5> view_names = {"front", "back", "left", "right",
                                                               "top"};

/// The view of that name, or nothing.
std::optional<View> view_named(std::string_view name);

struct LegendEntry {
  Colour colour;
  std::string label;
};

/// The layout of a picture and its content besides the meshes. Text may hold any bytes.
struct Picture {
  std::string title;                                 ///< empty: none
  std::vector<View> views{View::front, View::back};  ///< from left to right
  int view_width = 900;                              ///< pixels, from 16 to 4096
  int view_height = 0;                               ///< pixels, up to 8192; 0: as the meshes need
  std::optional<ColourBar> bar;
  std::vector<LegendEntry> legend;
};

/// The bytes of a PNG file with all views to one scale, in parallel projection. The same input
/// gives the same bytes with the same versions of the libraries and fonts. It throws Error when
/// there is no triangle or no view to show. The cost is that of RayScene.
std::string picture_png(std::vector<PictureMesh> meshes, const Picture& picture);
std::string picture_png(const RayScene& scene, const Picture& picture);

}  // namespace toile
