#include "io/view/picture.h"

#include <cairo.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

#include "geometry/error.h"
#include "io/text.h"

namespace toile {

namespace {

constexpr Colour paper{251 / 255.0, 251 / 255.0, 250 / 255.0};  // as the background of RayScene
constexpr Colour ink{0.16, 0.16, 0.18};
constexpr Colour faint_ink{0.42, 0.42, 0.45};

Camera camera_of(View view) {
  Camera camera;
  switch (view) {
    case View::front:
      camera.forward = -Vec3::UnitZ();
      break;
    case View::back:
      camera.forward = Vec3::UnitZ();
      break;
    case View::left:
      camera.forward = -Vec3::UnitX();
      break;
    case View::right:
      camera.forward = Vec3::UnitX();
      break;
    case View::top:
      camera.forward = -Vec3::UnitY();
      camera.up = -Vec3::UnitZ();
      break;
  }
  return camera;
}

/// The box of the framed meshes' points that belong to a triangle; of all meshes if none is framed.
Eigen::AlignedBox3d framed_box(const std::vector<PictureMesh>& meshes) {
  Eigen::AlignedBox3d box;
  for (const bool all : {false, true}) {
    for (const PictureMesh& mesh : meshes) {
      if (!all && !mesh.framed) continue;
      for (const Triangle& triangle : mesh.mesh.triangles) {
        for (const int corner : triangle) {
          box.extend(mesh.mesh.points[static_cast<std::size_t>(corner)]);
        }
      }
    }
    if (!box.isEmpty()) break;
  }
  return box;
}

/// Metres: width and height of the box as a camera sees it.
Vec2 seen_size(const Eigen::AlignedBox3d& box, const Camera& camera) {
  const Vec3 right = camera.forward.cross(camera.up);
  return {box.sizes().dot(right.cwiseAbs()), box.sizes().dot(camera.up.cwiseAbs())};
}

/// A cairo surface with its context. Text and shapes have their sizes and places in pixels.
class Canvas {
 public:
  Canvas(int width, int height)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
        context_(cairo_create(surface_.get())) {
    if (cairo_status(context_.get()) != CAIRO_STATUS_SUCCESS) {
      throw Error(
          "picture",
          "can't be " + std::to_string(width) + " x " + std::to_string(height) + " pixels large",
          "make it smaller or show fewer views");
    }
    rectangle(0, 0, width, height, paper);
    cairo_select_font_face(context_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
  }

  void rectangle(double x, double y, double width, double height, const Colour& colour) {
    set(colour);
    cairo_rectangle(context_.get(), x, y, width, height);
    cairo_fill(context_.get());
  }

  void outline(double x, double y, double width, double height, const Colour& colour) {
    set(colour);
    cairo_set_line_width(context_.get(), 1);
    cairo_rectangle(context_.get(), x + 0.5, y + 0.5, width - 1, height - 1);
    cairo_stroke(context_.get());
  }

  double text_width(const std::string& text, double size) {
    cairo_set_font_size(context_.get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(context_.get(), valid_utf8(text).c_str(), &extents);
    return extents.x_advance;
  }

  /// Draws text on the base line y. `align` 0 starts it at x, 0.5 centres it on x, 1 ends it at x.
  void text(double x, double y, const std::string& text, double size, const Colour& colour,
            double align = 0) {
    x -= align * text_width(text, size);
    set(colour);
    cairo_move_to(context_.get(), x, y);
    cairo_show_text(context_.get(), valid_utf8(text).c_str());
  }

  void paste(const Image& image, int left, int top) {
    cairo_surface_flush(surface_.get());
    unsigned char* rows = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    const std::uint8_t* byte = image.bytes.data();
    for (int y = 0; y < image.height; ++y) {
      auto* pixel = reinterpret_cast<std::uint32_t*>(rows + (top + y) * stride) + left;
      for (int x = 0; x < image.width; ++x, byte += 3) {
        *pixel++ = static_cast<std::uint32_t>(byte[0]) << 16U |
                   static_cast<std::uint32_t>(byte[1]) << 8U | byte[2];
      }
    }
    cairo_surface_mark_dirty(surface_.get());
  }

  std::string png() {
    std::string bytes;
    const auto append = [](void* target, const unsigned char* data, unsigned length) {
      static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(data), length);
      return CAIRO_STATUS_SUCCESS;
    };
    if (cairo_surface_write_to_png_stream(surface_.get(), append, &bytes) != CAIRO_STATUS_SUCCESS) {
      throw std::bad_alloc();
    }
    return bytes;
  }

 private:
  void set(const Colour& colour) {
    cairo_set_source_rgb(context_.get(), colour.red, colour.green, colour.blue);
  }

  struct Release {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
  };
  std::unique_ptr<cairo_surface_t, Release> surface_;
  std::unique_ptr<cairo_t, Release> context_;
};

double bar_width(Canvas& canvas, const ColourBar& bar, double size) {
  double width = std::max(6.5 * size, canvas.text_width(bar.title, size) + size);
  const auto hold = [&](const std::string& text) {
    width = std::max(width, canvas.text_width(text, size) + 3 * size);
  };
  hold(bar.below);
  hold(bar.above);
  for (const BarMark& mark : bar.marks) hold(mark.text);
  return width;
}

void draw_bar(Canvas& canvas, const ColourBar& bar, double left, double top, double height,
              double size) {
  canvas.text(left, top + size, bar.title, size, ink);
  top += 2.4 * size;
  height -= 2.4 * size;
  const double width = 1.4 * size;
  if (!bar.below.empty()) height -= 2 * size;
  if (!bar.above.empty()) {
    canvas.rectangle(left, top, width, 1.2 * size, bar.ramp.above.value_or(bar.ramp.steps.back()));
    canvas.text(left + width + 0.7 * size, top + size, bar.above, size, ink);
    top += 2 * size;
    height -= 2 * size;
  }
  const int rows = std::max(1, static_cast<int>(height));
  for (int row = 0; row < rows; ++row) {
    const double value = bar.ramp.high - (row + 0.5) / rows * (bar.ramp.high - bar.ramp.low);
    canvas.rectangle(left, std::floor(top) + row, width, 1, bar.ramp.at(value));
  }
  for (const BarMark& mark : marks_of(bar)) {
    const double y =
        std::floor(top) + (bar.ramp.high - mark.value) / (bar.ramp.high - bar.ramp.low) * rows;
    canvas.rectangle(left + width, std::round(y) - 0.5, 0.4 * size, 1, ink);
    canvas.text(left + width + 0.7 * size, y + 0.35 * size, mark.text, size, ink);
  }
  if (!bar.below.empty()) {
    const double y = std::floor(top) + rows + 0.8 * size;
    canvas.rectangle(left, y, width, 1.2 * size, bar.ramp.below);
    canvas.text(left + width + 0.7 * size, y + size, bar.below, size, ink);
  }
}

/// Lays the legend's entries out in rows of `width` pixels from `top` on, and draws them if
/// `visible`. It returns the height in pixels.
double draw_legend(Canvas& canvas, const std::vector<LegendEntry>& legend, double left,
                   double width, double top, double size, bool visible) {
  if (legend.empty()) return 0;
  double x = left;
  double y = top;
  for (const LegendEntry& entry : legend) {
    const double needed = 1.6 * size + canvas.text_width(entry.label, size) + 1.6 * size;
    if (x > left && x + needed > left + width) {
      x = left;
      y += 1.7 * size;
    }
    if (visible) {
      canvas.rectangle(x, y + 0.1 * size, size, size, entry.colour);
      canvas.outline(x, y + 0.1 * size, size, size, faint_ink);
      canvas.text(x + 1.5 * size, y + 0.95 * size, entry.label, size, ink);
    }
    x += needed;
  }
  return y + 1.7 * size - top;
}

}  // namespace

std::optional<View> view_named(std::string_view name) {
  const auto found = std::ranges::find(view_names, name);
  if (found == view_names.end()) return std::nullopt;
  return static_cast<View>(found - view_names.begin());
}

std::string picture_png(std::vector<PictureMesh> meshes, const Picture& picture) {
  return picture_png(RayScene(std::move(meshes)), picture);
}

std::string picture_png(const RayScene& scene, const Picture& picture) {
  if (picture.views.empty()) throw Error("picture", "no view is asked for", "");
  const Eigen::AlignedBox3d box = framed_box(scene.meshes());

  constexpr double margin = 1.12;
  const int width = std::clamp(picture.view_width, 16, 4096);
  Vec2 needed = Vec2::Zero();
  for (const View view : picture.views) {
    needed = needed.cwiseMax(seen_size(box, camera_of(view)) * margin);
  }
  needed = needed.cwiseMax(1e-9 + 1e-6 * box.diagonal().norm());
  const int height =
      picture.view_height > 0
          ? std::min(picture.view_height, 8192)
          : static_cast<int>(std::lround(width * std::clamp(needed.y() / needed.x(), 0.4, 2.2)));
  const double metres_per_pixel = std::max(needed.x() / width, needed.y() / height);

  const double size = std::max(11.0, width / 42.0);
  const auto views = static_cast<int>(picture.views.size());
  const int gap = static_cast<int>(0.5 * size);
  const int row = views * width + (views - 1) * gap;
  const int head = picture.title.empty() ? 0 : static_cast<int>(2.4 * size);
  const int caption = static_cast<int>(2.2 * size);
  Canvas ruler(16, 16);
  const double side = picture.bar ? bar_width(ruler, *picture.bar, size) + 2 * size : 0;
  const double legend =
      draw_legend(ruler, picture.legend, size, row + side - 2 * size, 0, size, false);
  Canvas canvas(row + static_cast<int>(side),
                head + height + caption + static_cast<int>(std::ceil(legend)));

  if (head > 0) canvas.text(size, 1.6 * size, picture.title, 1.15 * size, ink);
  for (int i = 0; i < views; ++i) {
    const View view = picture.views[static_cast<std::size_t>(i)];
    Camera camera = camera_of(view);
    camera.centre = box.center();
    camera.metres_per_pixel = metres_per_pixel;
    const int left = i * (width + gap);
    canvas.paste(scene.render(camera, width, height), left, head);
    canvas.text(left + 0.5 * width, head + height + 1.3 * size,
                std::string(view_names[static_cast<std::size_t>(view)]), size, faint_ink, 0.5);
  }
  if (picture.bar) {
    const double bar_height = std::min(0.8 * height, 26 * size);
    draw_bar(canvas, *picture.bar, row + size, head + 0.5 * (height - bar_height), bar_height,
             size);
  }
  draw_legend(canvas, picture.legend, size, row + side - 2 * size, head + height + caption, size,
              true);
  return canvas.png();
}

}  // namespace toile
