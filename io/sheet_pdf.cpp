#include <cairo-pdf.h>
#include <cairo.h>

#include <cmath>
#include <memory>
#include <new>

#include "geometry/error.h"
#include "io/sheet.h"
#include "io/text.h"

namespace toile {

namespace {

constexpr double points_per_metre = 72 / 0.0254;

/// Metres: a page of PDF 1.5 has 14,400 points at most.
constexpr double max_page = 14'400 / points_per_metre;

/// Metres.
constexpr double head_length = 7e-3;
constexpr double thin_line = 0.3e-3;

cairo_status_t append_bytes(void* target, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// A page whose coordinates are metres, y up.
class Page {
 public:
  explicit Page(const Sheet& sheet)
      : surface_(cairo_pdf_surface_create_for_stream(append_bytes, &bytes_,
                                                     sheet.size.x() * points_per_metre,
                                                     sheet.size.y() * points_per_metre)),
        context_(cairo_create(surface_.get())) {
    cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_TITLE,
                                   valid_utf8(sheet.title).c_str());
    // The same pattern gives the same bytes on any day.
    cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                   "2000-01-01T00:00:00Z");
    cairo_scale(context_.get(), points_per_metre, -points_per_metre);
    cairo_translate(context_.get(), 0, -sheet.size.y());
    cairo_set_source_rgb(context_.get(), 0.13, 0.13, 0.13);
    cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_select_font_face(context_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
  }

  void path(const DrawnPath& path, const SheetStyle& style) {
    cairo_t* context = context_.get();
    cairo_set_line_width(context, style.width);
    const double dashes[] = {4e-3, 2e-3};
    cairo_set_dash(context, dashes, style.dashed ? 2 : 0, 0);
    cairo_move_to(context, path.start.x(), path.start.y());
    for (const DrawnSegment& segment : path.segments) {
      if (segment.curved) {
        cairo_curve_to(context, segment.control1.x(), segment.control1.y(), segment.control2.x(),
                       segment.control2.y(), segment.end.x(), segment.end.y());
      } else {
        cairo_line_to(context, segment.end.x(), segment.end.y());
      }
    }
    if (path.closed) cairo_close_path(context);
    cairo_stroke(context);
    if (style.arrows) {
      head(path.start, path.segments.front().end);
      head(end_of(path), path.start);
    }
  }

  void line(const Vec2& from, const Vec2& to, double width) {
    path({from, {DrawnSegment::line(to)}, false}, {"", 0, width, false, false});
  }

  void mark(const SheetMark& mark) {
    if (mark.sign == SheetMark::Sign::notch) {
      const double angle = mark.angle.value_or(0);
      line(mark.at, mark.at + notch_length * Vec2(std::cos(angle), std::sin(angle)), 2 * thin_line);
    }
    if (mark.sign == SheetMark::Sign::hole) {
      line(mark.at - Vec2(2e-3, 0), mark.at + Vec2(2e-3, 0), thin_line);
      line(mark.at - Vec2(0, 2e-3), mark.at + Vec2(0, 2e-3), thin_line);
    }
  }

  void text(const SheetText& text) {
    cairo_t* context = context_.get();
    const std::string shown = valid_utf8(text.text);
    cairo_save(context);
    cairo_translate(context, text.at.x(), text.at.y());
    cairo_rotate(context, text.angle);
    cairo_scale(context, 1, -1);
    cairo_set_font_size(context, text.height);
    cairo_text_extents_t extents;
    cairo_text_extents(context, shown.c_str(), &extents);
    cairo_move_to(context, -extents.x_advance / 2, 0.35 * text.height);
    cairo_show_text(context, shown.c_str());
    cairo_restore(context);
  }

  std::string finish() {
    cairo_show_page(context_.get());
    cairo_surface_finish(surface_.get());
    if (cairo_surface_status(surface_.get()) != CAIRO_STATUS_SUCCESS ||
        cairo_status(context_.get()) != CAIRO_STATUS_SUCCESS) {
      throw std::bad_alloc();
    }
    return std::move(bytes_);
  }

 private:
  /// The head of an arrow with its tip at `tip`, that comes from `from`.
  void head(const Vec2& tip, const Vec2& from) {
    const Vec2 back = head_length * (from - tip).normalized();
    const Vec2 aside(-0.36 * back.y(), 0.36 * back.x());
    cairo_t* context = context_.get();
    cairo_move_to(context, tip.x(), tip.y());
    for (const Vec2& to : {Vec2(tip + back + aside), Vec2(tip + back - aside)}) {
      cairo_line_to(context, to.x(), to.y());
    }
    cairo_close_path(context);
    cairo_fill(context);
  }

  struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
  };
  std::string bytes_;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

}  // namespace

std::string sheet_pdf(const Sheet& sheet) {
  if (sheet.size.maxCoeff() > max_page) {
    throw Error("the PDF",
                "would be a page of " + fixed_number(sheet.size.x(), 2) + " m by " +
                    fixed_number(sheet.size.y(), 2) + " m, and 5.08 m are the most",
                "write SVG or DXF");
  }
  Page page(sheet);
  for (const SheetPart& part : sheet.parts) {
    for (const SheetPath& path : part.paths) {
      const SheetStyle& style = sheet.styles[static_cast<std::size_t>(path.style)];
      if (!style.css_class.empty()) page.path(path.path, style);
    }
    for (const SheetMark& mark : part.marks) page.mark(mark);
    for (const SheetText& text : part.texts) page.text(text);
  }
  if (sheet.scale_bar) {
    const Vec2 start = *sheet.scale_bar;
    const Vec2 end = start + Vec2(scale_bar_length, 0);
    page.line(start, end, thin_line);
    for (const Vec2& at : {start, end}) {
      page.line(at - Vec2(0, 2e-3), at + Vec2(0, 2e-3), thin_line);
    }
    page.text({"10 cm", (start + end) / 2 + Vec2(0, 4e-3), 4e-3, 0});
  }
  return page.finish();
}

}  // namespace toile
