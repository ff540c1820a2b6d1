#include "io/svg_document.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "geometry/error.h"
#include "io/svg.h"
#include "io/svg_scanner.h"
#include "io/svg_transform.h"
#include "io/text.h"

namespace toile {

namespace {

/// User units: the frame of a drawing that states no size, as browsers have it.
const Vec2 default_frame(300, 150);

constexpr double metres_per_pixel = 0.0254 / 96;

}  // namespace

SvgDocument::Lines::Lines(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') ends_.push_back(i);
  }
}

int SvgDocument::Lines::at(std::ptrdiff_t offset) const {
  const auto before = std::lower_bound(
      ends_.begin(), ends_.end(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
  return static_cast<int>(before - ends_.begin()) + 1;
}

SvgDocument::SvgDocument(std::string_view text, const std::string& name)
    : name_(name), lines_(text) {
  load(text);
  const std::string_view tag = root().name();
  const std::size_t colon = tag.find(':');
  if (colon != std::string_view::npos) prefix_ = std::string(tag.substr(0, colon + 1));
  if (local_name(root()) != "svg") {
    throw Error(name_, "is no SVG: its outermost element is '" + shown_text(tag) + "'",
                "export the drawing as SVG");
  }
  survey();
}

void SvgDocument::load(std::string_view text) {
  if (text.size() > max_svg_bytes) {
    throw Error(name_, "is larger than 256 MB", "is it really a pattern?");
  }
  const pugi::xml_parse_result done =
      document_.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_doctype);
  if (!done) {
    std::string problem = done.description();
    problem[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(problem[0])));
    throw Error(name_ + ":" + std::to_string(lines_.at(done.offset)), "is no XML: " + problem,
                "save the drawing again");
  }
  for (const pugi::xml_node child : document_.children()) {
    if (child.type() == pugi::node_doctype) refuse_entities(child.value());
  }
}

/// No entity is ever replaced. Plain ones, as Illustrator declares them, do no harm then; a file
/// with others means something else than what would be read.
void SvgDocument::refuse_entities(std::string_view doctype) const {
  std::size_t at = 0;
  while ((at = doctype.find("<!ENTITY", at)) != std::string_view::npos) {
    const std::size_t end = std::min(doctype.find('>', at), doctype.size());
    const std::string_view entity = doctype.substr(at, end - at);
    if (entity.find_first_of("&%") != std::string_view::npos ||
        entity.find("SYSTEM") != std::string_view::npos ||
        entity.find("PUBLIC") != std::string_view::npos) {
      throw Error(name_, "declares entities that are made of others or lie outside of the file",
                  "save the drawing as plain SVG");
    }
    at = end;
  }
}

/// Ids, style sheets, and how deep elements lie: before anything recurses.
void SvgDocument::survey() {
  struct Survey : pugi::xml_tree_walker {
    SvgDocument* of = nullptr;
    int count = 0;
    bool for_each(pugi::xml_node& node) override {
      if (node.type() != pugi::node_element) return true;
      if (depth() > max_svg_depth) {
        throw Error(of->place(node),
                    "lies more than " + std::to_string(max_svg_depth) + " elements deep",
                    "ungroup the drawing");
      }
      if (++count > max_svg_elements) {
        throw Error(of->name_, "has more than 500,000 elements", "is it really a pattern?");
      }
      if (const auto id = node.attribute("id")) of->by_id_.try_emplace(id.value(), node);
      if (of->local_name(node) == "style") {
        for (const pugi::xml_node part : node.children()) of->sheet_.add(part.value());
      }
      return true;
    }
  } survey;
  survey.of = this;
  document_.traverse(survey);
}

std::string_view SvgDocument::local_name(const pugi::xml_node& node) const {
  std::string_view tag = node.name();
  if (!prefix_.empty() && tag.starts_with(prefix_)) return tag.substr(prefix_.size());
  if (tag.starts_with("svg:")) return tag.substr(4);
  return tag.find(':') == std::string_view::npos && prefix_.empty() ? tag : std::string_view();
}

pugi::xml_node SvgDocument::find(const std::string& id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? pugi::xml_node() : found->second;
}

int SvgDocument::line(const pugi::xml_node& node) const { return lines_.at(node.offset_debug()); }

std::string SvgDocument::place(const pugi::xml_node& node) const {
  std::string text = name_ + ":" + std::to_string(line(node)) + ": " + node.name();
  if (const auto id = node.attribute("id")) text += " '" + shown_text(id.value()) + "'";
  return text;
}

std::string SvgDocument::property(const pugi::xml_node& node, const char* name,
                                  const std::vector<std::string>& classes) const {
  if (const auto style = node.attribute("style")) {
    if (const auto value = declared(style.value(), name)) return *value;
  }
  if (const auto value =
          sheet_.find(name, local_name(node), node.attribute("id").value(), classes)) {
    return *value;
  }
  return node.attribute(name).value();
}

std::optional<SvgBox> SvgDocument::view_box(const pugi::xml_node& node) const {
  const auto given = node.attribute("viewBox");
  if (!given) return std::nullopt;
  const std::string where = place(node);
  SvgScanner scanner(given.value(), where);
  std::array<double, 4> values{};
  for (double& value : values) value = scanner.number();
  if (!(values[2] > 0) || !(values[3] > 0) || !scanner.at_end()) {
    throw Error(where, "its viewBox '" + shown_text(given.value()) + "' has no size",
                "give it four numbers, the last two above 0");
  }
  return SvgBox{{values[0], values[1]}, {values[2], values[3]}};
}

SvgSize SvgDocument::size() const {
  const std::string where = place(root());
  const auto box = view_box(root());
  SvgSize size;
  size.frame = box ? box->size : default_frame;
  Vec2 pixels = size.frame;
  bool stated = false;
  const std::array<const char*, 2> names = {"width", "height"};
  for (int k = 0; k < 2; ++k) {
    const std::string_view text = root().attribute(names[static_cast<std::size_t>(k)]).value();
    // A share of the window is no size.
    if (text.empty() || text == "auto" || text.find('%') != std::string_view::npos) continue;
    const double length = svg_length(text, 0, where);
    if (!(length > 0)) {
      throw Error(where,
                  "its " + std::string(names[static_cast<std::size_t>(k)]) + " is not above 0",
                  "correct it");
    }
    // One of the two gives the other by the proportions of the view box.
    if (box && !stated) pixels *= length / pixels[k];
    pixels[k] = length;
    if (!box && !stated) pixels[1 - k] = length;
    stated = true;
    if (svg_physical_length(text)) size.physical = true;
  }
  size.metres_per_unit = Vec2(metres_per_pixel, metres_per_pixel);
  if (box) {
    const PlaneTransform view = svg_view_transform(
        box->corner, box->size, pixels, root().attribute("preserveAspectRatio").value(), where);
    size.metres_per_unit = metres_per_pixel * Vec2(view.matrix()(0, 0), view.matrix()(1, 1));
  } else if (stated) {
    size.frame = pixels;
  }
  return size;
}

}  // namespace toile
