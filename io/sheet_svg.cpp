#include <cmath>

#include "geometry/angles.h"
#include "io/sheet.h"
#include "io/text.h"

namespace toile {

namespace {

/// Ten nanometres, in millimetres.
constexpr int decimals = 5;

std::string millimetres(double metres) {
  std::string text = fixed_number(metres * 1000, decimals);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

class SvgWriter {
 public:
  explicit SvgWriter(const Sheet& sheet) : sheet_(sheet) {}

  std::string write() {
    head();
    for (std::size_t i = 0; i < sheet_.parts.size(); ++i) part(sheet_.parts[i], i);
    if (sheet_.scale_bar) scale_bar(*sheet_.scale_bar);
    text_ += "</svg>\n";
    return std::move(text_);
  }

 private:
  void head() {
    const std::string width = millimetres(sheet_.size.x());
    const std::string height = millimetres(sheet_.size.y());
    text_ += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    text_ +=
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"\n"
        "     xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n";
    text_ += "     width=\"" + width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width +
             " " + height + "\">\n";
    text_ += "<title>" + html_escaped(sheet_.title) + "</title>\n<style>\n";
    text_ += "path { fill: none; stroke: #222; stroke-linejoin: round }\n";
    text_ += "text { font-family: sans-serif; fill: #222; text-anchor: middle }\n";
    for (const SheetStyle& style : sheet_.styles) {
      if (style.css_class.empty()) continue;
      std::string selector;
      for (const char c : "." + style.css_class) selector += c == ' ' ? '.' : c;
      text_ += selector + " { stroke-width: " + millimetres(style.width) +
               (style.dashed ? "; stroke-dasharray: 4 2" : "; stroke-dasharray: none") + " }\n";
    }
    text_ += "</style>\n<defs>\n";
    text_ +=
        "<marker id=\"grainlineFrom\" orient=\"auto\" markerUnits=\"userSpaceOnUse\" "
        "markerWidth=\"20\" markerHeight=\"10\" style=\"overflow:visible\">"
        "<path d=\"M 0,0 L 7,-2.5 L 7,2.5 z\" style=\"fill:#222;stroke:none\"/></marker>\n"
        "<marker id=\"grainlineTo\" orient=\"auto\" markerUnits=\"userSpaceOnUse\" "
        "markerWidth=\"20\" markerHeight=\"10\" style=\"overflow:visible\">"
        "<path d=\"M 0,0 L -7,-2.5 L -7,2.5 z\" style=\"fill:#222;stroke:none\"/></marker>\n";
    text_ += "<g id=\"notch\"><path style=\"stroke-width:0.6\" d=\"M 0,0 L " +
             millimetres(notch_length) + ",0\"/></g>\n";
    text_ +=
        "<g id=\"drill-hole\"><path style=\"stroke-width:0.4\" d=\"M -2,0 L 2,0 M 0,-2 L "
        "0,2\"/></g>\n</defs>\n";
  }

  std::string point(const Vec2& metres) const {
    return millimetres(metres.x()) + "," + millimetres(sheet_.size.y() - metres.y());
  }

  std::string data(const DrawnPath& path) const {
    std::string text = "M " + point(path.start);
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
      const DrawnSegment& segment = path.segments[i];
      // The last line of a closed path is what z draws.
      if (path.closed && !segment.curved && i + 1 == path.segments.size()) continue;
      text += segment.curved ? " C " + point(segment.control1) + " " + point(segment.control2) +
                                   " " + point(segment.end)
                             : " L " + point(segment.end);
    }
    return path.closed ? text + " z" : text;
  }

  void part(const SheetPart& part, std::size_t number) {
    const std::string name = html_escaped(part.name);
    text_ += "<g id=\"part-" + std::to_string(number) + "\" inkscape:label=\"" + name + "\">\n";
    for (const SheetPath& path : part.paths) {
      const SheetStyle& style = sheet_.styles[static_cast<std::size_t>(path.style)];
      if (style.css_class.empty()) continue;
      text_ += "<path class=\"" + style.css_class + "\"";
      if (path.path.closed) text_ += " inkscape:label=\"" + name + "\"";
      if (style.arrows) {
        text_ += " marker-start=\"url(#grainlineFrom)\" marker-end=\"url(#grainlineTo)\"";
      }
      text_ += " d=\"" + data(path.path) + "\"/>\n";
    }
    for (const SheetMark& mark : part.marks) {
      if (mark.sign == SheetMark::Sign::none) continue;
      const double turn = mark.angle ? to_degrees(-*mark.angle) : 0;
      text_ += std::string("<use xlink:href=\"#") +
               (mark.sign == SheetMark::Sign::notch ? "notch" : "drill-hole") +
               "\" transform=\"translate(" + point(mark.at) + ") rotate(" + fixed_number(turn, 4) +
               ")\"/>\n";
    }
    for (const SheetText& text : part.texts) write_text(text);
    text_ += "</g>\n";
  }

  void write_text(const SheetText& text) {
    // The base line of a text lies a third of its height below its middle.
    const double drop = 0.35 * text.height;
    const Vec2 base = text.at + drop * Vec2(std::sin(text.angle), -std::cos(text.angle));
    text_ += "<text font-size=\"" + millimetres(text.height) + "\" transform=\"translate(" +
             point(base) + ")";
    if (text.angle != 0) {
      text_ += " rotate(" + fixed_number(to_degrees(-text.angle), 3) + ")";
    }
    text_ += "\">" + html_escaped(text.text) + "</text>\n";
  }

  void scale_bar(const Vec2& start) {
    DrawnPath bar;
    const Vec2 end = start + Vec2(scale_bar_length, 0);
    const Vec2 tick(0, 2e-3);
    bar.start = start + tick;
    for (const Vec2& to : {Vec2(start - tick), start, end, Vec2(end + tick), Vec2(end - tick)}) {
      bar.segments.push_back(DrawnSegment::line(to));
    }
    text_ += "<path class=\"scalebox\" style=\"stroke-width:0.3\" d=\"" + data(bar) + "\"/>\n";
    write_text({"10 cm", (start + end) / 2 + Vec2(0, 4e-3), 4e-3, 0});
  }

  const Sheet& sheet_;
  std::string text_;
};

}  // namespace

std::string sheet_svg(const Sheet& sheet) { return SvgWriter(sheet).write(); }

}  // namespace toile
