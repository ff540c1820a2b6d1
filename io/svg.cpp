#include "io/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <pugixml.hpp>

#include "geometry/error.h"
#include "io/limits.h"
#include "io/svg_document.h"
#include "io/svg_path_data.h"
#include "io/svg_scanner.h"
#include "io/svg_style.h"
#include "io/svg_transform.h"
#include "io/text.h"

namespace toile {

namespace {

/// Of segments of all paths, copies by `use` counted.
constexpr std::size_t max_segments = 4'000'000;

template <class Names>
bool is_one_of(std::string_view name, const Names& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::array<std::string_view, 7> shape_elements = {"path", "rect",     "circle", "ellipse",
                                                            "line", "polyline", "polygon"};
constexpr std::array<std::string_view, 5> group_elements = {"g", "svg", "a", "switch", "symbol"};
/// What has no outline of its own and takes nothing from the drawing where it is left out.
constexpr std::array<std::string_view, 15> silent_elements = {
    "defs", "clipPath", "mask", "marker",         "pattern",        "symbol", "style", "title",
    "desc", "metadata", "view", "linearGradient", "radialGradient", "filter", "font"};

/// "#id" as id; nothing for other references.
std::string local_reference(std::string_view text) {
  const std::size_t hash = text.find('#');
  if (hash != 0 || text.size() < 2) return "";
  return std::string(text.substr(1));
}

/// The id in "url(#id)"; empty for others.
std::string url_reference(std::string_view text) {
  const std::size_t start = text.find("url(");
  if (start == std::string_view::npos) return "";
  text.remove_prefix(start + 4);
  std::string inner(text.substr(0, text.find(')')));
  std::erase_if(inner, [](char c) { return c == '\'' || c == '"' || c == ' '; });
  return local_reference(inner);
}

class SvgReader {
 public:
  SvgReader(std::string_view text, const std::string& name) : document_(text, name) {}

  SvgDrawing read() {
    const pugi::xml_node root = document_.root();
    for (const pugi::xml_attribute attribute : root.attributes()) {
      if (std::string_view(attribute.name()).starts_with("xmlns")) {
        drawing_.namespaces.emplace_back(attribute.value());
      }
    }
    const SvgSize size = document_.size();
    drawing_.metres_per_unit = size.metres_per_unit;
    drawing_.physical = size.physical;
    State state;
    state.frame = size.frame;
    const auto hidden = property(root, "display", split_words(root.attribute("class").value()));
    if (hidden != "none") {
      if (const auto given = root.attribute("transform")) {
        state.to_root = svg_transform(given.value(), place(root));
      }
      for (const pugi::xml_node child : root.children()) draw(child, state);
    }
    return std::move(drawing_);
  }

 private:
  struct State {
    PlaneTransform to_root = PlaneTransform::Identity();
    Vec2 frame = Vec2::Zero();  ///< what percentages are of
    bool visible = true;
    int group = -1;
    int use = -1;
    int depth = 0;
  };

  std::string_view local_name(const pugi::xml_node& node) const {
    return document_.local_name(node);
  }
  std::string place(const pugi::xml_node& node) const { return document_.place(node); }
  std::string property(const pugi::xml_node& node, const char* name,
                       const std::vector<std::string>& classes) const {
    return document_.property(node, name, classes);
  }

  double length(const pugi::xml_node& node, const char* name, double whole,
                double otherwise) const {
    const auto given = node.attribute(name);
    return given ? svg_length(given.value(), whole, place(node)) : otherwise;
  }
  Vec2 point(const pugi::xml_node& node, const char* x, const char* y, const State& state) const {
    return {length(node, x, state.frame.x(), 0), length(node, y, state.frame.y(), 0)};
  }

  static std::string label_of(const pugi::xml_node& node) {
    return valid_utf8(node.attribute("inkscape:label").value());
  }

  std::string title_of(const pugi::xml_node& node) const {
    for (const pugi::xml_node child : node.children()) {
      if (local_name(child) == "title") return text_of(child);
    }
    return "";
  }

  void append_text(std::string& text, const pugi::xml_node& node) const {
    for (const pugi::xml_node child : node.children()) {
      if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
        text += child.value();
      } else if (local_name(child) == "tspan" || local_name(child) == "textPath" ||
                 local_name(child) == "a") {
        append_text(text, child);
        text += ' ';
      }
    }
  }

  std::string text_of(const pugi::xml_node& node) const {
    std::string all;
    append_text(all, node);
    std::string text;
    for (const std::string& word : split_words(all)) text += (text.empty() ? "" : " ") + word;
    return valid_utf8(text);
  }

  void draw(const pugi::xml_node& node, State state) {
    if (node.type() != pugi::node_element) return;
    const std::string_view element = local_name(node);
    if (element.empty() || is_one_of(element, silent_elements)) return;
    draw_as(node, element, state);
  }

  /// Draws a symbol, too: what a `use` refers to.
  void draw_as(const pugi::xml_node& node, std::string_view element, State state) {
    if (++state.depth > 2 * max_svg_depth) {
      throw Error(place(node), "lies more than 400 elements deep, uses counted",
                  "unlink the clones");
    }
    if (++drawn_ > max_svg_elements) {
      throw Error(place(node), "with it more than 500,000 elements are drawn",
                  "does a <use> draw copies of copies?");
    }
    std::vector<std::string> classes = split_words(node.attribute("class").value());
    if (property(node, "display", classes) == "none") return;
    const std::string visibility = property(node, "visibility", classes);
    if (!visibility.empty() && visibility != "inherit") state.visible = visibility == "visible";
    if (const auto given = node.attribute("transform")) {
      state.to_root = state.to_root * svg_transform(given.value(), place(node));
    }
    for (std::string& name : classes) name = valid_utf8(name);
    if (is_one_of(element, group_elements)) {
      group(node, element, std::move(classes), state);
    } else if (element == "use") {
      use(node, state);
    } else if (!state.visible) {
      return;
    } else if (is_one_of(element, shape_elements)) {
      shape(node, element, std::move(classes), state);
    } else if (element == "text") {
      text(node, std::move(classes), state);
    } else {
      ++drawing_.ignored[shown_text(element)];
    }
  }

  void group(const pugi::xml_node& node, std::string_view element, std::vector<std::string> classes,
             State state) {
    if (element == "svg") {
      state.to_root = state.to_root * Eigen::Translation2d(point(node, "x", "y", state));
      const Vec2 frame(length(node, "width", state.frame.x(), state.frame.x()),
                       length(node, "height", state.frame.y(), state.frame.y()));
      if (!enter_view(node, frame, state)) return;
    }
    drawing_.groups.push_back({state.group, valid_utf8(node.attribute("id").value()),
                               label_of(node), title_of(node), std::move(classes)});
    state.group = static_cast<int>(drawing_.groups.size()) - 1;
    for (const pugi::xml_node child : node.children()) draw(child, state);
  }

  /// False for a frame without a size: nothing is drawn in it.
  bool enter_view(const pugi::xml_node& node, const Vec2& frame, State& state) const {
    if (!(frame.minCoeff() > 0)) return false;
    state.frame = frame;
    if (const auto box = document_.view_box(node)) {
      state.to_root =
          state.to_root * svg_view_transform(box->corner, box->size, frame,
                                             node.attribute("preserveAspectRatio").value(),
                                             place(node));
      state.frame = box->size;
    }
    return true;
  }

  static std::string_view href_of(const pugi::xml_node& node) {
    for (const pugi::xml_attribute attribute : node.attributes()) {
      const std::string_view name = attribute.name();
      if (name == "href" || name.ends_with(":href")) return attribute.value();
    }
    return "";
  }

  void use(const pugi::xml_node& node, State state) {
    const std::string target = local_reference(href_of(node));
    const pugi::xml_node drawn = document_.find(target);
    if (!drawn) {
      ++drawing_.ignored["use of what is not in the file"];
      return;
    }
    if (std::find(in_use_.begin(), in_use_.end(), drawn) != in_use_.end() ||
        is_within(node, drawn)) {
      throw Error(place(node), "draws '" + shown_text(target) + "', which draws itself by it",
                  "remove the <use>");
    }
    state.to_root = state.to_root * Eigen::Translation2d(point(node, "x", "y", state));
    if (state.use < 0) {
      drawing_.uses.push_back({valid_utf8(target), checked(state.to_root * Vec2(0, 0), node),
                               state.to_root.linear().col(0), state.group});
      state.use = static_cast<int>(drawing_.uses.size()) - 1;
    }
    const std::string_view element = local_name(drawn);
    if (element == "symbol") {
      const Vec2 frame(length(node, "width", state.frame.x(), state.frame.x()),
                       length(node, "height", state.frame.y(), state.frame.y()));
      if (!enter_view(drawn, frame, state)) return;
    }
    in_use_.push_back(drawn);
    if (element == "symbol") {
      draw_as(drawn, element, state);
    } else {
      draw(drawn, state);
    }
    in_use_.pop_back();
  }

  static bool is_within(pugi::xml_node node, const pugi::xml_node& ancestor) {
    for (; node; node = node.parent()) {
      if (node == ancestor) return true;
    }
    return false;
  }

  /// Counts bytes that are read, each time that a `use` has them read again.
  std::string_view counted(const char* text, const pugi::xml_node& node) {
    const std::string_view bytes = text;
    read_ += bytes.size();
    if (read_ > max_svg_bytes) {
      throw Error(place(node), "with it more than 256 MiB are drawn",
                  "does a <use> draw copies of copies?");
    }
    return bytes;
  }

  /// The paths of an element that has no list of points.
  std::vector<DrawnPath> paths_of(const pugi::xml_node& node, std::string_view element,
                                  const State& state) {
    if (element == "line") {
      DrawnPath path;
      path.start = point(node, "x1", "y1", state);
      path.segments = {DrawnSegment::line(point(node, "x2", "y2", state))};
      return {path};
    }
    const double diagonal = state.frame.norm() / std::sqrt(2.0);
    if (element == "circle") {
      const double radius = length(node, "r", diagonal, 0);
      if (!(radius > 0)) return {};
      return {svg_ellipse(point(node, "cx", "cy", state), {radius, radius})};
    }
    const bool rectangle = element == "rect";
    const double rx = length(node, "rx", state.frame.x(), -1);
    const double ry = length(node, "ry", state.frame.y(), -1);
    Vec2 radii(rx < 0 ? ry : rx, ry < 0 ? rx : ry);
    if (rectangle) {
      const Vec2 size = point(node, "width", "height", state);
      if (!(size.minCoeff() > 0)) return {};
      return {svg_rectangle(point(node, "x", "y", state), size, radii)};
    }
    if (!(radii.minCoeff() > 0)) return {};
    return {svg_ellipse(point(node, "cx", "cy", state), radii)};
  }

  /// As paths_of(), of all elements. What can't be read of a list of points is kept in the shape.
  std::vector<DrawnPath> readable_paths(const pugi::xml_node& node, std::string_view element,
                                        const State& state, SvgShape& shape) {
    const bool path = element == "path";
    if (!path && element != "polyline" && element != "polygon") {
      return paths_of(node, element, state);
    }
    const std::string_view data = counted(node.attribute(path ? "d" : "points").value(), node);
    try {
      return path ? svg_path_data(data, place(node))
                  : svg_polygon(data, element == "polygon", place(node));
    } catch (const Error& error) {
      shape.unreadable = error;
      return {};
    }
  }

  Vec2 checked(const Vec2& point, const pugi::xml_node& node) const {
    for (const double value : {point.x(), point.y()}) {
      const std::string problem = coordinate_problem(value);
      if (!problem.empty()) throw Error(place(node), problem, coordinate_remedy);
    }
    return point;
  }

  std::string marker(const pugi::xml_node& node, const char* name) const {
    if (const auto style = node.attribute("style")) {
      if (const auto value = declared(style.value(), name)) return url_reference(*value);
    }
    return url_reference(node.attribute(name).value());
  }

  void shape(const pugi::xml_node& node, std::string_view element, std::vector<std::string> classes,
             const State& state) {
    SvgShape shape;
    shape.element = std::string(element);
    for (const DrawnPath& path : readable_paths(node, element, state, shape)) {
      shape.paths.push_back(transformed(path, state.to_root));
      const DrawnPath& moved = shape.paths.back();
      checked(moved.start, node);
      for (const DrawnSegment& segment : moved.segments) {
        checked(segment.control1, node);
        checked(segment.control2, node);
        checked(segment.end, node);
      }
      segments_ += moved.segments.size();
      if (segments_ > max_segments) {
        throw Error(place(node), "with it the drawing has more than 4,000,000 segments",
                    "does a <use> draw copies of copies?");
      }
    }
    if (shape.paths.empty() && !shape.unreadable) return;
    shape.id = valid_utf8(node.attribute("id").value());
    shape.label = label_of(node);
    shape.title = title_of(node);
    shape.classes = std::move(classes);
    shape.marker_start = marker(node, "marker-start");
    shape.marker_end = marker(node, "marker-end");
    shape.group = state.group;
    shape.use = state.use;
    shape.line = document_.line(node);
    drawing_.shapes.push_back(std::move(shape));
  }

  void text(const pugi::xml_node& node, std::vector<std::string> classes, const State& state) {
    SvgText text;
    text.text = text_of(node);
    if (text.text.empty()) return;
    counted(text.text.c_str(), node);
    pugi::xml_node placed = node;
    for (const pugi::xml_node child : node.children()) {
      if (local_name(child) == "textPath") text.on_path = local_reference(href_of(child));
      if (local_name(child) == "tspan" && !placed.attribute("x")) placed = child;
    }
    // x and y may list a place for each letter: the first counts.
    const auto first = [&](const char* name) {
      SvgScanner scanner(placed.attribute(name).value(), place(placed));
      return scanner.at_number() ? scanner.number() : 0.0;
    };
    text.at = checked(state.to_root * Vec2(first("x"), first("y")), node);
    text.classes = std::move(classes);
    text.group = state.group;
    drawing_.texts.push_back(std::move(text));
  }

  SvgDocument document_;
  SvgDrawing drawing_;
  std::vector<pugi::xml_node> in_use_;
  int drawn_ = 0;
  std::size_t segments_ = 0;
  std::size_t read_ = 0;  // bytes of paths and texts, copies counted
};

}  // namespace

SvgDrawing parse_svg(std::string_view text, const std::string& name) {
  return SvgReader(text, name).read();
}

}  // namespace toile
