// An SVG file as a tree of elements: parsed, checked, and asked for ids, styles and sizes.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "geometry/types.h"
#include "io/svg_style.h"

namespace toile {

/// A view box, in user units.
struct SvgBox {
  Vec2 corner;
  Vec2 size;
};

/// How large a drawing is.
struct SvgSize {
  Vec2 frame = Vec2::Zero();            ///< user units: what percentages are of
  Vec2 metres_per_unit = Vec2::Zero();  ///< across and down
  bool physical = false;  ///< width or height are stated in a unit of length, not in pixels
};

/// The parsed file. Elements are its own, and know their place in it.
class SvgDocument {
 public:
  /// `name` stands for the file in messages. Throws Error for malformed XML, for another outermost
  /// element than svg, and for entities made of others or of other files. Throws it beyond
  /// max_svg_bytes, max_svg_depth and max_svg_elements.
  SvgDocument(std::string_view text, const std::string& name);

  pugi::xml_node root() const { return document_.document_element(); }

  /// The name of an SVG element without its prefix; empty for elements of other kinds.
  std::string_view local_name(const pugi::xml_node& node) const;

  /// The first element of this id; a null node: there is none.
  pugi::xml_node find(const std::string& id) const;

  int line(const pugi::xml_node& node) const;  ///< of the file, from 1

  /// File, line, element and id, for messages.
  std::string place(const pugi::xml_node& node) const;

  /// What the style of an element says, else a style sheet, else an attribute; empty: nothing.
  std::string property(const pugi::xml_node& node, const char* name,
                       const std::vector<std::string>& classes) const;

  /// The view box of an element; none: it has none. Throws Error for one without size.
  std::optional<SvgBox> view_box(const pugi::xml_node& node) const;

  /// The size of the drawing by width, height and viewBox; pixels have 96 an inch. Throws Error for
  /// widths and heights that are not above 0.
  SvgSize size() const;

 private:
  /// Numbers lines by their offsets in the text.
  class Lines {
   public:
    explicit Lines(std::string_view text);
    int at(std::ptrdiff_t offset) const;

   private:
    std::vector<std::size_t> ends_;
  };

  void load(std::string_view text);
  void refuse_entities(std::string_view doctype) const;
  void survey();

  std::string name_;
  Lines lines_;
  pugi::xml_document document_;
  std::string prefix_;  ///< of the file's SVG elements, with its colon; empty: none
  std::unordered_map<std::string, pugi::xml_node> by_id_;
  SvgStyleSheet sheet_;
};

}  // namespace toile
